#include "vtkShapeRegions.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"

Eigen::MatrixXi vtkShapeRegions::Read(
  vtkPolyData* surface, Eigen::Index triangles, const std::string& name)
{
  vtkDataArray* regions = surface->GetCellData()->GetArray("Regions");
  if (!regions)
  {
    return {};
  }
  if (regions->GetNumberOfComponents() != 2)
  {
    throw shape::InvalidInput("the cell array Regions has " +
      std::to_string(regions->GetNumberOfComponents()) +
      " components, not the 2 labels on the sides of each triangle; rename it");
  }
  if (surface->GetNumberOfCells() != triangles || regions->GetNumberOfTuples() != triangles)
  {
    throw shape::InvalidInput(
      name + " has the cell array Regions, but cells that are not triangles; apply Triangulate");
  }
  Eigen::MatrixXi labels(triangles, 2);
  for (Eigen::Index t = 0; t < triangles; ++t)
  {
    for (int side = 0; side < 2; ++side)
    {
      labels(t, side) = static_cast<int>(regions->GetComponent(t, side));
    }
  }
  return labels;
}

void vtkShapeRegions::RequireNoneTouch(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* regions = surface->GetCellData()->GetArray("Regions");
  vtkIdType touching = 0;
  for (vtkIdType t = 0;
       regions && regions->GetNumberOfComponents() == 2 && t < regions->GetNumberOfTuples(); ++t)
  {
    touching += regions->GetComponent(t, 0) != 0.0 && regions->GetComponent(t, 1) != 0.0 ? 1 : 0;
  }
  if (touching > 0)
  {
    throw shape::InvalidInput(name + " has regions that touch: " + std::to_string(touching) +
      " triangles of its cell array Regions lie between two of them, but only closed surfaces that "
      "do not touch can bound regions; extract the triangles where a label of Regions is 0");
  }
}
