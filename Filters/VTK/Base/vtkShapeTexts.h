#pragma once

#include <string>
#include <vector>

class vtkMultiProcessController;

/// Texts of several processes.
namespace vtkShapeTexts
{

/// Returns the texts of all processes, each once, in the order of the processes: the same on every
/// process. Collective: all processes must call it. A text must not contain a null character.
std::vector<std::string> GatherOnce(
  vtkMultiProcessController* controller, const std::vector<std::string>& texts);

} // namespace vtkShapeTexts
