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

/// Merges points that coincide in both shapes, which connects the cells of several pieces. Each is
/// replaced by the first of them, and the others are then used by no cell.
void Join(shape::Cells& cells, const Eigen::MatrixXd& rest)
{
  std::map<std::array<double, 6>, int> firsts;
  Eigen::VectorXi first(cells.Points.rows());
  for (int i = 0; i < first.size(); ++i)
  {
    std::array<double, 6> position = {};
    for (int k = 0; k < 3; ++k)
    {
      position[k] = cells.Points(i, k);
      position[3 + k] = rest.rows() > 0 ? rest(i, k) : 0.0;
    }
    first(i) = firsts.emplace(position, i).first->second;
  }
  for (int& corner : cells.Corners)
  {
    corner = first(corner);
  }
}

/// Moves each merged point to the position of the point that replaced it. No cell uses merged
/// points, so untangling did not move them.
void Follow(const shape::Cells& before, const shape::Cells& joined, Eigen::MatrixXd& points)
{
  for (Eigen::Index i = 0; i < before.Corners.size(); ++i)
  {
    points.row(before.Corners(i)) = points.row(joined.Corners(i));
  }
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
  progress(0.05);
  // Within one data set, coincident points may belong to faces that are separate on purpose.
  const bool inPieces = vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) ||
    (controller && controller->GetNumberOfProcesses() > 1);
  if (inPieces)
  {
    Join(cells, rest);
  }
  shape::UntangleResult result =
    shape::Untangle(cells, rest, this->Options, progress.Part(0.05, 0.95));
  if (inPieces)
  {
    Follow(given, cells, result.Solid.Points);
  }

  Eigen::MatrixXd sources = rest.rows() > 0 ? rest : given.Points;
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
