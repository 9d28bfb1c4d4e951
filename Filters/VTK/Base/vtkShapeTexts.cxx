#include "vtkShapeTexts.h"

#include "vtkShapeConcatenate.h"

#include <algorithm>
#include <sstream>

std::vector<std::string> vtkShapeTexts::GatherOnce(
  vtkMultiProcessController* controller, const std::vector<std::string>& texts)
{
  std::string own;
  for (const std::string& text : texts)
  {
    own.append(text.c_str(), text.size() + 1);
  }
  std::vector<vtkIdType> offsets;
  std::vector<std::string> once;
  std::istringstream stream(vtkShapeConcatenate::Concatenate(controller, own, offsets));
  for (std::string text; std::getline(stream, text, '\0');)
  {
    if (std::find(once.begin(), once.end(), text) == once.end())
    {
      once.push_back(text);
    }
  }
  return once;
}
