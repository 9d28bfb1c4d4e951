#include "Untangle/Untangle.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Untangle/Private/BoundaryFaults.h"
#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/KernelMoves.h"
#include "Untangle/Private/PatchCollar.h"
#include "Untangle/Private/SolidRefinement.h"
#include "Untangle/Private/StarCollar.h"
#include "Untangle/Private/StarKernel.h"
#include "Untangle/Private/TutteEmbedding.h"
#include "Untangle/Private/UntanglingRounds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Throws unless lengths can be computed with, and the boundary encloses a volume. Inner points do
/// not change that volume, so no cells can be positive in a negative one.
void RequireSolid(const Cells& cells, const SolidCells& solid)
{
  Mesh boundary{ cells.Points,
    Eigen::MatrixXi(static_cast<Eigen::Index>(solid.BoundaryTriangles().size()), 3) };
  for (Eigen::Index t = 0; t < boundary.Triangles.rows(); ++t)
  {
    const std::array<int, 3>& corners = solid.BoundaryTriangles()[t];
    boundary.Triangles.row(t) << corners[0], corners[1], corners[2];
  }
  RequireExtent(boundary, "the Input");
  // Wedges may be numbered in both orientations, so their faces may be turned inwards.
  const bool hasWedges = (cells.Kinds.array() == cell_kind::Wedge).any();
  const double volume = ComputeEnclosedVolume(boundary);
  // Far above the rounding of points in a plane.
  const double minimum = 1e-15 * std::pow(ComputeLongestBoxEdge(boundary), 3);
  if (!(std::abs(volume) > minimum) && (!hasWedges || !(ComputeBox(boundary).volume() > minimum)))
  {
    throw InvalidInput("the Input has no volume: its points lie in a plane, on a line or at one "
                       "position; check its coordinates");
  }
  if (volume < 0.0 && !hasWedges)
  {
    std::ostringstream words;
    words << "the boundary of the Input is inverted (it encloses a volume of " << volume
          << "), so that no cells in it can be positive; mirror it with Reflect";
    throw InvalidInput(words.str());
  }
}

Untangling BeginUntangling(const Cells& cells, const Eigen::MatrixXd& rest,
  const UntangleOptions& options, const Progress& progress)
{
  Untangling begun{ SolidCells(cells, rest, "the Input", progress), nullptr };
  begun.MaximumIterations = options.MaximumIterations;
  begun.MaximumWork = options.MaximumWork;
  begun.SplitCells = options.SplitCells;
  RequireSolid(cells, begun.Solid);
  if (!options.FixBoundary)
  {
    begun.Sliding =
      std::make_unique<SlidingBoundary>(begun.Solid.Points, begun.Solid.BoundaryTriangles());
  }
  return begun;
}

/// Returns the centre of a fixed boundary that is star-shaped, if all cells are tetrahedra that may
/// be split; else a placement that is not valid.
StarPlacement FindStar(const SolidCells& solid, const UntangleOptions& options)
{
  return options.FixBoundary && options.SplitCells && solid.HasOnlyTetrahedra()
    ? FindStarCentre(solid, FindStarFaces(solid))
    : StarPlacement();
}

/// Whether the boundary is about as far from the centre of its box everywhere.
bool IsNearSphere(const SolidCells& solid)
{
  constexpr double maximumReach = 1.5;
  Eigen::AlignedBox3d box;
  for (const std::array<int, 3>& triangle : solid.BoundaryTriangles())
  {
    box.extend(solid.Points.row(triangle[0]).transpose());
  }
  double nearest = std::numeric_limits<double>::max(), farthest = 0.0;
  for (const std::array<int, 3>& triangle : solid.BoundaryTriangles())
  {
    const double distance = (solid.Points.row(triangle[0]).transpose() - box.center()).norm();
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  return farthest <= maximumReach * nearest;
}

/// Builds a collar between the targets of the boundary and a sphere, where the solid is, and
/// untangles the solid below it, in turns: by exact moves of single points, and by Newton's method
/// while the collar is fixed. Returns the number of inverted cells.
int UntangleBelowCollar(Untangling& untangling, const Eigen::RowVector3d& centre,
  const Eigen::MatrixXd& targets, const Progress& progress)
{
  constexpr int turns = 4;
  SolidCells& solid = untangling.Solid;
  const PatchCollar collar = BuildPatchCollar(solid, centre, targets, progress.Part(0.0, 0.2));
  int left = MoveIntoKernels(solid, progress.Part(0.2, 0.4));
  for (int turn = 0; turn < turns && left > 0 && collar.Inverted == 0; ++turn)
  {
    const Progress part = progress.Part(0.4 + 0.6 * turn / turns, 0.4 + 0.6 * (turn + 1.0) / turns);
    solid.SetInnerBoundary(collar.Inside);
    MovePoints(untangling, 1 + turn, part.Part(0.0, 0.5));
    solid.ForgetInnerBoundary();
    left = MoveIntoKernels(solid, part.Part(0.5, 1.0));
  }
  return left;
}

/// Untangles the solid where its boundary is, from the means of neighbours. Returns the number of
/// inverted cells. maximumWork: of Newton's method (UntangleOptions).
int UntangleFromMeans(Untangling& untangling, double maximumWork, const Progress& progress)
{
  untangling.Solid.Points = SolveTutteEmbedding(untangling.Solid, progress.Part(0.0, 0.2));
  const double given = untangling.MaximumWork;
  untangling.MaximumWork = std::min(given, untangling.Work + maximumWork);
  const int left = ReduceInverted(
    untangling, PatienceInStar, progress.Part(0.2, 1.0, "untangling the inverted cells"));
  untangling.MaximumWork = given;
  return left;
}

/// Untangles the solid anew where each tetrahedron meets the boundary in one simplex. Returns the
/// number of inverted cells.
///
/// Unless the boundary is near a sphere, the solid is untangled in one, which is convex, and the
/// boundary moves outward to where it was. If distances are too small for that in double precision,
/// the solid is untangled where the boundary is. If that is too much work, it is untangled below a
/// collar that suits each triangle of the boundary.
int UntangleStar(Untangling& untangling, const Eigen::RowVector3d& centre, const Progress& progress)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  constexpr double maximumWork = 6e7; // 30 seconds or so
  SolidCells& solid = untangling.Solid;
  SeparateBoundary(solid, progress.Part(0.0, 0.0));
  if (IsNearSphere(solid))
  {
    return UntangleFromMeans(untangling, unlimited, progress);
  }
  const Eigen::MatrixXd targets = solid.Points.topRows(solid.PointCount());
  ProjectToSphere(solid, centre);
  solid.Points = SolveTutteEmbedding(solid, progress.Part(0.0, 0.05));
  // An expansion may take longer than all rounds, so these end only when they stall.
  if (ReduceAndExpand(untangling, Patience, progress.Part(0.05, 0.5)) > 0)
  {
    MoveBoundary(solid, targets);
    return UntangleFromMeans(untangling, unlimited, progress.Part(0.5, 1.0));
  }
  const SolidCells inSphere = solid;
  const Progress outward = progress.Part(0.5, 0.6, "moving the boundary outward");
  if (MoveOutward(solid, centre, targets, outward) == 0)
  {
    return 0;
  }
  solid = inSphere;
  MoveBoundary(solid, targets);
  const int left = UntangleFromMeans(untangling, maximumWork, progress.Part(0.6, 0.8));
  if (left == 0)
  {
    return 0;
  }
  const SolidCells kept = std::exchange(solid, inSphere);
  const int below = UntangleBelowCollar(untangling, centre, targets, progress.Part(0.8, 1.0));
  untangling.HasPatchCollar = below < left;
  if (!untangling.HasPatchCollar)
  {
    solid = kept;
  }
  return std::min(left, below);
}

UntangleResult BuildResult(Untangling& untangling, const Progress& progress)
{
  SolidCells& solid = untangling.Solid;
  UntangleResult result;
  result.Iterations = untangling.Iterations;
  result.Work = untangling.Work;
  result.Solid = solid.Result();
  ProvenanceWriter provenance(solid.OriginalPointCount);
  provenance.AddCopies(solid.OriginalPointCount);
  for (const std::array<int, 4>& parents : solid.Parents)
  {
    provenance.AddMean({ parents.begin(), std::find(parents.begin(), parents.end(), -1) });
  }
  result.Provenance = provenance.Finish(
    Eigen::Map<const Eigen::VectorXi>(solid.OriginalCells.data(), solid.CellCount()));
  result.Inverted = Eigen::VectorXi::Zero(solid.CellCount());
  for (const int cell : FindInverted(solid, progress))
  {
    result.Inverted(cell) = 1;
  }
  result.InvertedAfter = result.Inverted.sum();
  Eigen::VectorXi parts = Eigen::VectorXi::Zero(solid.CellCount());
  for (const int original : solid.OriginalCells)
  {
    ++parts(original);
  }
  result.SplitCells = static_cast<int>((parts.array() > 1).count());
  return result;
}

} // namespace

UntangleResult Untangle(const Cells& cells, const Eigen::MatrixXd& rest,
  const UntangleOptions& options, const Progress& progress)
{
  if (options.MaximumIterations < 1)
  {
    throw InvalidInput("MaximumIterations is " + std::to_string(options.MaximumIterations) +
      "; it must be at least 1");
  }
  RequireOption(options.MaximumWork > 0.0, "MaximumWork", options.MaximumWork, "positive");
  RequireOption(options.RefineExponent > 0.0 && std::isfinite(options.RefineExponent),
    "RefineExponent", options.RefineExponent, "positive");
  RequireFinite(cells.Points, "the Input");
  if (rest.rows() > 0)
  {
    RequireFinite(rest, "the RestShape");
    if (rest.rows() != cells.Points.rows())
    {
      throw InvalidInput("the RestShape has " + std::to_string(rest.rows()) +
        " points, but the Input has " + std::to_string(cells.Points.rows()) +
        "; give the cells of the Input before they were moved");
    }
    RequireExtent(rest, "the RestShape");
  }
  Untangling best = BeginUntangling(cells, rest, options, progress.Part(0.0, 0.0));
  const auto invertedBefore =
    static_cast<int>(FindInverted(best.Solid, progress.Part(0.0, 0.0)).size());
  const bool isRefined = options.Refine != RefineType::None;
  const Progress untangling = progress.Part(0.0, isRefined ? 0.6 : 1.0);
  int left = 0;
  const StarPlacement centre = invertedBefore > 0 ? FindStar(best.Solid, options) : StarPlacement();
  if (best.Solid.HasTetrahedra() && !centre.IsValid)
  {
    left = ReduceAndExpand(best, PatienceBeforeExpansion, untangling.Part(0.0, 0.7));
  }
  else
  {
    left = ReduceInverted(best, centre.IsValid ? PatienceBeforeExpansion : Patience,
      untangling.Part(0.0, 0.4, "untangling the inverted cells"));
  }
  if (left > 0 && centre.IsValid)
  {
    Untangling other = BeginUntangling(cells, rest, options, untangling.Part(0.4, 0.4));
    other.Work = best.Work;
    const int others = UntangleStar(other, centre.Position, untangling.Part(0.4, 0.6));
    best.Work = other.Work;
    if (others < left)
    {
      best = std::move(other);
      left = others;
    }
    if (left > 0 && !best.HasPatchCollar)
    {
      left = ReduceAndExpand(best, PatienceBeforeExpansion, untangling.Part(0.6, 0.7));
    }
  }
  if (left > 0 && !best.HasPatchCollar && best.HasWork())
  {
    Untangling other = BeginUntangling(cells, rest, options, untangling.Part(0.7, 0.7));
    other.Work = best.Work;
    // Restarts with each inner point at the mean of its neighbours.
    other.Solid.Points = SolveTutteEmbedding(other.Solid, untangling.Part(0.7, 0.7));
    const int others =
      ReduceAndExpand(other, Patience, untangling.Part(0.7, 0.95, "untangling from another start"));
    best.Work = other.Work;
    if (others < left)
    {
      best = std::move(other);
    }
  }
  InjectiveRefinementResult refined;
  if (isRefined)
  {
    InjectiveRefinementOptions refinement;
    refinement.Measure = GetMeasure(options.Refine);
    refinement.Exponent = options.RefineExponent;
    refined = RefineSolid(best.Solid, best.Sliding.get(), refinement,
      progress.Part(0.6, 1.0, "lowering the distortion"));
  }
  UntangleResult result = BuildResult(best, progress.Part(1.0, 1.0));
  result.MeasureBefore = refined.StartEnergy;
  result.MeasureAfter = refined.Energy;
  result.RefineIterations = refined.Iterations;
  result.InvertedBefore = invertedBefore;
  result.ExpandedPoints = best.Expansions;
  if (result.InvertedAfter > 0 && options.FixBoundary)
  {
    const BoundaryFaults faults =
      FindBoundaryFaults(best.Solid, progress.Part(1.0, 1.0, "looking for crossings"));
    result.BoundaryCrossings = faults.BoundaryCrossings;
    result.FirstCrossing = faults.FirstCrossing;
    result.FoldedEdges = faults.FoldedEdges;
    result.FirstFolded = faults.FirstFolded;
    result.HiddenTriangles = faults.HiddenTriangles;
    result.FirstHidden = faults.FirstHidden;
    result.StarClearance = faults.StarClearance;
  }
  progress(1.0);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    result.MovedPoints += result.Solid.Points.row(i) != cells.Points.row(i);
  }
  return result;
}

} // namespace shape
