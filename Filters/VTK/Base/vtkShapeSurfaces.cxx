#include "vtkShapeSurfaces.h"

#include "vtkShapeComposite.h"
#include "vtkShapeGather.h"
#include "vtkShapeSolid.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "IO/BoundaryPatches.h"

#include <algorithm>
#include <array>

namespace
{

/// Returns the surface without ghost cells; its points are unchanged. All points are kept, even
/// points that only ghost cells use, because the output of this process has the same points.
vtkSmartPointer<vtkPolyData> WithoutGhostCells(vtkPolyData* piece)
{
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  vtkUnsignedCharArray* ghosts = piece->GetCellGhostArray();
  if (!ghosts)
  {
    kept->ShallowCopy(piece);
    return kept;
  }
  kept->SetPoints(piece->GetPoints());
  kept->GetFieldData()->ShallowCopy(piece->GetFieldData());
  kept->GetPointData()->ShallowCopy(piece->GetPointData());
  kept->GetCellData()->CopyAllocate(piece->GetCellData());
  kept->AllocateCopy(piece);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    if ((ghosts->GetValue(cell) &
          (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL)) == 0)
    {
      piece->GetCellPoints(cell, corners);
      const vtkIdType id = kept->InsertNextCell(piece->GetCellType(cell), corners);
      kept->GetCellData()->CopyData(piece->GetCellData(), cell, id);
    }
  }
  return kept;
}

/// Returns the place of a type of cell in vtkPolyData's order: 0 vertices, 1 lines, 2 polygons, 3
/// strips; -1 for other cells.
int FindKind(int cellType)
{
  switch (cellType)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return 1;
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
    case VTK_PIXEL:
      return 2;
    case VTK_TRIANGLE_STRIP:
      return 3;
    default:
      return -1;
  }
}

/// Returns the cells of each kind, without empty cells.
std::array<std::vector<vtkIdType>, 4> SortCells(vtkUnstructuredGrid* grid, const std::string& name)
{
  std::array<std::vector<vtkIdType>, 4> ofKind;
  vtkIdType others = 0, first = -1;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const int kind = FindKind(type);
    if (kind >= 0)
    {
      ofKind[kind].push_back(cell);
    }
    else if (type != VTK_EMPTY_CELL)
    {
      first = others++ == 0 ? cell : first;
    }
  }
  if (others > 0)
  {
    throw shape::InvalidInput("the input '" + name + "' has " + std::to_string(others) +
      (others == 1 ? " cell that is" : " cells that are") +
      " no triangle, polygon or strip (first cell " + std::to_string(first) + ", a " +
      vtkCellTypes::GetClassNameFromTypeId(grid->GetCellType(first)) +
      "); apply Extract Surface first");
  }
  return ofKind;
}

bool IsSolid(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  for (vtkIdType cell = 0; grid && cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCell(cell)->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkUnstructuredGrid> BoundaryOf(vtkUnstructuredGrid* solid, const std::string& name)
{
  const shape::SolidFaces faces =
    shape::FindBoundaryFaces(vtkShapeSolid::Read(solid, "the input '" + name + "'"));
  auto boundary = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(solid->GetPoints()->GetDataType());
  vtkPointData* atPoints = boundary->GetPointData();
  vtkCellData* atCells = boundary->GetCellData();
  atPoints->CopyAllocate(solid->GetPointData());
  atCells->CopyAllocate(solid->GetCellData(), faces.Corners.rows());
  std::vector<vtkIdType> numbers(solid->GetNumberOfPoints(), -1);
  boundary->Allocate(faces.Corners.rows());
  for (Eigen::Index face = 0; face < faces.Corners.rows(); ++face)
  {
    const int size = faces.Corners(face, 3) < 0 ? 3 : 4;
    std::array<vtkIdType, 4> corners{};
    for (int k = 0; k < size; ++k)
    {
      const int point = faces.Corners(face, k);
      if (numbers[point] < 0)
      {
        numbers[point] = points->InsertNextPoint(solid->GetPoint(point));
        atPoints->CopyData(solid->GetPointData(), point, numbers[point]);
      }
      corners[k] = numbers[point];
    }
    boundary->InsertNextCell(size == 3 ? VTK_TRIANGLE : VTK_QUAD, size, corners.data());
    atCells->CopyData(solid->GetCellData(), faces.Cell(face), face);
  }
  boundary->SetPoints(points);
  boundary->GetFieldData()->ShallowCopy(solid->GetFieldData());
  return boundary;
}

} // namespace

std::vector<vtkSmartPointer<vtkPolyData>> vtkShapeSurfaces::Of(
  vtkDataObject* data, const std::string& name)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  const auto add = [&](vtkDataObject* block)
  {
    auto* set = vtkDataSet::SafeDownCast(block);
    if (!set || (!set->IsA("vtkPolyData") && !set->IsA("vtkUnstructuredGrid")))
    {
      throw shape::InvalidInput("the input '" + name + "' contains a " + block->GetClassName() +
        ", which is not a surface; apply Extract Surface first, or remove it with Extract Block");
    }
    surfaces.push_back(WithoutGhostCells(vtkShapeSurfaces::ToSurface(set, name)));
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    add(data);
    return surfaces;
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    add(it->GetCurrentDataObject());
  }
  return surfaces;
}

vtkSmartPointer<vtkPolyData> vtkShapeSurfaces::ToSurface(vtkDataSet* data, const std::string& name)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    return vtkPolyData::SafeDownCast(data);
  }
  const std::array<std::vector<vtkIdType>, 4> ofKind = SortCells(grid, name);
  std::array<vtkNew<vtkCellArray>, 4> cells;
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkCellData* carried = surface->GetCellData();
  carried->CopyAllOn(); // global ids, too: the cells are the same
  carried->CopyAllocate(grid->GetCellData(), grid->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  vtkIdType next = 0;
  for (std::size_t kind = 0; kind < ofKind.size(); ++kind)
  {
    for (const vtkIdType cell : ofKind[kind])
    {
      grid->GetCellPoints(cell, corners);
      if (grid->GetCellType(cell) == VTK_PIXEL)
      {
        // The corners of a pixel are numbered row by row.
        const vtkIdType third = corners->GetId(2);
        corners->SetId(2, corners->GetId(3));
        corners->SetId(3, third);
      }
      cells[kind]->InsertNextCell(corners);
      carried->CopyData(grid->GetCellData(), cell, next++);
    }
  }
  surface->SetPoints(grid->GetPoints());
  surface->SetVerts(cells[0]);
  surface->SetLines(cells[1]);
  surface->SetPolys(cells[2]);
  surface->SetStrips(cells[3]);
  surface->GetPointData()->ShallowCopy(grid->GetPointData());
  surface->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return surface;
}

vtkSmartPointer<vtkDataObject> vtkShapeSurfaces::SolidAsBoundary(
  vtkDataObject* data, const std::string& name, vtkMultiProcessController* controller)
{
  double counts[2] = { 0.0, 0.0 }; // of solids, and of other pieces
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      for (vtkDataSet* piece : vtkShapeComposite::Of(data))
      {
        counts[IsSolid(piece) ? 0 : 1] += piece->GetNumberOfCells() > 0 ? 1.0 : 0.0;
      }
    });
  vtkShapeGather::Reduce(controller, counts, 2, vtkShapeGather::Reduction::Sum);
  auto* solid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkSmartPointer<vtkDataObject> result = data;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      if (counts[0] > 0.0 && (counts[0] + counts[1] > 1.0 || !solid))
      {
        throw shape::InvalidInput("the input '" + name +
          "' has solid cells in several blocks or pieces; apply Extract Surface first, or make one "
          "unstructured grid of them with Merge Blocks");
      }
      if (solid && IsSolid(solid))
      {
        result = BoundaryOf(solid, name);
      }
    });
  return result;
}
