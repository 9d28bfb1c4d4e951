#pragma once

#include <string>
#include <vector>

class vtkSMProxy;

/// What a filter states in its first output's field data, under its name: "Seed" is
/// PasteFeature.Seed of Shape Paste Feature; empty where it says nothing.
namespace pqShapeFacts
{

std::vector<double> GetNumbers(vtkSMProxy* filter, const std::string& name);
std::string GetText(vtkSMProxy* filter, const std::string& name);

} // namespace pqShapeFacts
