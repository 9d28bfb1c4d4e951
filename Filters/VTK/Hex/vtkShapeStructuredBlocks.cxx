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
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeStructuredBlocks);

vtkShapeStructuredBlocks::vtkShapeStructuredBlocks()
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required, { "vtkUnstructuredGrid" });
  this->DeclareInput("Surface", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
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

/// The hexahedra of all blocks, with the positions to which the map array takes their points.
struct MappedGrid
{
  vtkUnstructuredGrid* Grid;
  std::string MapArray;
  Eigen::MatrixXd Positions, Targets;
  Eigen::MatrixXd Fitted; ///< what splines are fitted to
};

MappedGrid ReadGrid(vtkUnstructuredGrid* grid, const std::string& mapArray)
{
  MappedGrid mapped{ grid, mapArray, vtkShapeConvert::ToPoints(grid),
    vtkShapeConvert::ToPointArray(grid, mapArray, 3, "the Input"), {} };
  shape::RequireFinite(mapped.Positions, "the Input");
  shape::RequireFinite(mapped.Targets, "the Input's " + mapArray);
  mapped.Fitted = mapped.Targets;
  return mapped;
}

/// A block, and the control net of the spline over it.
struct FittedBlock
{
  vtkSmartPointer<vtkStructuredGrid> Nodes, Controls;
  Eigen::VectorXd Errors; ///< the distance of each node from the spline
};

/// cells: the block's, in its order.
FittedBlock FitBlock(const MappedGrid& mapped, const shape::GridBlock& block,
  const std::vector<int>& cells, const shape::BlockSplineOptions& options,
  const shape::Progress& progress)
{
  progress(0.0);
  const std::vector<int> rows(block.Nodes.begin(), block.Nodes.end());
  const Eigen::MatrixXd values = mapped.Targets(rows, Eigen::all);
  const shape::BlockSpline spline =
    shape::FitBlockSpline(block.Counts, mapped.Fitted(rows, Eigen::all), options);
  progress(0.3);
  const Eigen::MatrixXd fitted =
    shape::Evaluate(spline, shape::NodeParameters(block.Counts), progress.Part(0.3, 0.7));
  progress(0.7);
  FittedBlock result{ MakeGrid(block.Counts, values), MakeGrid(spline.Counts, spline.Controls),
    (fitted - values).rowwise().norm() };
  vtkPointData* data = result.Nodes->GetPointData();
  CopyRows(mapped.Grid->GetPointData(), rows, { mapped.MapArray }, data);
  CopyRows(
    mapped.Grid->GetCellData(), cells, { "Block", "BlockIndex" }, result.Nodes->GetCellData());
  data->AddArray(vtkShapeConvert::ToArray(mapped.Positions(rows, Eigen::all), "SourcePosition"));
  data->AddArray(vtkShapeConvert::ToArray(fitted, "SplinePosition"));
  data->AddArray(vtkShapeConvert::ToArray(result.Errors, "SplineError"));
  const char* names[] = { "KnotsI", "KnotsJ", "KnotsK" };
  for (int axis = 0; axis < 3; ++axis)
  {
    result.Controls->GetFieldData()->AddArray(
      vtkShapeConvert::ToArray(spline.Knots[axis], names[axis]));
  }
  return result;
}

} // namespace

void vtkShapeStructuredBlocks::Execute(const shape::Progress& progress)
{
  shape::RequireInRange(this->Options); // also if there is no Surface
  vtkShapeComposite::RequireDataSets(this->GetInputDataObject(0, 0));
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkUnstructuredGrid* input = this->GetGatheredInput(0).Grid;
  MappedGrid mapped = ReadGrid(input, this->MapArray);
  const Eigen::VectorXi blockOf = vtkShapeConvert::ToCellIntegers(
    input, "Block", "the Input", "give the third output of Shape Hex Remesh");
  const Eigen::MatrixXi indices = ReadIndices(input);
  const Eigen::MatrixXi hexahedra = ReadHexahedra(input);
  const std::vector<shape::GridBlock> blocks =
    shape::FindGridBlocks(hexahedra, mapped.Positions, blockOf, indices);
  double motion = 0.0, fitted = 0.0;
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    const shape::Surface surface =
      vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Surface");
    shape::RequireClosedSurface(surface, "the Surface");
    fitted = 0.8; // the share of progress
    shape::SmoothBlockMap smooth = shape::SmoothMapOfBlocks(blocks, hexahedra, mapped.Targets,
      surface, this->Options, progress.Part(0.0, fitted, "moving the nodes along the surface"));
    motion = smooth.LargestMotion;
    mapped.Targets = std::move(smooth.Targets);
    mapped.Fitted = std::move(smooth.Splines);
  }
  const std::vector<std::vector<int>> cells = SortCells(blocks, blockOf, indices);
  auto* nodes = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(0));
  auto* controls = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(1));
  const auto count = [](auto number) { return static_cast<double>(number); };
  double largest = 0.0, sum = 0.0;
  vtkIdType nodeCount = 0, controlCount = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const FittedBlock block = FitBlock(mapped, blocks[i], cells[i], this->Options,
      progress.Part(fitted + (1.0 - fitted) * count(i) / count(blocks.size()),
        fitted + (1.0 - fitted) * count(i + 1) / count(blocks.size()), "fitting splines"));
    nodes->SetBlock(static_cast<unsigned int>(i), block.Nodes);
    controls->SetBlock(static_cast<unsigned int>(i), block.Controls);
    largest = std::max(largest, block.Errors.maxCoeff());
    sum += block.Errors.sum();
    nodeCount += block.Nodes->GetNumberOfPoints();
    controlCount += block.Controls->GetNumberOfPoints();
  }
  const std::pair<const char*, double> facts[] = { { "Blocks", count(blocks.size()) },
    { "Nodes", count(nodeCount) }, { "ControlPoints", count(controlCount) },
    { "SplineError", largest },
    { "MeanSplineError", sum / count(std::max<vtkIdType>(nodeCount, 1)) },
    { "RelativeError", largest / shape::ComputeBoxDiagonal(mapped.Targets) },
    { "LargestMotion", motion } };
  for (vtkDataObject* output : { this->GetOutputDataObject(0), this->GetOutputDataObject(1) })
  {
    output->GetFieldData()->PassData(input->GetFieldData());
    for (const auto& [fact, value] : facts)
    {
      vtkShapeConvert::AddFact(output, std::string("StructuredBlocks.") + fact, value);
    }
  }
  progress(1.0);
}
