#include "vtkShapeLargeSize.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"

#include <sstream>

namespace
{

std::string Check(const std::string& property, double value, double maximum,
  const std::string& maximumName, const std::string& remedy)
{
  if (value <= maximum)
  {
    return "";
  }
  std::ostringstream text;
  text << property << ' ' << value << " is more than " << maximumName << " (" << maximum
       << "); use a smaller value, or " << remedy;
  return text.str();
}

} // namespace

std::string vtkShapeLargeSize::CheckCellSize(
  const std::string& property, double value, vtkDataSet* surface)
{
  return Check(property, value, vtkBoundingBox(surface->GetBounds()).GetMaxLength() / 4.0,
    "a quarter of the longest side of the surface", "0 for an automatic one");
}

std::string vtkShapeLargeSize::CheckRadius(
  const std::string& property, double value, vtkDataSet* surface)
{
  return Check(property, value, vtkBoundingBox(surface->GetBounds()).GetDiagonalLength(),
    "the diagonal of the surface", "0 for an automatic one");
}

std::string vtkShapeLargeSize::CheckCellVolume(
  const std::string& property, double value, double solid)
{
  return Check(property, value, solid, "the volume of the solid", "0 for no bound");
}
