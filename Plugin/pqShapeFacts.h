#pragma once

#include <string>
#include <vector>

class vtkSMProxy;

/// Reads facts from the output Facts of a filter, a table. `name` is the name of the fact
/// without the prefix: "Seed" is PasteFeature.Seed of Shape Paste Feature. If there is no such
/// fact, the result is empty.
namespace pqShapeFacts
{

std::vector<double> GetNumbers(vtkSMProxy* filter, const std::string& name);
std::string GetText(vtkSMProxy* filter, const std::string& name);
std::vector<std::string> GetNames(vtkSMProxy* filter); ///< of all facts

} // namespace pqShapeFacts
