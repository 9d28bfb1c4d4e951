#include "vtkShapeSolid.h"

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
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Untangle/Untangle.h"

#include <map>
#include <utility>
#include <vector>

namespace
{

/// Computes the weights of the input's points in each new point; its parents may also be new
/// points.
std::vector<std::map<int, double>> WeightsOf(
  const std::vector<std::array<int, 4>>& parents, int originalPoints)
{
  std::vector<std::map<int, double>> weights(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    // A new point is the mean of its parents, which are earlier points: one pass is enough.
    double count = 0.0;
    for (const int parent : parents[i])
    {
      count += parent >= 0;
    }
    for (const int parent : parents[i])
    {
      if (parent >= originalPoints)
      {
        for (const auto& [point, weight] : weights[parent - originalPoints])
        {
          weights[i][point] += weight / count;
        }
      }
      else if (parent >= 0)
      {
        weights[i][parent] += 1.0 / count;
      }
    }
  }
  return weights;
}

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

vtkSmartPointer<vtkIdTypeArray> Ids(const char* name, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(count);
  return ids;
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
          "), but only tetrahedra, pyramids, wedges and hexahedra can be untangled; remove the "
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
  const int kept = static_cast<int>(input->GetNumberOfPoints());
  const int points = static_cast<int>(result.Solid.Points.rows());
  const auto weights = WeightsOf(result.Parents, kept);
  vtkPointData* from = input->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->CopyAllOn();
  to->InterpolateAllocate(from, points);
  auto pointIds = Ids("OriginalPointId", points);
  Eigen::MatrixXd positions(points, 3);
  positions.topRows(kept) = sources;
  for (int i = 0; i < kept; ++i)
  {
    to->CopyData(from, i, i);
    pointIds->SetValue(i, i);
  }
  vtkNew<vtkIdList> parents;
  std::vector<double> shares;
  for (int i = kept; i < points; ++i)
  {
    parents->Reset();
    shares.clear();
    positions.row(i).setZero();
    for (const auto& [point, weight] : weights[i - kept])
    {
      parents->InsertNextId(point);
      shares.push_back(weight);
      positions.row(i) += weight * sources.row(point);
    }
    to->InterpolatePoint(from, i, parents, shares.data());
    // A new point has no original.
    pointIds->SetValue(i, -1);
  }
  to->AddArray(pointIds);
  to->AddArray(vtkShapeConvert::ToArray(positions, "SourcePosition"));
  vtkCellData* cells = output->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(input->GetCellData(), result.OriginalCell.size());
  auto cellIds = Ids("OriginalCellId", result.OriginalCell.size());
  for (Eigen::Index cell = 0; cell < result.OriginalCell.size(); ++cell)
  {
    cells->CopyData(input->GetCellData(), result.OriginalCell(cell), cell);
    cellIds->SetValue(cell, result.OriginalCell(cell));
  }
  cells->AddArray(cellIds);
  cells->AddArray(vtkShapeConvert::ToIntegers(result.Inverted, "Inverted"));
  output->GetFieldData()->PassData(input->GetFieldData());
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
