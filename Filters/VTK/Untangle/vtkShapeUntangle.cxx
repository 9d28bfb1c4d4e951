#include "vtkShapeUntangle.h"

#include "vtkShapeConvert.h"
#include "vtkShapeSolid.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <array>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkShapeUntangle);

vtkShapeUntangle::vtkShapeUntangle()
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("RestShape", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
  this->DeclareShown(0, { "ScaledJacobian" });
  this->DeclareMeasures({ "Inverted" });
}

namespace
{

/// Joins points that coincide in both shapes, which connects the cells of several pieces. Each is
/// replaced by the first of them. Returns the points that remain, by their given indices.
std::vector<int> Join(shape::Cells& cells, Eigen::MatrixXd& rest)
{
  const auto count = static_cast<int>(cells.Points.rows());
  std::map<std::array<double, 6>, int> firsts;
  std::vector<int> kept, newId(count);
  for (int i = 0; i < count; ++i)
  {
    std::array<double, 6> position = {};
    for (int k = 0; k < 3; ++k)
    {
      position[k] = cells.Points(i, k);
      position[3 + k] = rest.rows() > 0 ? rest(i, k) : 0.0;
    }
    const auto [first, isNew] = firsts.emplace(position, static_cast<int>(kept.size()));
    newId[i] = first->second;
    if (isNew)
    {
      kept.push_back(i);
    }
  }
  for (int& corner : cells.Corners)
  {
    corner = newId[corner];
  }
  cells.Points = cells.Points(kept, Eigen::all).eval();
  if (rest.rows() > 0)
  {
    rest = rest(kept, Eigen::all).eval();
  }
  return kept;
}

} // namespace

void vtkShapeUntangle::Execute(const shape::Progress& progress)
{
  vtkShapeSolid::RequireDataSets(this->GetInputDataObject(0, 0));
  // Every process has the complete input, and one of them computes the result.
  vtkMultiProcessController* controller = this->GetController();
  if (controller && controller->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkUnstructuredGrid* input = this->GetGatheredInput(0).Grid;
  const shape::Cells given = vtkShapeSolid::Read(input, "the Input");
  Eigen::MatrixXd rest;
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    const shape::Cells other = vtkShapeSolid::Read(this->GetGatheredInput(1).Grid, "the RestShape");
    if (other.Points.rows() != given.Points.rows() || other.Kinds.size() != given.Kinds.size() ||
      other.Corners.size() != given.Corners.size() || other.Kinds != given.Kinds ||
      other.Corners != given.Corners)
    {
      throw shape::InvalidInput("the RestShape does not have the cells of the Input (it has " +
        std::to_string(other.Kinds.size()) + " cells and " + std::to_string(other.Points.rows()) +
        " points, and the Input has " + std::to_string(given.Kinds.size()) + " cells and " +
        std::to_string(given.Points.rows()) +
        " points); connect the same mesh before it was moved");
    }
    rest = other.Points;
  }
  shape::Cells cells = given;
  const Eigen::MatrixXd givenRest = rest;
  progress(0.05);
  // Within one data set, coincident points may belong to faces that are separate on purpose.
  const bool inPieces = vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) ||
    (controller && controller->GetNumberOfProcesses() > 1);
  std::vector<int> kept;
  if (inPieces)
  {
    kept = Join(cells, rest);
  }
  shape::UntangleResult result =
    shape::Untangle(cells, rest, this->Options, progress.Part(0.05, 0.95));
  if (inPieces)
  {
    const auto count = static_cast<int>(given.Kinds.size());
    result.Provenance = shape::Compose(shape::TraceCopies(kept, given.Points.rows(),
                                         Eigen::VectorXi::LinSpaced(count, 0, count - 1)),
      result.Provenance);
  }

  Eigen::MatrixXd sources = rest.rows() > 0 ? givenRest : given.Points;
  // If the input is the output of a map, it already has SourcePosition, which is kept.
  if (rest.rows() == 0 && input->GetPointData()->HasArray("SourcePosition"))
  {
    sources = vtkShapeConvert::ToPointArray(input, "SourcePosition", 3, "the Input");
  }
  auto* output = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  vtkShapeSolid::Write(result, input, sources, output);
  const std::pair<const char*, int> facts[] = { { "InvertedBefore", result.InvertedBefore },
    { "InvertedAfter", result.InvertedAfter }, { "SplitCells", result.SplitCells },
    { "MovedPoints", result.MovedPoints }, { "Iterations", result.Iterations } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("Untangle.") + fact, value);
  }
}
