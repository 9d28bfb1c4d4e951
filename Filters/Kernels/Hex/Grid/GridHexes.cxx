#include "Hex/Grid/GridHexes.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Distance/HausdorffDistance.h"
#include "Hex/Grid/Private/FillWithCurves.h"
#include "Hex/Grid/Private/GridGoals.h"
#include "Hex/Grid/Private/SeparateSolids.h"
#include "Hex/Voxels/GridDensity.h"
#include "Hex/Voxels/MultiMaterialVoxels.h"
#include "Quality/ScaledJacobian.h"
#include "Remesh/SurfaceFeatures.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The factor by which the number of hexahedra grows in the next grids of an automatic size; the
/// second applies if most of the solid needs smaller cells.
constexpr double Growth = 1.4, LargeGrowth = 3.0;
/// From this minimum scaled Jacobian on, further sweeps are likely to reach the accepted one.
constexpr double RaisedFrom = 0.4;
/// The gain of the score that smaller cells must bring, or still smaller ones are not tried.
constexpr double LeastGain = 0.02;
/// The search ends after this many rounds without such a gain.
constexpr int MaximumIdleSteps = 2;

/// The surfaces that bound the solid and its regions.
struct GridBoundary
{
  Surface Outer;
  std::vector<Surface> Inner;
};

/// Updates the distance of the interfaces, whose points may have moved with the boundary's.
void MeasureInner(HexFit& fit, const GridBoundary& boundary)
{
  fit.InnerDistance = ComputeInterfaceDistance(fit.Solid.Points, fit.Interfaces, boundary.Inner);
}

/// Snaps the boundary to parts of the surface that are farther than wanted. minimum: of the scaled
/// Jacobian.
void Snap(GridHexesResult& result, const GridBoundary& boundary, const GridGoals& goals,
  const Progress& progress, double minimum = AcceptedScaledJacobian)
{
  if (result.Fit.Inverted == 0 && result.Fit.Distance > goals.SnapFrom)
  {
    SnappingOptions options;
    options.WantedDistance = goals.Distance;
    options.ScaledJacobians = { goals.ScaledJacobian, minimum };
    SnapToSurface(result.Fit, boundary.Outer, options, progress);
    MeasureInner(result.Fit, boundary);
  }
}

/// Lets points leave the surface at bad hexahedra. With creases, whose corners may be the reason,
/// or with inner surfaces, which points would leave too, it does so only at inverted ones.
void Release(GridHexesResult& result, const GridBoundary& boundary, const GridGoals& goals,
  const Progress& progress)
{
  const bool hasCreases = !result.Fit.Followed.empty();
  const bool isSmooth = !hasCreases && boundary.Inner.empty();
  if (result.Fit.Inverted > 0 ||
    (isSmooth && result.Fit.MinimumScaledJacobian < AcceptedScaledJacobian))
  {
    RelaxBoundaryAroundBad(
      result.Fit, boundary.Outer, goals.AcceptedDistance, progress.Part(0.0, 0.9));
    MeasureInner(result.Fit, boundary);
  }
}

/// Applies `change` to the result. Undone unless the score rises.
template <typename Change>
void ChangeIfBetter(GridHexesResult& result, const GridGoals& goals, const Change& change)
{
  GridHexesResult changed = result;
  change(changed);
  if (Score(changed, goals) > Score(result, goals))
  {
    result = std::move(changed);
  }
}

/// Adds seeds where the surfaces or their creases are far from each other, at corners of patches
/// that are too small for the cells, and at bad hexahedra. Returns whether the seeds cover most of
/// the solid. features: include patches of any size.
bool AddSeeds(const GridHexesResult& result, const GridBoundary& boundary,
  const SurfaceFeatures& features, const GridGoals& goals, std::vector<RefinementSeed>& seeds,
  const Progress& progress)
{
  const HexMesh& solid = result.Fit.Solid;
  RefinementSeeds positions(result.CellSize);
  const auto addFarOnSurface = [&](const Surface& surface, const Eigen::MatrixXi& quads)
  {
    positions.AddDistant(
      ComputeDistancesToSurface(surface, SurfaceLocator({ solid.Points, SplitQuads(quads) }),
        progress, RefinementSeeds::DistantShare * goals.Distance),
      goals.Distance);
  };
  addFarOnSurface(boundary.Outer, result.Fit.Quads);
  for (std::size_t i = 0; result.InnerCreasesKept && i < boundary.Inner.size(); ++i)
  {
    addFarOnSurface(boundary.Inner[i], result.Fit.Interfaces[i]);
  }
  if (result.Fit.CreasesKept || !result.Fit.Followed.empty())
  {
    // Creases that were given up are far: the next grid has smaller cells there.
    positions.AddDistant(ComputeDistancesToCurves(boundary.Outer, result.Features, solid.Points,
                           result.Fit.Quads, result.Fit.PatchOf),
      goals.CreaseDistance);
  }
  for (const int corner : features.Corners)
  {
    if (!result.Features.Curves.empty() &&
      !std::binary_search(result.Features.Corners.begin(), result.Features.Corners.end(), corner))
    {
      positions.Add(boundary.Outer.Points().row(corner));
    }
  }
  positions.AddBad(solid, AcceptedScaledJacobian);
  seeds.insert(seeds.end(), positions.Seeds().begin(), positions.Seeds().end());
  return positions.AreMostOf(solid.Hexahedra.rows());
}

/// Returns the hexahedra for cells of this size, or of a smaller one that has the topology; nothing
/// if there would be more than MaximumHexahedra.
std::optional<GridHexesResult> FillGrid(MultiMaterialVoxels& regions, const GridBoundary& boundary,
  const GridHexesOptions& options, double size, const GridDensity& warp, const Progress& progress)
{
  HexFitOptions fitting;
  fitting.PaddingLayers = options.PaddingLayers;
  fitting.MaximumHexahedra = options.MaximumHexahedra;
  fitting.RaisedFrom = RaisedFrom;
  fitting.Draft = options.Draft;
  if (options.Draft)
  {
    fitting.MinimumWithFeatures = 0.0; // a second fit would take as long again
  }
  const double minimum = regions.Outer().CellSizeFor(options.MaximumHexahedra, warp);
  for (; size >= minimum * (1.0 - 1e-9); size *= Shrinkage)
  {
    if (std::optional<GridCells> cells = FillWithCurves(regions, boundary.Outer, options, size,
          minimum * (1.0 - 1e-9), warp, progress.Part(0.0, 0.1, "filling the surface with a grid")))
    {
      GridHexesResult result;
      result.CellSize = cells->Size;
      result.Crossings = regions.Outer().Boundary().Crossings;
      result.Features = std::move(cells->Features);
      HexMeshOptions ofInner = options;
      ofInner.Patches.resize(0); // those of the outer surface
      result.InnerCreasesKept = std::all_of(boundary.Inner.begin(), boundary.Inner.end(),
        [&](const Surface& inner)
        { return FindFeatures(inner, ofInner, cells->Size).Curves.empty(); });
      result.Fit = FitHexahedra(cells->Cells.Solid, boundary.Outer, result.Features, fitting,
        progress.Part(0.1, 1.0, "fitting the grid to the surface"),
        { &cells->Cells, &boundary.Inner });
      result.FollowedShare = ComputeFollowedShare(result.Fit, boundary.Outer, result.Features);
      return result;
    }
  }
  return std::nullopt;
}

/**
 * A search for the best hexahedra of several grids. Order of calls: Refine, once for each size to
 * try, with BestScore and HasAccepted in between; TakeAnyTopology; Result, once.
 */
class GridSearch
{
public:
  GridSearch(const Surface& surface, const std::vector<Surface>& innerSurfaces,
    const GridHexesOptions& options, const Progress& progress)
    : Options(options)
    , Regions(surface, innerSurfaces, progress)
    , Boundary{ this->Regions.Outer().Boundary().Surface, this->Regions.InnerSurfaces() }
    , Goals(options,
        options.Diagonal > 0.0 ? options.Diagonal
                               : ComputeBoxDiagonal(this->Regions.Outer().GetSurface().Points()))
    , AllFeatures(FindFeatures(this->Boundary.Outer, options, 0.0))
  {
  }

  double CellSizeFor(double hexahedra, const GridDensity& warp) const
  {
    return this->Regions.Outer().CellSizeFor(hexahedra, warp);
  }

  /// Makes grids in rounds, each finer where the previous one was not good enough. size: of the
  /// cells in the first grid; 0: a size that gives about `hexahedra` in each. Returns the factor by
  /// which the number of hexahedra should grow next.
  double Refine(double size, double hexahedra, int rounds, const Progress& progress)
  {
    std::vector<RefinementSeed> seeds = this->Options.Seeds;
    double growth = Growth;
    double reached = -std::numeric_limits<double>::infinity();
    int idle = 0; // rounds without a gain
    for (int round = 0; round < rounds; ++round)
    {
      const GridDensity warp(seeds);
      // Most searches end after few rounds: each gets half of what is left.
      const double left = std::exp2(-round);
      const Progress part = progress.Part(1.0 - left, round + 1 < rounds ? 1.0 - 0.5 * left : 1.0);
      const double first = size > 0.0 ? size : this->CellSizeFor(hexahedra, warp);
      std::optional<GridHexesResult> result = FillGrid(this->Regions, this->Boundary, this->Options,
        std::min(first, this->LargestSize), warp, part.Part(0.0, 0.8));
      if (!result)
      {
        break;
      }
      this->LargestSize = result->CellSize / Shrinkage;
      const std::size_t before = seeds.size();
      bool isSnapped = this->Options.Draft || IsAsWanted(*result, this->Goals);
      if (!isSnapped)
      {
        if (AddSeeds(*result, this->Boundary, this->AllFeatures, this->Goals, seeds,
              part.Part(0.8, 0.8, "finding where to refine the grid")))
        {
          growth = LargeGrowth;
        }
        isSnapped = this->IsWorthSnapping(*result);
        if (isSnapped)
        {
          Snap(*result, this->Boundary, this->Goals,
            part.Part(0.8, 1.0, "moving the boundary onto the surface"));
        }
      }
      // If nothing is magnified, the next grid would be the same.
      const bool isLast =
        seeds.size() == before || IsAsWanted(*result, this->Goals) || growth > Growth;
      ++this->Rounds;
      const double score = Score(*result, this->Goals);
      idle = score < reached + LeastGain ? idle + 1 : 0;
      reached = std::max(reached, score);
      if (score > this->BestScore())
      {
        this->Best = std::move(*result);
        this->BestIsSnapped = isSnapped;
      }
      if (isLast || idle >= MaximumIdleSteps)
      {
        break;
      }
    }
    if (this->Best && !this->BestIsSnapped && (size > 0.0 || IsNear(*this->Best, this->Goals)))
    {
      Snap(*this->Best, this->Boundary, this->Goals,
        progress.Part(0.9, 1.0, "moving the boundary onto the surface"));
      this->BestIsSnapped = true;
    }
    return growth;
  }

  /// If the surface crosses itself and there is no result yet, accepts any Euler number and number
  /// of components.
  void TakeAnyTopology(const Progress& progress)
  {
    if (!this->Best && this->Regions.Outer().Boundary().Crossings > 0)
    {
      constexpr double share = 0.25; // fraction of MaximumHexahedra
      this->Regions.Outer().TakeAnyTopology();
      this->Refine(0.0, share * this->Options.MaximumHexahedra, 1, progress);
      if (this->Best)
      {
        this->Best->TopologyAgreed = false;
      }
    }
  }

  /// Whether no further grid is needed: for a draft, any valid one is good enough.
  bool HasAccepted() const
  {
    return this->Best &&
      (this->Options.Draft ? this->Best->Fit.Inverted == 0 : IsAccepted(*this->Best, this->Goals));
  }

  /// Minus infinity if there is no result yet.
  double BestScore() const
  {
    return this->Best ? Score(*this->Best, this->Goals) : -std::numeric_limits<double>::infinity();
  }

  /// Returns the best result, after further sweeps on its worst hexahedra and on its distance.
  GridHexesResult Result(const Progress& progress)
  {
    if (!this->Best)
    {
      this->ThrowNoGrid();
    }
    GridHexesResult result = std::move(*this->Best);
    result.Rounds = this->Rounds;
    if (this->Options.Draft && result.Fit.Inverted == 0)
    {
      progress(1.0);
      return result;
    }
    if (result.Fit.Inverted == 0 && result.Fit.MinimumScaledJacobian < AcceptedScaledJacobian)
    {
      ChangeIfBetter(result, this->Goals,
        [&](GridHexesResult& raised)
        {
          ImproveWorst(raised.Fit, this->Boundary.Outer,
            progress.Part(0.0, 0.3, "improving the worst hexahedra"));
          MeasureInner(raised.Fit, this->Boundary);
        });
    }
    Release(
      result, this->Boundary, this->Goals, progress.Part(0.3, 0.5, "releasing boundary points"));
    if (!Reaches(result, 0.0, this->Goals.AcceptedDistance) && IsNear(result, this->Goals))
    {
      // At the expense of hexahedra, whose points may then leave the surface.
      constexpr double minimum = 0.2;
      ChangeIfBetter(result, this->Goals,
        [&](GridHexesResult& snapped)
        {
          Snap(snapped, this->Boundary, this->Goals,
            progress.Part(0.5, 0.85, "moving the boundary onto the surface"), minimum);
          Release(snapped, this->Boundary, this->Goals,
            progress.Part(0.85, 1.0, "releasing boundary points"));
        });
    }
    progress(1.0);
    return result;
  }

private:
  [[noreturn]] void ThrowNoGrid() const
  {
    const Topology& topology = this->Regions.Outer().SurfaceTopology();
    throw SolveFailure("no grid of at most " + std::to_string(this->Options.MaximumHexahedra) +
      " hexahedra has the topology of the surface (Euler number " +
      std::to_string(topology.EulerNumber) + ", " + std::to_string(topology.Components) +
      (topology.Components == 1 ? " component)" : " components)") +
      (this->Boundary.Inner.empty() ? "" : " and keeps the inner surfaces apart") +
      "; a part or gap is thinner than the cells: set a smaller CellSize, thicken the part or "
      "widen "
      "the gap");
  }

  /// Whether snapping is likely to reach the wanted quality, or the accepted quality if no result
  /// is accepted yet.
  bool IsWorthSnapping(const GridHexesResult& result) const
  {
    return Reaches(result,
      this->HasAccepted() ? this->Goals.ScaledJacobian : AcceptedScaledJacobian,
      this->Goals.NearDistance);
  }

  const GridHexesOptions& Options;
  MultiMaterialVoxels Regions;
  const GridBoundary Boundary;
  const GridGoals Goals;
  const SurfaceFeatures AllFeatures; ///< includes patches of any size
  /// Larger cells did not have the topology.
  double LargestSize = std::numeric_limits<double>::infinity();
  std::optional<GridHexesResult> Best;
  bool BestIsSnapped = false;
  int Rounds = 0;
};

void RequireGridInRange(const GridHexesOptions& options)
{
  RequireInRange(options);
  RequireOption(options.Rounds >= 1, "Rounds", options.Rounds, "at least 1");
  RequireOption(options.WantedCreaseDistance > 0.0, "WantedCreaseDistance",
    options.WantedCreaseDistance, "positive");
  RequireOption(options.WantedDistance > 0.0, "WantedDistance", options.WantedDistance, "positive");
}

GridHexesResult OfOneGrid(const Surface& surface, const GridHexesOptions& options,
  const Progress& progress, const std::vector<Surface>& innerSurfaces)
{
  GridSearch search(
    surface, innerSurfaces, options, progress.Part(0.0, 0.05, "measuring the surface"));
  if (options.CellSize > 0.0)
  {
    const double minimum = search.CellSizeFor(options.MaximumHexahedra, GridDensity(options.Seeds));
    if (options.CellSize < minimum)
    {
      throw InvalidInput("CellSize is " + FormatNumber(options.CellSize) +
        ", which gives more than " + std::to_string(options.MaximumHexahedra) +
        " hexahedra; use a CellSize of at least " + FormatNumber(minimum));
    }
    search.Refine(options.CellSize, 0.0, options.Rounds, progress.Part(0.05, 0.95));
    return search.Result(progress.Part(0.95, 1.0));
  }
  double begin = 0.05, before = -std::numeric_limits<double>::infinity();
  double hexahedra = std::min<double>(options.FirstHexahedra, options.MaximumHexahedra);
  int rounds = options.Rounds, idle = 0; // idle: grids without a gain
  while (hexahedra <= options.MaximumHexahedra && idle < MaximumIdleSteps)
  {
    const double end = 0.5 * (begin + 0.95);
    const double growth = search.Refine(0.0, hexahedra, rounds, progress.Part(begin, end));
    hexahedra *= growth;
    if (search.HasAccepted())
    {
      break;
    }
    const double score = search.BestScore();
    idle = std::isfinite(score) && score < before + LeastGain ? idle + 1 : 0;
    before = std::max(before, score);
    begin = end;
    rounds = growth > Growth ? 1 : (rounds + 1) / 2;
  }
  search.TakeAnyTopology(progress.Part(begin, 0.95));
  return search.Result(progress.Part(0.95, 1.0));
}

GridHexesResult OfSeveralGrids(const Surface& surface, const std::vector<SeparateSolid>& parts,
  const GridHexesOptions& options, const Progress& progress)
{
  std::vector<Surface> solids;
  for (const SeparateSolid& part : parts)
  {
    solids.push_back(part.Boundary);
  }
  const std::vector<double> shares = ComputeVolumeShares(solids);
  std::vector<HexFit> fits;
  std::vector<SurfaceFeatures> features;
  GridHexesResult result;
  double begin = 0.0;
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    GridHexesOptions own = options;
    own.Diagonal = options.Diagonal > 0.0 ? options.Diagonal : ComputeBoxDiagonal(surface.Points());
    own.FirstHexahedra = shares[i] * options.FirstHexahedra;
    own.MaximumHexahedra = std::max(1, static_cast<int>(shares[i] * options.MaximumHexahedra));
    if (options.Patches.size() > 0)
    {
      own.Patches = options.Patches(parts[i].Triangles);
    }
    GridHexesResult one = OfOneGrid(solids[i], own, progress.Part(begin, begin + shares[i]), {});
    begin += shares[i];
    fits.push_back(std::move(one.Fit));
    features.push_back(std::move(one.Features));
    result.CellSize = std::max(result.CellSize, one.CellSize);
    result.Rounds = std::max(result.Rounds, one.Rounds);
  }
  result.Fit = JoinFits(fits);
  result.Features = JoinFeatures(features, solids);
  return result;
}

} // namespace

GridHexesResult BuildGridHexahedra(const Surface& surface, const GridHexesOptions& options,
  const Progress& progress, const std::vector<Surface>& innerSurfaces)
{
  RequireGridInRange(options);
  if (innerSurfaces.empty())
  {
    const std::vector<SeparateSolid> solids =
      SplitSolids(surface, progress.Part(0.0, 0.02, "separating the solids"));
    if (!solids.empty())
    {
      return OfSeveralGrids(surface, solids, options, progress.Part(0.02, 1.0));
    }
  }
  return OfOneGrid(surface, options, progress.Part(0.02, 1.0), innerSurfaces);
}

} // namespace shape
