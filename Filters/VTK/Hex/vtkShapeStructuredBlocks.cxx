#include "vtkShapeStructuredBlocks.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkShapeStructuredBlocks);

vtkShapeStructuredBlocks::vtkShapeStructuredBlocks()
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required, { "vtkUnstructuredGrid" });
  this->DeclareOutput("vtkMultiBlockDataSet");
  this->DeclareOutput("vtkMultiBlockDataSet");
  this->DeclareFacts();
  this->DeclareShown(0, { "SplineError" });
  this->DeclareMeasures({ "SplineError" });
}

namespace
{

/// The cells as rows of 8 points.
Eigen::MatrixXi ReadHexahedra(vtkUnstructuredGrid* grid)
{
  const shape::Cells cells = vtkShapeConvert::ToCells(grid, "the Input");
  if ((cells.Kinds.array() != shape::cell_kind::Hexahedron).any())
  {
    throw shape::InvalidInput(
      "the Input has cells that are not hexahedra; give the third output of Shape Hex Remesh");
  }
  return cells.Corners.reshaped<Eigen::RowMajor>(cells.Kinds.size(), 8);
}

/// The indices i, j, k of each cell.
Eigen::MatrixXi ReadIndices(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray("BlockIndex");
  if (!array || array->GetNumberOfComponents() != 3)
  {
    throw shape::InvalidInput("the Input has no cell array 'BlockIndex' with 3 components; give "
                              "the third output of Shape Hex Remesh");
  }
  Eigen::MatrixXi indices(array->GetNumberOfTuples(), 3);
  for (Eigen::Index cell = 0; cell < indices.rows(); ++cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      indices(cell, axis) = static_cast<int>(array->GetComponent(cell, axis));
    }
  }
  return indices;
}

vtkSmartPointer<vtkStructuredGrid> MakeGrid(
  const Eigen::RowVector3i& counts, const Eigen::MatrixXd& points)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(counts(0), counts(1), counts(2));
  vtkNew<vtkPoints> positions;
  positions->SetData(vtkShapeConvert::ToArray(points, "Points"));
  grid->SetPoints(positions);
  return grid;
}

/// Copies the tuples with these indices of all arrays but some.
void CopyRows(vtkDataSetAttributes* from, const std::vector<int>& rows,
  const std::vector<std::string>& without, vtkDataSetAttributes* to)
{
  vtkNew<vtkPointData> kept;
  kept->ShallowCopy(from);
  for (const std::string& name : without)
  {
    kept->RemoveArray(name.c_str());
  }
  vtkNew<vtkIdList> source, target;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    source->InsertNextId(rows[i]);
    target->InsertNextId(static_cast<vtkIdType>(i));
  }
  to->CopyAllOn();
  to->CopyAllocate(kept, static_cast<vtkIdType>(rows.size()));
  to->CopyData(kept, source, target);
}

/// The cells of each block, along the first axis first.
std::vector<std::vector<int>> SortCells(const std::vector<shape::GridBlock>& blocks,
  const Eigen::VectorXi& blockOf, const Eigen::MatrixXi& indices)
{
  std::vector<std::vector<int>> cells;
  for (const shape::GridBlock& block : blocks)
  {
    cells.emplace_back((block.Counts.array() - 1).prod());
  }
  for (int cell = 0; cell < static_cast<int>(blockOf.size()); ++cell)
  {
    const Eigen::RowVector3i counts = blocks[blockOf(cell)].Counts.array() - 1;
    cells[blockOf(cell)]
         [indices(cell, 0) + counts(0) * (indices(cell, 1) + counts(1) * indices(cell, 2))] = cell;
  }
  return cells;
}

} // namespace

void vtkShapeStructuredBlocks::Execute(const shape::Progress& progress)
{
  vtkShapeComposite::RequireDataSets(this->GetInputDataObject(0, 0));
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkUnstructuredGrid* input = this->GetGatheredInput(0).Grid;
  const Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(input),
                        targets =
                          vtkShapeConvert::ToPointArray(input, this->MapArray, 3, "the Input");
  shape::RequireFinite(positions, "the Input");
  shape::RequireFinite(targets, "the Input's " + this->MapArray);
  const Eigen::VectorXi blockOf = vtkShapeConvert::ToCellIntegers(
    input, "Block", "the Input", "give the third output of Shape Hex Remesh");
  const Eigen::MatrixXi indices = ReadIndices(input);
  const std::vector<shape::GridBlock> blocks =
    shape::FindGridBlocks(ReadHexahedra(input), positions, blockOf, indices);
  const std::vector<std::vector<int>> cells = SortCells(blocks, blockOf, indices);
  auto* nodes = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(0));
  auto* controls = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(1));
  double largest = 0.0, sum = 0.0;
  Eigen::Index nodeCount = 0, controlCount = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto all = static_cast<double>(blocks.size());
    const shape::Progress part = progress.Part(
      static_cast<double>(i) / all, (static_cast<double>(i) + 1.0) / all, "fitting splines");
    part(0.0);
    const shape::GridBlock& block = blocks[i];
    const std::vector<int> rows(block.Nodes.begin(), block.Nodes.end());
    const Eigen::MatrixXd values = targets(rows, Eigen::all);
    const shape::BlockSpline spline = shape::FitBlockSpline(block.Counts, values, this->Options);
    part(0.3);
    const Eigen::MatrixXd fitted =
      shape::Evaluate(spline, shape::NodeParameters(block.Counts), part.Part(0.3, 0.7));
    part(0.7);
    const Eigen::VectorXd errors = (fitted - values).rowwise().norm();
    const auto grid = MakeGrid(block.Counts, values);
    CopyRows(input->GetPointData(), rows, { this->MapArray }, grid->GetPointData());
    CopyRows(input->GetCellData(), cells[i], { "Block", "BlockIndex" }, grid->GetCellData());
    grid->GetPointData()->AddArray(
      vtkShapeConvert::ToArray(positions(rows, Eigen::all), "SourcePosition"));
    grid->GetPointData()->AddArray(vtkShapeConvert::ToArray(fitted, "SplinePosition"));
    grid->GetPointData()->AddArray(vtkShapeConvert::ToArray(errors, "SplineError"));
    nodes->SetBlock(static_cast<unsigned int>(i), grid);
    const auto net = MakeGrid(spline.Counts, spline.Controls);
    for (int axis = 0; axis < 3; ++axis)
    {
      const char* names[] = { "KnotsI", "KnotsJ", "KnotsK" };
      net->GetFieldData()->AddArray(vtkShapeConvert::ToArray(spline.Knots[axis], names[axis]));
    }
    controls->SetBlock(static_cast<unsigned int>(i), net);
    largest = std::max(largest, errors.maxCoeff());
    sum += errors.sum();
    nodeCount += errors.size();
    controlCount += spline.Controls.rows();
  }
  const auto count = [](auto number) { return static_cast<double>(number); };
  for (vtkDataObject* output : { this->GetOutputDataObject(0), this->GetOutputDataObject(1) })
  {
    output->GetFieldData()->PassData(input->GetFieldData());
    vtkShapeConvert::AddFact(output, "StructuredBlocks.Blocks", count(blocks.size()));
    vtkShapeConvert::AddFact(output, "StructuredBlocks.Nodes", count(nodeCount));
    vtkShapeConvert::AddFact(output, "StructuredBlocks.ControlPoints", count(controlCount));
    vtkShapeConvert::AddFact(output, "StructuredBlocks.SplineError", largest);
    vtkShapeConvert::AddFact(output, "StructuredBlocks.MeanSplineError",
      sum / count(std::max<Eigen::Index>(nodeCount, 1)));
    vtkShapeConvert::AddFact(
      output, "StructuredBlocks.RelativeError", largest / shape::ComputeBoxDiagonal(targets));
  }
  progress(1.0);
}
