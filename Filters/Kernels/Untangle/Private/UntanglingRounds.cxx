#include "Untangle/Private/UntanglingRounds.h"

#include "Untangle/MinimizeEnergy.h"
#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/ConeExpansion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace shape
{
namespace
{

/// The number of rings of points around inverted cells that move, in successive rounds. Cells that
/// stay inverted are split at one edge from FirstSplitting on, and all around from FirstCollar on.
constexpr int Rings[] = { 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 8, 8, 12, 12, 16, 16 };
constexpr int FirstSplitting = 1, FirstCollar = 2;
constexpr int Rounds = static_cast<int>(std::size(Rings));
/// A patch is given up after this many Newton steps without progress.
constexpr int StepPatience = 40;
/// A state with this many times more inverted cells than the best is abandoned.
constexpr std::size_t MaximumIncrease = 2;
/// After this many consecutive rounds the edges of a fixed point may be split again.
constexpr int RoundsPerCollar = 4;

/// Minimises the energy of a patch with the work that is left. If that is less than a step needs,
/// all work counts as done.
PatchResult MovePatch(
  Untangling& untangling, const SimplexPatch& patch, PatchOptions options, const Progress& progress)
{
  const double step = std::pow(static_cast<double>(patch.FreePoints.size()), 1.5);
  // The search for a smoother start counts as one step.
  const double steps = std::floor((untangling.MaximumWork - untangling.Work) / step) - 1.0;
  if (steps < 1.0)
  {
    untangling.Work = untangling.MaximumWork;
    return { 0, CountNegative(patch, untangling.Solid.Points), 0.0, 0.0 };
  }
  options.MaximumSteps = static_cast<int>(std::min<double>(options.MaximumSteps, steps));
  const PatchResult moved =
    MinimizeEnergy(untangling.Solid.Points, patch, untangling.Sliding.get(), options, progress);
  untangling.Iterations += moved.Steps;
  // The last step may have ended the iteration without being counted.
  untangling.Work += (std::min(moved.Steps + 1, options.MaximumSteps) + 1.0) * step;
  return moved;
}

/// Lowers the energy around the points that an expansion moved, without inverting a cell.
void ImproveMoved(Untangling& untangling, const Eigen::MatrixXd& before, const Progress& progress)
{
  SolidCells& solid = untangling.Solid;
  std::vector<char> marked(solid.PointCount(), 0);
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    marked[point] = point >= before.rows() || solid.Points.row(point) != before.row(point);
  }
  const Progress begun = progress.Part(0.0, 0.0);
  const Eigen::VectorXd sizes = ComputeLogarithmicSizes(solid, begun);
  const std::vector<std::vector<int>> patches = FindMovablePatches(
    solid, marked, [&](int point) { return untangling.IsMovable(point); }, begun);
  PatchOptions options;
  options.FurtherSteps = 20;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    const Progress part =
      progress.Part(static_cast<double>(i) / patches.size(), (i + 1.0) / patches.size());
    const SimplexPatch patch = BuildPatch(solid, patches[i], sizes, part.Part(0.0, 0.0));
    if (CountNegative(patch, solid.Points) > 0)
    {
      continue;
    }
    const Eigen::MatrixXd kept = solid.Points(patches[i], Eigen::all);
    const PatchResult moved = MovePatch(untangling, patch, options, part);
    if (moved.Negative > 0)
    {
      solid.Points(patches[i], Eigen::all) = kept;
    }
  }
}

} // namespace

void MovePoints(Untangling& untangling, int rings, const Progress& progress)
{
  SolidCells& solid = untangling.Solid;
  const Progress begun = progress.Part(0.0, 0.0);
  const Eigen::VectorXd sizes = ComputeLogarithmicSizes(solid, begun);
  const std::vector<std::vector<int>> patches = FindMovablePatches(
    solid, MarkAroundInverted(solid, rings, begun),
    [&](int point) { return untangling.IsMovable(point); }, begun);
  PatchOptions options;
  options.MaximumSteps = untangling.MaximumIterations;
  options.Patience = StepPatience;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    const Progress part =
      progress.Part(static_cast<double>(i) / patches.size(), (i + 1.0) / patches.size());
    const SimplexPatch patch = BuildPatch(solid, patches[i], sizes, part.Part(0.0, 0.0));
    const int before = CountNegative(patch, solid.Points);
    if (before == 0)
    {
      continue;
    }
    const Eigen::MatrixXd kept = solid.Points(patches[i], Eigen::all);
    const PatchResult moved = MovePatch(untangling, patch, options, part);
    if (moved.Negative > before)
    {
      solid.Points(patches[i], Eigen::all) = kept;
    }
  }
}

int ReduceInverted(Untangling& untangling, int patience, const Progress& progress)
{
  SolidCells& solid = untangling.Solid;
  progress(0.02);
  std::vector<int> bad =
    FindInverted(solid, progress.Part(0.02, 0.05, "looking for inverted cells"));
  CellSplits splits(solid, [&](int point) { return untangling.IsMovable(point); });
  std::size_t minimum = bad.size();
  auto best = bad.empty() ? nullptr : std::make_unique<SolidCells>(solid);
  for (int round = 0, last = 0;
       round < Rounds && !bad.empty() && round <= last + patience && untangling.HasWork(); ++round)
  {
    const Progress part =
      progress.Part(0.05 + 0.9 * round / Rounds, 0.05 + 0.9 * (round + 1.0) / Rounds);
    const Progress begun = part.Part(0.0, 0.0), ended = part.Part(1.0, 1.0);
    if (untangling.SplitCells)
    {
      splits.Impossible(bad, begun);
    }
    if (untangling.SplitCells && round >= FirstSplitting)
    {
      splits.Stubborn(FindInverted(solid, begun),
        round < FirstCollar ? 0 : 1 + (round - FirstCollar) / RoundsPerCollar, begun);
    }
    MovePoints(untangling, Rings[round], part);
    bad = FindInverted(solid, ended);
    if (bad.size() < minimum)
    {
      minimum = bad.size();
      last = round;
      *best = solid;
    }
    else if (bad.size() > MaximumIncrease * minimum)
    {
      solid = *best;
      bad = FindInverted(solid, ended);
    }
  }
  if (bad.size() > minimum)
  {
    solid = *best;
    bad = FindInverted(solid, progress.Part(1.0, 1.0));
  }
  progress(1.0);
  return static_cast<int>(bad.size());
}

int ReduceAndExpand(Untangling& untangling, int patience, const Progress& progress)
{
  SolidCells& solid = untangling.Solid;
  constexpr int turns = 4;
  ConeExpansionOptions expansion;
  expansion.SplitCells = untangling.SplitCells;
  int left = 0;
  for (int turn = 0; turn < turns; ++turn)
  {
    const Progress part = progress.Part(static_cast<double>(turn) / turns, (turn + 1.0) / turns);
    const int last = left;
    left = ReduceInverted(untangling, turn == 0 ? patience : PatienceBeforeExpansion,
      part.Part(0.0, 0.4, "untangling the inverted cells"));
    if (left == 0)
    {
      break;
    }
    const Eigen::MatrixXd before = solid.Points.topRows(solid.PointCount());
    const ConeExpansionResult expanded =
      ExpandInverted(solid, expansion, part.Part(0.4, 0.9, "placing points by exact tests"));
    untangling.Expansions += expanded.Expansions;
    left = static_cast<int>(FindInverted(solid, part.Part(0.9, 0.9)).size());
    ImproveMoved(untangling, before, part.Part(0.9, 1.0, "improving the cells"));
    // A turn that has changed nothing would only be repeated.
    if (left == 0 || !untangling.HasWork() || (expanded.Expansions == 0 && left == last))
    {
      break;
    }
  }
  return left;
}

} // namespace shape
