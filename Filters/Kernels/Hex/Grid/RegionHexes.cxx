#include "Hex/Grid/RegionHexes.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Hex/Features/RegionMatch.h"
#include "Hex/Grid/Private/GridGoals.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The factor by which they shrink if hexahedra are bad.
constexpr double QualityShrinkage = 0.8;
/// From this minimum scaled Jacobian on, cells are not made smaller.
constexpr double GoodScaledJacobian = 0.3;
constexpr int MaximumGrids = 3;    ///< number of grids that are fitted
constexpr int MaximumCompared = 4; ///< number of grids whose curves are compared before a fit
/// Cells are at most this much smaller than a given size, if larger ones lack the topology.
constexpr double SmallestShare = 0.25;

/// The minimum scaled Jacobian of the hexahedra that are not near curves where interfaces meet.
double FindMinimumAwayFromCurves(const RegionFit& result)
{
  std::vector<char> marked(result.Fit.Solid.Points.rows(), 0);
  for (const int point : result.CurvePoints)
  {
    marked[point] = 1;
  }
  constexpr int rings = 2; // the layers along the interfaces
  GrowRings(result.Fit.Solid.Hexahedra, rings, marked);
  std::vector<int> near;
  for (int point = 0; point < static_cast<int>(marked.size()); ++point)
  {
    if (marked[point])
    {
      near.push_back(point);
    }
  }
  return FindMinimumScaledJacobianAwayFrom(near, result.Fit.Solid);
}

/// Whether smaller cells are not worth their number. Where interfaces meet at small angles, so do
/// hexahedra of any size: these may be worse if all curves are followed.
bool IsAccepted(const RegionFit& result)
{
  const bool isComplete =
    result.CurvesKept == result.Curves && result.JunctionsKept == result.Junctions;
  return result.Fit.Inverted == 0 &&
    (result.Fit.MinimumScaledJacobian >= GoodScaledJacobian ||
      (isComplete && FindMinimumAwayFromCurves(result) >= GoodScaledJacobian));
}

/// Cells of a grid, and the number of curves and junctions of the surfaces that they have.
struct RegionGrid
{
  LabelledCells Cells;
  double Size = 0.0;
  int Kept = 0;
};

/// Returns cells of at most this size with the topology of the regions: of the first grids, as many
/// as `compared`, the largest that have all curves and junctions of the surfaces, or else those
/// that have most.
std::optional<RegionGrid> FindGrid(TouchingRegionVoxels& voxels, const RegionTargets& targets,
  double size, double minimum, int compared, const Progress& progress)
{
  std::optional<RegionGrid> best;
  for (int grids = 0; grids < compared && size >= minimum * (1.0 - 1e-9); size *= Shrinkage)
  {
    std::optional<LabelledCells> cells = voxels.Fill(size, progress);
    if (!cells)
    {
      continue;
    }
    ++grids;
    const RegionMatch match =
      MatchRegions(cells->Solid, FindRegionFaces(cells->Solid, cells->RegionOf), targets, size);
    const int kept = match.CurvesKept + match.JunctionsKept;
    if (!best || kept > best->Kept)
    {
      best = RegionGrid{ std::move(*cells), size, kept };
    }
    if (kept == match.Curves + match.Junctions)
    {
      break;
    }
  }
  return best;
}

bool IsBetter(const RegionFit& one, const RegionFit& other)
{
  // An inverted hexahedron outweighs all, and a missing curve the quality of the others.
  const auto rank = [](const RegionFit& result)
  {
    return std::tuple(-result.Fit.Inverted, result.CurvesKept + result.JunctionsKept,
      result.Fit.MinimumScaledJacobian);
  };
  return rank(one) > rank(other);
}

} // namespace

RegionHexesResult BuildRegionHexahedra(
  const LabelledSurfaces& regions, const GridHexesOptions& options, const Progress& progress)
{
  RequireInRange(options);
  Mesh surfaces = regions.Surfaces;
  surfaces.Points = regions.Surfaces.Points * regions.Frame;
  TouchingRegionVoxels voxels(
    surfaces, regions.Labels, progress.Part(0.0, 0.05, "measuring the surfaces"));
  const RegionTargets targets(surfaces, regions.Labels);
  const double diagonal = ComputeBoxDiagonal(surfaces.Points);
  const GridGoals goals(options, diagonal);
  HexFitOptions fitting;
  fitting.PaddingLayers = options.PaddingLayers;
  const bool isGiven = options.CellSize > 0.0;
  const double minimum =
    isGiven ? SmallestShare * options.CellSize : voxels.CellSizeFor(options.MaximumHexahedra);
  double size = isGiven
    ? options.CellSize
    : voxels.CellSizeFor(std::min<double>(options.FirstHexahedra, options.MaximumHexahedra));
  std::optional<RegionHexesResult> best;
  double begin = 0.05;
  for (int grids = 0; grids < MaximumGrids; ++grids)
  {
    // Most searches end after the first grid.
    const double end = 0.5 * (begin + 1.0);
    const std::optional<RegionGrid> grid =
      FindGrid(voxels, targets, size, minimum, isGiven ? 1 : MaximumCompared,
        progress.Part(begin, begin, "filling the regions with a grid"));
    if (!grid)
    {
      break;
    }
    RegionHexesResult result;
    static_cast<RegionFit&>(result) = FitRegions(grid->Cells, targets, fitting,
      goals.AcceptedDistance, progress.Part(begin, end, "fitting the grid to the surfaces"));
    result.CellSize = grid->Size;
    if (!best || IsBetter(result, *best))
    {
      best = std::move(result);
    }
    // The size of cells is a decision on their number: only inverted hexahedra make them smaller
    // than given.
    if (isGiven ? best->Fit.Inverted == 0 : IsAccepted(*best))
    {
      break;
    }
    size = QualityShrinkage * grid->Size;
    begin = end;
  }
  if (!best)
  {
    throw SolveFailure("no grid of cells of at least " + FormatNumber(minimum) +
      " has the topology of all regions (" + voxels.Difference() +
      "); set a smaller CellSize, or dissolve islands of the labels");
  }
  best->Fit.Solid.Points = (best->Fit.Solid.Points * regions.Frame.transpose()).eval();
  best->Fit.Constraint = nullptr; // it holds the points in the frame
  best->Fit.MinimumScaledJacobian = ComputeScaledJacobians(best->Fit.Solid).minCoeff();
  progress(1.0);
  return std::move(*best);
}

} // namespace shape
