#include "vtkShapeLargeSize.h"

#include "vtkBoundingBox.h"
#include "vtkPolyData.h"

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

/// Points that no cell uses do not count, unless there are no cells.
vtkBoundingBox BoxOfCells(vtkPolyData* surface)
{
  double bounds[6];
  if (surface->GetNumberOfCells() == 0)
  {
    surface->GetBounds(bounds);
  }
  else
  {
    surface->GetCellsBounds(bounds);
  }
  return vtkBoundingBox(bounds);
}

} // namespace

std::string vtkShapeLargeSize::CheckCellSize(
  const std::string& property, double value, vtkPolyData* surface)
{
  return Check(property, value, BoxOfCells(surface).GetMaxLength() / 4.0,
    "a quarter of the longest side of the surface", "0 for an automatic one");
}

std::string vtkShapeLargeSize::CheckRadius(
  const std::string& property, double value, vtkPolyData* surface)
{
  return Check(property, value, BoxOfCells(surface).GetDiagonalLength(),
    "the diagonal of the surface", "0 for an automatic one");
}

std::string vtkShapeLargeSize::CheckCellVolume(
  const std::string& property, double value, double solid)
{
  return Check(property, value, solid, "the volume of the solid", "0 for no bound");
}
