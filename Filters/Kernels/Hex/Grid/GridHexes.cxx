#include "Hex/Grid/GridHexes.h"

#include "Base/Errors.h"
#include "Distance/HausdorffDistance.h"
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

/// The factor by which cells shrink if they do not have the solid's topology.
constexpr double Shrinkage = 0.85;
/// The factor by which the number of hexahedra grows in the next grids of an automatic size; the
/// second applies if most of the solid needs smaller cells.
constexpr double Growth = 1.4, LargeGrowth = 3.0;
/// If the result is at least this good, cells are not made smaller everywhere.
constexpr double AcceptedScaledJacobian = 0.55, AcceptedDistance = 0.01;
/// From this minimum scaled Jacobian on, further sweeps are likely to reach the accepted one.
constexpr double RaisedFrom = 0.4;
/// What is farther than this multiple of the distance is not snapped to, but needs another grid.
constexpr double SnappedFrom = 2.0;
/// The gain of the score that smaller cells must bring, or still smaller ones are not tried.
constexpr double LeastGain = 0.02;
/// The search ends after this many rounds without such a gain.
constexpr int MaximumIdleSteps = 2;

class GridSearch
{
public:
  GridSearch(const Surface& surface, const std::vector<Mesh>& innerSurfaces,
    const GridHexesOptions& options, const Progress& progress)
    : Options(options)
    , Regions(surface, innerSurfaces, progress)
    , Cubes(this->Regions.Outer())
    , Bounding(this->Cubes.Boundary().Surface)
    , Diagonal(options.Diagonal > 0.0 ? options.Diagonal
                                      : ComputeBoxDiagonal(this->Cubes.GetSurface().Points()))
    , AllFeatures(FindFeatures(this->Bounding, options.FeatureAngle, 0.0))
  {
    for (const TopologyPreservingVoxels& inner : this->Regions.Inner())
    {
      this->InnerBounding.emplace_back(inner.GetSurface());
    }
  }

  double MinimumSize(const GridDensity& warp = GridDensity()) const
  {
    return this->Cubes.CellSizeFor(this->Options.MaximumHexahedra, warp);
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
      const Progress part =
        progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds);
      const double first = size > 0.0 ? size : this->Cubes.CellSizeFor(hexahedra, warp);
      std::optional<GridHexesResult> result =
        this->Fill(std::min(first, this->LargestSize), warp, part.Part(0.0, 0.8));
      if (!result)
      {
        break;
      }
      this->LargestSize = result->CellSize / Shrinkage;
      const std::size_t before = seeds.size();
      bool isSnapped = this->IsAsWanted(*result);
      if (!isSnapped)
      {
        if (this->AddSeeds(*result, seeds))
        {
          growth = LargeGrowth;
        }
        isSnapped = this->IsWorthSnapping(*result);
        if (isSnapped)
        {
          this->Snap(*result, part.Part(0.8, 1.0));
        }
      }
      // If nothing is magnified, the next grid would be the same.
      const bool isLast = seeds.size() == before || this->IsAsWanted(*result) || growth > Growth;
      ++this->Rounds;
      const double score = this->Score(*result);
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
    if (this->Best && !this->BestIsSnapped && (size > 0.0 || this->IsNear(*this->Best)))
    {
      this->Snap(*this->Best, progress.Part(0.9, 1.0));
      this->BestIsSnapped = true;
    }
    return growth;
  }

  /// If the surface crosses itself and there is no result yet, accepts any Euler number and number
  /// of components.
  void TakeAnyTopology(const Progress& progress)
  {
    if (!this->Best && this->Cubes.Boundary().Crossings > 0)
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

  bool IsAccepted() const
  {
    return this->Best &&
      (this->Reaches(*this->Best, AcceptedScaledJacobian, AcceptedDistance) ||
        this->AreOnlyCornersBad(*this->Best));
  }

  /// Minus infinity if there is no result yet.
  double BestScore() const
  {
    return this->Best ? this->Score(*this->Best) : -std::numeric_limits<double>::infinity();
  }

  GridHexesResult Result(const Progress& progress)
  {
    if (!this->Best)
    {
      const Topology& topology = this->Cubes.SurfaceTopology();
      throw SolveFailure("no grid of at most " + std::to_string(this->Options.MaximumHexahedra) +
        " hexahedra has the topology of the surface: Euler number " +
        std::to_string(topology.EulerNumber) + ", " + std::to_string(topology.Components) +
        (topology.Components == 1 ? " component" : " components") +
        (this->InnerBounding.empty() ? "" : ", and the inner surfaces separate from each other") +
        "; a part or gap is thinner than its cells: raise MaximumHexahedra, or thicken it");
    }
    const HexFit& fit = this->Best->Fit;
    if (fit.Inverted == 0 && fit.MinimumScaledJacobian < AcceptedScaledJacobian)
    {
      this->Raise(*this->Best, progress.Part(0.0, 0.3));
    }
    this->Release(*this->Best, progress.Part(0.3, 0.5));
    if (!this->Reaches(*this->Best, 0.0, AcceptedDistance) && this->IsNear(*this->Best))
    {
      this->SnapAndRelease(*this->Best, progress.Part(0.5, 1.0));
    }
    this->Best->Rounds = this->Rounds;
    progress(1.0);
    return std::move(*this->Best);
  }

private:
  /// Returns the hexahedra for cells of this size, or of a smaller one that has the topology.
  std::optional<GridHexesResult> Fill(
    double size, const GridDensity& warp, const Progress& progress)
  {
    const double minimum = this->MinimumSize(warp);
    for (; size >= minimum * (1.0 - 1e-9); size *= Shrinkage)
    {
      if (const std::optional<RegionCells> cells =
            this->Regions.Fill(size, warp, progress.Part(0.0, 0.1)))
      {
        GridHexesResult result;
        result.CellSize = size;
        result.Crossings = this->Cubes.Boundary().Crossings;
        result.Features = FindFeatures(this->Bounding, this->Options, size);
        result.InnerCreasesKept =
          std::all_of(this->InnerBounding.begin(), this->InnerBounding.end(),
            [&](const Surface& inner)
            { return FindFeatures(inner, this->Options, size).Curves.empty(); });
        result.Fit = FitHexahedra(cells->Solid, this->Bounding, result.Features, this->FitOptions(),
          progress.Part(0.1, 1.0), { &*cells, &this->InnerBounding });
        return result;
      }
    }
    return std::nullopt;
  }

  HexFitOptions FitOptions() const
  {
    HexFitOptions options;
    options.PaddingLayers = this->Options.PaddingLayers;
    options.MaximumHexahedra = this->Options.MaximumHexahedra;
    options.RaisedFrom = RaisedFrom;
    return options;
  }

  bool IsAsWanted(const GridHexesResult& result) const
  {
    return this->Reaches(
             result, this->Options.WantedScaledJacobian, this->Options.WantedDistance) &&
      this->HasWantedCreases(result);
  }

  bool HasWantedCreases(const GridHexesResult& result) const
  {
    return result.Fit.Creases.Distance <= this->Options.WantedCreaseDistance * this->Diagonal;
  }

  /// Whether everything is good enough except hexahedra at preserved corners, which other grids
  /// have as well.
  bool AreOnlyCornersBad(const GridHexesResult& result) const
  {
    return this->Reaches(result, 0.0, AcceptedDistance) && this->HasWantedCreases(result) &&
      FindMinimumScaledJacobianAwayFrom(result.Fit.Creases.CornerPoints, result.Fit.Solid) >=
      AcceptedScaledJacobian;
  }

  /// Updates the distance of the interfaces, whose points may have moved with the boundary's.
  void MeasureInner(HexFit& fit) const
  {
    fit.InnerDistance =
      ComputeInterfaceDistance(fit.Solid.Points, fit.Interfaces, this->InnerBounding);
  }

  /// Snaps the boundary to parts of the surface that are farther than wanted.
  void Snap(GridHexesResult& result, const Progress& progress,
    double minimum = AcceptedScaledJacobian) const
  {
    SnappingOptions options;
    options.WantedDistance = this->Options.WantedDistance * this->Diagonal;
    options.ScaledJacobians = { this->Options.WantedScaledJacobian, minimum };
    if (this->Options.Snap && result.Fit.Inverted == 0 &&
      result.Fit.Distance > options.WantedDistance)
    {
      SnapToSurface(result.Fit, this->Bounding, options, progress);
      this->MeasureInner(result.Fit);
    }
  }

  /// Lets points leave the surface at bad hexahedra. With creases, whose corners may be the reason,
  /// or with inner surfaces, which points would leave too, it does so only at inverted ones.
  void Release(GridHexesResult& result, const Progress& progress) const
  {
    const bool hasCreases = result.Fit.CreasesKept && !result.Features.Curves.empty();
    const bool isSmooth = !hasCreases && this->InnerBounding.empty();
    if (result.Fit.Inverted > 0 ||
      (isSmooth && result.Fit.MinimumScaledJacobian < AcceptedScaledJacobian))
    {
      RelaxBoundaryAroundBad(
        result.Fit, this->Bounding, AcceptedDistance * this->Diagonal, progress.Part(0.0, 0.9));
      this->MeasureInner(result.Fit);
    }
  }

  /// Snaps at the expense of hexahedra, whose points may then leave the surface. Undone if the
  /// score falls.
  void SnapAndRelease(GridHexesResult& result, const Progress& progress) const
  {
    constexpr double minimum = 0.2;
    GridHexesResult snapped = result;
    this->Snap(snapped, progress.Part(0.0, 0.7), minimum);
    this->Release(snapped, progress.Part(0.7, 1.0));
    if (this->Score(snapped) > this->Score(result))
    {
      result = std::move(snapped);
    }
  }

  /// Spends more sweeps on the worst hexahedra. Undone if the score falls.
  void Raise(GridHexesResult& result, const Progress& progress) const
  {
    GridHexesResult raised = result;
    ImproveWorst(raised.Fit, this->Bounding, progress);
    this->MeasureInner(raised.Fit);
    if (this->Score(raised) > this->Score(result))
    {
      result = std::move(raised);
    }
  }

  /// Whether snapping is likely to reach the wanted quality, or the accepted quality if no result
  /// is accepted yet.
  bool IsWorthSnapping(const GridHexesResult& result) const
  {
    return this->Reaches(result,
      this->IsAccepted() ? this->Options.WantedScaledJacobian : AcceptedScaledJacobian,
      SnappedFrom * AcceptedDistance);
  }

  /// Returns the distance that the search reduces.
  static double Distance(const GridHexesResult& result)
  {
    return result.InnerCreasesKept ? std::max(result.Fit.Distance, result.Fit.InnerDistance)
                                   : result.Fit.Distance;
  }

  bool Reaches(const GridHexesResult& result, double scaledJacobian, double distance) const
  {
    return result.Fit.MinimumScaledJacobian >= scaledJacobian &&
      Distance(result) <= distance * this->Diagonal;
  }

  /// Whether snapping is likely to reach the accepted distance.
  bool IsNear(const GridHexesResult& result) const
  {
    return this->Reaches(result, 0.0, SnappedFrom * AcceptedDistance);
  }

  /// Greater is better. Without inverted hexahedra, preserved creases and acceptance add 1 each.
  double Score(const GridHexesResult& result) const
  {
    const HexFit& fit = result.Fit;
    if (fit.Inverted > 0)
    {
      return -fit.Inverted;
    }
    const bool accepted = this->Reaches(result, AcceptedScaledJacobian, AcceptedDistance);
    return std::min(fit.MinimumScaledJacobian / this->Options.WantedScaledJacobian, 1.0) +
      std::min(this->Options.WantedDistance * this->Diagonal / Distance(result), 1.0) +
      std::min(this->Options.WantedCreaseDistance * this->Diagonal / fit.Creases.Distance, 1.0) +
      (accepted ? 1.0 : 0.0) + (fit.CreasesKept ? 1.0 : 0.0);
  }

  /// Adds seeds where the surfaces or their creases are far from each other, at corners of patches
  /// that are too small for the cells, and at bad hexahedra. Returns whether the seeds cover most
  /// of the solid.
  bool AddSeeds(const GridHexesResult& result, std::vector<RefinementSeed>& seeds) const
  {
    const HexMesh& solid = result.Fit.Solid;
    RefinementSeeds positions(result.CellSize);
    const auto addFarOnSurface = [&](const Mesh& surface, const Eigen::MatrixXi& quads)
    {
      positions.AddDistant(
        ComputeDistancesToSurface(surface, SurfaceLocator({ solid.Points, SplitQuads(quads) })),
        this->Options.WantedDistance * this->Diagonal);
    };
    addFarOnSurface(this->Bounding, result.Fit.Quads);
    for (std::size_t i = 0; result.InnerCreasesKept && i < this->InnerBounding.size(); ++i)
    {
      addFarOnSurface(this->InnerBounding[i], result.Fit.Interfaces[i]);
    }
    if (result.Fit.CreasesKept)
    {
      positions.AddDistant(ComputeDistancesToCurves(this->Bounding, result.Features, solid.Points,
                             result.Fit.Quads, result.Fit.PatchOf),
        this->Options.WantedCreaseDistance * this->Diagonal);
    }
    for (const int corner : this->AllFeatures.Corners)
    {
      if (!result.Features.Curves.empty() &&
        !std::binary_search(result.Features.Corners.begin(), result.Features.Corners.end(), corner))
      {
        positions.Add(this->Bounding.Points().row(corner));
      }
    }
    positions.AddBad(solid, AcceptedScaledJacobian);
    seeds.insert(seeds.end(), positions.Seeds().begin(), positions.Seeds().end());
    return positions.AreMostOf(solid.Hexahedra.rows());
  }

  const GridHexesOptions& Options;
  MultiMaterialVoxels Regions;
  const TopologyPreservingVoxels& Cubes; ///< cells of the whole solid
  const Surface Bounding;                ///< the surface that bounds it
  std::vector<Surface> InnerBounding;
  const double Diagonal;
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
  const Progress& progress, const std::vector<Mesh>& innerSurfaces)
{
  GridSearch search(surface, innerSurfaces, options, progress.Part(0.0, 0.05));
  if (options.CellSize > 0.0)
  {
    const double minimum = search.MinimumSize(GridDensity(options.Seeds));
    if (options.CellSize < minimum)
    {
      throw InvalidInput("CellSize is " + std::to_string(options.CellSize) +
        ", which gives more than " + std::to_string(options.MaximumHexahedra) +
        " hexahedra; use at least " + std::to_string(minimum) + ", or raise MaximumHexahedra");
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
    if (search.IsAccepted())
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

GridHexesResult OfSeveralGrids(const Surface& surface, const std::vector<Mesh>& solids,
  const GridHexesOptions& options, const Progress& progress)
{
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
  const Progress& progress, const std::vector<Mesh>& innerSurfaces)
{
  RequireGridInRange(options);
  if (innerSurfaces.empty())
  {
    const std::vector<Mesh> solids = SplitSolids(surface, progress.Part(0.0, 0.02));
    if (!solids.empty())
    {
      return OfSeveralGrids(surface, solids, options, progress.Part(0.02, 1.0));
    }
  }
  return OfOneGrid(surface, options, progress.Part(0.02, 1.0), innerSurfaces);
}

} // namespace shape
