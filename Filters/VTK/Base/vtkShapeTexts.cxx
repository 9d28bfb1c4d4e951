#include "vtkShapeTexts.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <numeric>
#include <sstream>

std::vector<std::string> vtkShapeTexts::GatherOnce(
  vtkMultiProcessController* controller, const std::vector<std::string>& texts)
{
  std::string own;
  for (const std::string& text : texts)
  {
    own.append(text.c_str(), text.size() + 1);
  }
  std::string all = own;
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const int processes = controller->GetNumberOfProcesses();
    const auto size = static_cast<vtkIdType>(own.size());
    std::vector<vtkIdType> sizes(processes), offsets(processes);
    controller->AllGather(&size, sizes.data(), 1);
    std::partial_sum(sizes.begin(), sizes.end() - 1, offsets.begin() + 1);
    all.resize(offsets.back() + sizes.back());
    controller->AllGatherV(own.data(), all.data(), size, sizes.data(), offsets.data());
  }
  std::vector<std::string> once;
  std::istringstream stream(all);
  for (std::string text; std::getline(stream, text, '\0');)
  {
    if (std::find(once.begin(), once.end(), text) == once.end())
    {
      once.push_back(text);
    }
  }
  return once;
}
