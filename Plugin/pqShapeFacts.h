#pragma once

#include <string>
#include <vector>

class vtkSMProxy;

/// Reads facts from the field data of a filter's first output, by their names without the prefix:
/// "Seed" is PasteFeature.Seed of Shape Paste Feature. Returns nothing if the fact is absent.
namespace pqShapeFacts
{

std::vector<double> GetNumbers(vtkSMProxy* filter, const std::string& name);
std::string GetText(vtkSMProxy* filter, const std::string& name);

} // namespace pqShapeFacts
