#include "vtkShapeSolid.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Untangle/FoldFreeMap.h"

#include <utility>
#include <vector>

namespace
{

void WriteCells(const shape::Cells& solid, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(solid.Points, "Points"));
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  cells->AllocateExact(solid.Kinds.size(), solid.Corners.size());
  types->SetNumberOfValues(solid.Kinds.size());
  for (Eigen::Index cell = 0; cell < solid.Kinds.size(); ++cell)
  {
    types->SetValue(cell, static_cast<unsigned char>(solid.Kinds(cell)));
    const int first = solid.Offsets(cell), count = solid.Offsets(cell + 1) - first;
    cells->InsertNextCell(count);
    for (int k = 0; k < count; ++k)
    {
      cells->InsertCellPoint(solid.Corners(first + k));
    }
  }
  output->SetPoints(points);
  output->SetCells(types, cells);
}

} // namespace

shape::Cells vtkShapeSolid::Read(vtkUnstructuredGrid* grid, const std::string& name)
{
  shape::Cells cells = vtkShapeConvert::ToCells(grid, name);
  vtkShapeConvert::ReorderVoxels(cells);
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    switch (cells.Kinds(cell))
    {
      case VTK_TETRA:
      case VTK_PYRAMID:
      case VTK_WEDGE:
      case VTK_HEXAHEDRON:
        break;
      // The untangling energy is defined for linear solid cells only.
      default:
        throw shape::InvalidInput(name + " has a " +
          vtkCellTypes::GetClassNameFromTypeId(cells.Kinds(cell)) + " (cell " +
          std::to_string(cell) +
          "), but only tetrahedra, pyramids, wedges and hexahedra are solid cells; remove the "
          "others with Extract Cells By Type, or fill a surface with Shape Tetrahedralize");
    }
  }
  return cells;
}

void vtkShapeSolid::RequireDataSets(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return;
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (!vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
    {
      throw shape::InvalidInput(std::string("a block is a ") +
        it->GetCurrentDataObject()->GetClassName() +
        ", which has no points; remove it with Extract Block");
    }
  }
}

void vtkShapeSolid::Write(const shape::UntangleResult& result, vtkUnstructuredGrid* input,
  const Eigen::MatrixXd& sources, vtkUnstructuredGrid* output)
{
  WriteCells(result.Solid, output);
  vtkShapeCarry::Carry({ { input, result.Provenance } }, output);
  vtkPointData* points = output->GetPointData();
  vtkShapeCarry::AddOriginals(result.Provenance.Points, "OriginalPointId", points);
  points->AddArray(vtkShapeConvert::ToArray(result.Provenance.Weights * sources, "SourcePosition"));
  vtkCellData* cells = output->GetCellData();
  vtkShapeCarry::AddOriginals(result.Provenance.Cells, "OriginalCellId", cells);
  cells->AddArray(vtkShapeConvert::ToIntegers(result.Inverted, "Inverted"));
}

void vtkShapeSolid::RequireOneSolid(vtkDataObject* domain, vtkMultiProcessController* controller)
{
  const std::vector<vtkDataSet*> leaves = vtkShapeComposite::Of(domain);
  if (leaves.size() != 1 || (controller && controller->GetNumberOfProcesses() > 1))
  {
    throw shape::InvalidInput(
      "FoldFree needs a Domain that is one data set on one process; join blocks with Merge Blocks, "
      "or turn FoldFree off and apply Shape Untangle to the output, with the Domain as RestShape");
  }
  bool solid = false;
  for (vtkIdType cell = 0; cell < leaves[0]->GetNumberOfCells() && !solid; ++cell)
  {
    solid = leaves[0]->GetCellType(cell) >= VTK_TETRA;
  }
  if (!solid)
  {
    throw shape::InvalidInput(
      "FoldFree needs a Domain with solid cells, but this one has only points or surface cells; "
      "fill a surface with Shape Tetrahedralize, or turn FoldFree off");
  }
}

/// The moved output is the initial state, and the domain is the rest shape. Cells may be split, so
/// the output is rebuilt, with arrays interpolated from the moved output.
std::pair<int, int> vtkShapeSolid::MakeFoldFree(vtkDataObject* domain, vtkDataObject* moved,
  const shape::Mesh& boundary, const Eigen::MatrixXd& targets,
  vtkMultiProcessController* controller, const shape::Progress& progress)
{
  RequireOneSolid(domain, controller);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkShapeGather::GatherGrid(domain, nullptr);
  const shape::UntangleResult result = shape::ComputeFoldFreeMap(Read(grid, "the Domain"),
    vtkShapeConvert::ToPoints(vtkShapeComposite::Of(moved)[0]), boundary, targets, progress);
  auto* output = vtkPointSet::SafeDownCast(vtkShapeComposite::Of(moved)[0]);
  if (auto* cells = vtkUnstructuredGrid::SafeDownCast(output))
  {
    const Eigen::MatrixXd sources =
      vtkShapeConvert::ToPointArray(cells, "SourcePosition", 3, "the Domain");
    vtkNew<vtkUnstructuredGrid> carried;
    carried->ShallowCopy(cells);
    cells->Initialize();
    Write(result, carried, sources, cells);
  }
  else
  {
    // A structured grid has hexahedra, which are never split.
    vtkNew<vtkPoints> points;
    points->SetData(vtkShapeConvert::ToArray(result.Solid.Points, "Points"));
    output->SetPoints(points);
    output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(result.Inverted, "Inverted"));
  }
  return { result.InvertedBefore, result.InvertedAfter };
}
