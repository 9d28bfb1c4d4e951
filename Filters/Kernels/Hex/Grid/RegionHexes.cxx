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
constexpr int MaximumGrids = 3;    ///< number of grids that are fitted
constexpr int MaximumCompared = 4; ///< number of grids whose curves are compared before a fit
/// Cells are at most this much smaller than a given size, if larger ones lack the topology.
constexpr double SmallestShare = 0.25;

/// Cells of a grid, and the number of curves and junctions of the surfaces that they have.
struct RegionGrid
{
  LabelledCells Cells;
  double Size = 0.0;
  int Kept = 0;
  std::string Difference; ///< why larger cells were not taken: see TouchingRegionVoxels; or empty
};

/// Returns cells of at most this size with the topology of the regions: of the first grids, as many
/// as `compared`, the largest that have all curves and junctions of the surfaces, or else those
/// that have most.
std::optional<RegionGrid> FindGrid(TouchingRegionVoxels& voxels, const RegionTargets& targets,
  double size, double minimum, int compared, const Progress& progress)
{
  std::optional<RegionGrid> best;
  std::string difference;
  for (int grids = 0; grids < compared && size >= minimum * (1.0 - 1e-9); size *= Shrinkage)
  {
    std::optional<LabelledCells> cells = voxels.Fill(size, progress);
    if (!cells)
    {
      difference = voxels.Difference();
      continue;
    }
    ++grids;
    const RegionMatch match =
      MatchRegions(cells->Solid, FindRegionFaces(cells->Solid, cells->RegionOf), targets, size);
    const int kept = match.CurvesKept + match.JunctionsKept;
    if (!best || kept > best->Kept)
    {
      best = RegionGrid{ std::move(*cells), size, kept, difference };
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
  fitting.Draft = options.Draft;
  const bool isGiven = options.CellSize > 0.0;
  const double minimum =
    isGiven ? SmallestShare * options.CellSize : voxels.CellSizeFor(options.MaximumHexahedra);
  double size = isGiven
    ? options.CellSize
    : voxels.CellSizeFor(std::min<double>(options.FirstHexahedra, options.MaximumHexahedra));
  std::optional<RegionHexesResult> best;
  std::string why;
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
    if (!grid->Difference.empty())
    {
      why = "larger ones lack the topology of all regions (" + grid->Difference + ")";
    }
    size = QualityShrinkage * grid->Size;
    if (best && best->Fit.Inverted == 0 && grid->Kept < best->CurvesKept + best->JunctionsKept)
    {
      continue; // its fit would not be better (IsBetter)
    }
    RegionHexesResult result;
    static_cast<RegionFit&>(result) = FitRegions(grid->Cells, targets, fitting,
      goals.AcceptedDistance, progress.Part(begin, end, "fitting the grid to the surfaces"));
    result.CellSize = grid->Size;
    result.WhySmaller = why;
    if (!best || IsBetter(result, *best))
    {
      best = std::move(result);
    }
    // The size of cells is a decision on their number: only inverted hexahedra make them smaller
    // than given.
    if (isGiven || options.Draft ? best->Fit.Inverted == 0 : IsGood(*best))
    {
      break;
    }
    if (best->Fit.Inverted > 0)
    {
      why = "hexahedra of larger ones stay inverted";
    }
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
