#include "Hex/Grid/RegionHexes.h"

#include "Base/Errors.h"
#include "Hex/Grid/Private/GridGoals.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The factor by which cells shrink if they do not have the regions' topology.
constexpr double TopologyShrinkage = 0.85;
/// The factor by which they shrink if hexahedra are bad.
constexpr double QualityShrinkage = 0.8;
/// From this minimum scaled Jacobian on, cells are not made smaller.
constexpr double GoodScaledJacobian = 0.3;
constexpr int MaximumGrids = 3; ///< number of grids with the topology
/// Cells are at most this much smaller than a given size.
constexpr double SmallestShare = 0.25;

bool IsBetterFit(const HexFit& one, const HexFit& other)
{
  return one.Inverted != other.Inverted ? one.Inverted < other.Inverted
                                        : one.MinimumScaledJacobian > other.MinimumScaledJacobian;
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
  for (int grids = 0; grids < MaximumGrids && size >= minimum * (1.0 - 1e-9);)
  {
    // Most searches end after the first grid with the topology.
    const double end = 0.5 * (begin + 1.0);
    const std::optional<LabelledCells> cells =
      voxels.Fill(size, progress.Part(begin, begin, "filling the regions with a grid"));
    if (!cells)
    {
      size *= TopologyShrinkage;
      continue;
    }
    RegionHexesResult result;
    static_cast<RegionFit&>(result) = FitRegions(*cells, surfaces, regions.Labels, fitting,
      goals.AcceptedDistance, progress.Part(begin, end, "fitting the grid to the surfaces"));
    result.CellSize = size;
    if (!best || IsBetterFit(result.Fit, best->Fit))
    {
      best = std::move(result);
    }
    if (best->Fit.Inverted == 0 && best->Fit.MinimumScaledJacobian >= GoodScaledJacobian)
    {
      break;
    }
    size *= QualityShrinkage;
    begin = end;
    ++grids;
  }
  if (!best)
  {
    throw SolveFailure("no grid of cells of at least " + std::to_string(minimum) +
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
