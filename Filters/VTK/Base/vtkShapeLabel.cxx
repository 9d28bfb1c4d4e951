#include "vtkShapeLabel.h"

#include <cctype>

std::string vtkShapeLabel::Of(const std::string& className)
{
  const auto isUpper = [&](std::size_t i)
  { return i < className.size() && std::isupper(static_cast<unsigned char>(className[i])); };
  std::string label;
  // Without "vtk". An abbreviation is one word: OFFReader is "OFF Reader".
  for (std::size_t i = 3; i < className.size(); ++i)
  {
    const bool nextIsLower = i + 1 < className.size() && !isUpper(i + 1);
    if (i > 3 && isUpper(i) && (!isUpper(i - 1) || nextIsLower))
    {
      label += ' ';
    }
    label += className[i];
  }
  return label;
}
