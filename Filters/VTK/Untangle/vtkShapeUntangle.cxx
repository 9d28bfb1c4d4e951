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
#include "Mesh/UsedPoints.h"

#include <array>
#include <map>
#include <sstream>
#include <string>
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

/// Connects the cells of several pieces: their corners become the first of the points that coincide
/// in both shapes. Returns the first for each point.
Eigen::VectorXi Connect(shape::Cells& cells, const Eigen::MatrixXd& rest)
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
  return first;
}

/// Removes the points that another one replaces. Returns the points that remain.
std::vector<int> RemoveCopies(
  const Eigen::VectorXi& first, shape::Cells& cells, Eigen::MatrixXd& rest)
{
  std::vector<int> kept;
  for (int i = 0; i < first.size(); ++i)
  {
    if (first(i) == i)
    {
      kept.push_back(i);
    }
  }
  const std::vector<int> newId = shape::InvertIndices(kept, first.size());
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

/// Gives the cells their given points again, which move like the first of them.
void Separate(
  const shape::Cells& given, const Eigen::VectorXi& first, shape::UntangleResult& result)
{
  shape::Cells& solid = result.Solid;
  for (Eigen::Index cell = 0; cell < solid.Kinds.size(); ++cell)
  {
    const int original = result.Provenance.Cells(cell);
    for (int i = solid.Offsets(cell); i < solid.Offsets(cell + 1); ++i)
    {
      const int joined = solid.Corners(i);
      for (int k = given.Offsets(original); k < given.Offsets(original + 1); ++k)
      {
        if (first(given.Corners(k)) == joined)
        {
          solid.Corners(i) = given.Corners(k);
        }
      }
    }
  }
  for (int i = 0; i < first.size(); ++i)
  {
    solid.Points.row(i) = solid.Points.row(first(i)).eval();
  }
}

std::string FormatPosition(const Eigen::RowVector3d& position)
{
  std::ostringstream words;
  words << "(" << position(0) << ", " << position(1) << ", " << position(2) << ")";
  return words.str();
}

/// Why cells stay inverted, or nothing.
std::string ReasonOf(const shape::UntangleResult& result, const shape::UntangleOptions& options)
{
  if (result.InvertedAfter == 0)
  {
    return "";
  }
  if (result.BoundaryCrossings > 0)
  {
    return "the boundary crosses itself, first near " + FormatPosition(result.FirstCrossing);
  }
  if (result.FoldedEdges > 0)
  {
    return "the boundary folds back on itself at " + std::to_string(result.FoldedEdges) +
      " edge(s), where two of its triangles overlap in one plane, within rounding; the first is "
      "near " +
      FormatPosition(result.FirstFolded);
  }
  if (!options.SplitCells)
  {
    return "no positions were found, and Split Cells is off";
  }
  const bool hasOthers = (result.Solid.Kinds.array() != shape::cell_kind::Tetrahedron).any();
  if (hasOthers)
  {
    return "no positions were found, and only tetrahedra can be split";
  }
  std::ostringstream words;
  words << "no positions were found within the limits";
  if (result.HiddenTriangles > 0)
  {
    words << ", and the boundary is not star-shaped: " << result.HiddenTriangles
          << " of its triangles are hidden from the best position inside, first near "
          << FormatPosition(result.FirstHidden);
  }
  else if (result.StarClearance > 0.0)
  {
    words << "; the boundary is star-shaped, but the planes of its triangles are only "
          << result.StarClearance << " of its size from the best position inside";
  }
  return words.str();
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
  const bool isDistributed = controller && controller->GetNumberOfProcesses() > 1;
  const bool isComposite = vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
  Eigen::VectorXi first;
  std::vector<int> kept;
  if (isDistributed || isComposite)
  {
    first = Connect(cells, rest);
  }
  if (isDistributed)
  {
    kept = RemoveCopies(first, cells, rest);
  }
  shape::UntangleResult result =
    shape::Untangle(cells, rest, this->Options, progress.Part(0.05, 0.95));
  if (isDistributed)
  {
    const auto count = static_cast<int>(given.Kinds.size());
    result.Provenance = shape::Compose(shape::TraceCopies(kept, given.Points.rows(),
                                         Eigen::VectorXi::LinSpaced(count, 0, count - 1)),
      result.Provenance);
  }
  else if (isComposite)
  {
    Separate(given, first, result);
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
    { "MovedPoints", result.MovedPoints }, { "Iterations", result.Iterations },
    { "RefineIterations", result.RefineIterations }, { "ExpandedPoints", result.ExpandedPoints } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("Untangle.") + fact, value);
  }
  vtkShapeConvert::AddFact(output, "Untangle.Reason", ReasonOf(result, this->Options));
  vtkShapeConvert::AddFact(output, "Untangle.MeasureBefore", result.MeasureBefore);
  vtkShapeConvert::AddFact(output, "Untangle.MeasureAfter", result.MeasureAfter);
}
