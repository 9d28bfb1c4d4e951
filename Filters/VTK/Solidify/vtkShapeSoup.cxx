#include "vtkShapeSoup.h"

#include "vtkShapeConvert.h"

#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <vector>

namespace
{

/// Appends the triangles of a polygon. If it cannot be triangulated, they are those around its
/// first corner.
void AddPolygon(vtkIdList* corners, vtkPoints* points, std::vector<std::array<int, 3>>& triangles)
{
  const vtkIdType count = corners->GetNumberOfIds();
  vtkNew<vtkIdList> parts;
  if (count > 3)
  {
    vtkNew<vtkPolygon> polygon;
    polygon->PointIds->DeepCopy(corners);
    points->GetPoints(corners, polygon->Points);
    polygon->Triangulate(parts);
  }
  if (parts->GetNumberOfIds() != 3 * (count - 2))
  {
    parts->Reset();
    for (vtkIdType k = 1; k + 1 < count; ++k)
    {
      parts->InsertNextId(0);
      parts->InsertNextId(k);
      parts->InsertNextId(k + 1);
    }
  }
  for (vtkIdType i = 0; i + 2 < parts->GetNumberOfIds(); i += 3)
  {
    const auto corner = [&](vtkIdType k)
    { return static_cast<int>(corners->GetId(parts->GetId(i + k))); };
    triangles.push_back({ corner(0), corner(1), corner(2) });
  }
}

/// Appends the triangles of a strip, every second of which runs the other way.
void AddStrip(vtkIdList* corners, std::vector<std::array<int, 3>>& triangles)
{
  for (vtkIdType k = 0; k + 2 < corners->GetNumberOfIds(); ++k)
  {
    const auto a = static_cast<int>(corners->GetId(k));
    const auto b = static_cast<int>(corners->GetId(k + 1));
    triangles.push_back(
      { k % 2 == 0 ? a : b, k % 2 == 0 ? b : a, static_cast<int>(corners->GetId(k + 2)) });
  }
}

} // namespace

vtkShapeSoup::vtkShapeSoup(vtkUnstructuredGrid* grid, const std::string& name)
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, corners);
    switch (grid->GetCellType(cell))
    {
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        AddPolygon(corners, grid->GetPoints(), triangles);
        break;
      case VTK_TRIANGLE_STRIP:
        AddStrip(corners, triangles);
        this->IsPolygons = false;
        break;
      case VTK_EMPTY_CELL:
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
      case VTK_LINE:
      case VTK_POLY_LINE:
        this->IsPolygons = false;
        break;
      default:
        throw shape::InvalidInput(name + " has a cell of type " +
          vtkCellTypes::GetClassNameFromTypeId(grid->GetCellType(cell)) + " (cell " +
          std::to_string(cell) + "); apply Extract Surface to it");
    }
    cells.resize(triangles.size(), static_cast<int>(cell));
  }
  if (triangles.empty())
  {
    throw shape::InvalidInput(name + " has no polygons; give a surface");
  }
  this->Surface = { vtkShapeConvert::ToPoints(grid),
    Eigen::MatrixXi(static_cast<Eigen::Index>(triangles.size()), 3) };
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    this->Surface.Triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
      triangles[t][2];
  }
  this->Cells =
    Eigen::Map<const Eigen::VectorXi>(cells.data(), static_cast<Eigen::Index>(cells.size()));
}
