#include "vtkShapePreciseMap.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <vector>

bool vtkShapePreciseMap::Has(vtkDataSet* data, const std::string& mapArray)
{
  // The cell and the weights belong to TargetPosition only, not to another map array.
  return mapArray == Position && data->GetPointData()->HasArray(Cell.c_str()) &&
    data->GetPointData()->HasArray(Barycentric.c_str());
}

shape::NumberedSurface vtkShapePreciseMap::ToSurface(vtkPolyData* surface, const std::string& name)
{
  std::vector<int> cellOf;
  shape::NumberedSurface numbered{ vtkShapeConvert::ToMesh(surface, name, &cellOf),
    static_cast<int>(surface->GetNumberOfVerts() + surface->GetNumberOfLines()), {} };
  // The order of vtkPolyData's cell ids: vertices, lines, polygons, strips.
  numbered.Cells = numbered.First +
    Eigen::Map<const Eigen::ArrayXi>(cellOf.data(), static_cast<Eigen::Index>(cellOf.size()));
  return numbered;
}

shape::NumberedSurface vtkShapePreciseMap::ToSurface(
  vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(grid->GetPoints());
  surface->AllocateEstimate(grid->GetNumberOfCells(), 3);
  // Blocks follow each other, each with its vertices, lines, polygons and strips.
  std::vector<int> ofKind[4];
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const bool isVertex = type == VTK_VERTEX || type == VTK_POLY_VERTEX,
               isLine = type == VTK_LINE || type == VTK_POLY_LINE,
               isPolygon = type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON;
    if (!isVertex && !isLine && !isPolygon && type != VTK_TRIANGLE_STRIP)
    {
      throw shape::MapOfAnotherSurface("TargetCell refers to triangles, but " + name +
        " has a cell of another type (cell " + std::to_string(cell) +
        "); connect the surface for which the map was made as " + name +
        ", or remove TargetCell with Pass Arrays to use closest positions");
    }
    grid->GetCellPoints(cell, corners);
    surface->InsertNextCell(type, corners);
    ofKind[isVertex ? 0 : isLine ? 1 : isPolygon ? 2 : 3].push_back(static_cast<int>(cell));
  }
  shape::NumberedSurface numbered = ToSurface(surface, name);
  std::vector<int> inGrid;
  for (const std::vector<int>& cells : ofKind)
  {
    inGrid.insert(inGrid.end(), cells.begin(), cells.end());
  }
  numbered.Cells = numbered.Cells.unaryExpr([&](int cell) { return inGrid[cell]; }).eval();
  return numbered;
}

shape::SurfacePoints vtkShapePreciseMap::Read(vtkDataSet* data, const std::string& name,
  const shape::NumberedSurface& target, const std::string& targetName, double tolerance)
{
  return shape::RequirePreciseMap({ vtkShapeConvert::ToPointArray(data, Cell, 1, name),
                                    vtkShapeConvert::ToPointArray(data, Barycentric, 3, name),
                                    vtkShapeConvert::ToPointArray(data, Position, 3, name) },
    target, tolerance, name, targetName);
}
