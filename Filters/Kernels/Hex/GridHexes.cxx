#include "Hex/GridHexes.h"

#include "Core/Errors.h"
#include "Geometry/ClosestPoint.h"
#include "Hex/RegionCubes.h"
#include "Hex/SeparateSolids.h"
#include "Hex/SurfaceFeatures.h"
#include "Quality/HausdorffDistance.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// By which cells become smaller where they have not the solid's topology.
constexpr double Shrinkage = 0.85;
/// By which there are more hexahedra in the next grids with an automatic size.
constexpr double Growth = 1.7;
/// The area of the smallest patch with borders of its own, in faces of cells.
constexpr double LeastPatch = 4.0;
/// What is good enough not to go on to smaller cells everywhere.
constexpr double AcceptedScaledJacobian = 0.55, AcceptedDistance = 0.01;
/// What is farther by more than so many times is not snapped to, but asks for another grid.
constexpr double SnappedFrom = 2.0;
/// How much better smaller cells must make the result for still smaller ones to be tried.
constexpr double LeastGain = 0.02;
/// After so many rounds without such a gain no more are made.
constexpr int MostIdle = 2;

class GridSearch
{
public:
  GridSearch(const Mesh& surface, const std::vector<Mesh>& innerSurfaces,
    const GridHexesOptions& options, const Progress& progress)
    : Options(options)
    , Regions(surface, innerSurfaces, progress)
    , Cubes(this->Regions.Outer())
    , Bounding(this->Cubes.Boundary().Surface)
    , Diagonal(
        options.Diagonal > 0.0 ? options.Diagonal : BoxDiagonal(this->Cubes.Surface().Points))
    , AllFeatures(FindFeatures(this->Bounding.Surface(), options.FeatureAngle, 0.0))
  {
    for (const SolidCubes& inner : this->Regions.Inner())
    {
      this->InnerBounding.emplace_back(inner.Surface());
    }
  }

  double LeastSize(const GridWarp& warp = GridWarp()) const
  {
    return this->Cubes.CellSizeFor(this->Options.MaximumHexahedra, warp);
  }

  /// Rounds of grids, each finer where the one before was not good enough. size: of the cells in
  /// the first; where it is 0, such that there are about `hexahedra` in each.
  void Refine(double size, double hexahedra, int rounds, const Progress& progress)
  {
    std::vector<Magnifier> magnifiers = this->Options.Magnifiers;
    double reached = -std::numeric_limits<double>::infinity();
    int idle = 0; // rounds without a gain
    for (int round = 0; round < rounds; ++round)
    {
      const GridWarp warp(magnifiers);
      const Progress part =
        progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds);
      std::optional<GridHexesResult> result = this->Fill(
        size > 0.0 ? size : this->Cubes.CellSizeFor(hexahedra, warp), warp, part.Part(0.0, 0.8));
      if (!result)
      {
        return;
      }
      const std::size_t before = magnifiers.size();
      bool isSnapped = this->IsAsWanted(*result);
      if (!isSnapped)
      {
        this->Magnify(*result, magnifiers);
        isSnapped = this->IsWorthSnapping(*result);
        if (isSnapped)
        {
          this->Snap(*result, part.Part(0.8, 1.0));
        }
      }
      // Where nothing is magnified the next grid would be the same.
      const bool isLast = magnifiers.size() == before || this->IsAsWanted(*result);
      ++this->Rounds;
      const double score = this->Score(*result);
      idle = score < reached + LeastGain ? idle + 1 : 0;
      reached = std::max(reached, score);
      if (score > this->BestScore())
      {
        this->Best = std::move(*result);
        this->BestIsSnapped = isSnapped;
      }
      if (isLast || idle >= MostIdle)
      {
        break;
      }
    }
    if (this->Best && !this->BestIsSnapped)
    {
      this->Snap(*this->Best, progress.Part(0.9, 1.0));
      this->BestIsSnapped = true;
    }
  }

  /// Grids of the Euler number and number of components that come out, where the surface crosses
  /// itself and there is nothing yet.
  void TakeAnyTopology(const Progress& progress)
  {
    if (!this->Best && this->Cubes.Boundary().Crossings > 0)
    {
      constexpr double share = 0.25; // of the most
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
    return this->Best && this->Reaches(*this->Best, AcceptedScaledJacobian, AcceptedDistance);
  }

  /// Minus infinity where there is nothing yet.
  double BestScore() const
  {
    return this->Best ? this->Score(*this->Best) : -std::numeric_limits<double>::infinity();
  }

  GridHexesResult Result(const Progress& progress)
  {
    if (!this->Best)
    {
      const Topology& topology = this->Cubes.SurfaceTopology();
      throw SolveFailure("no grid of " + std::to_string(this->Options.MaximumHexahedra) +
        " hexahedra has the surface's Euler number " + std::to_string(topology.EulerNumber) +
        " and number of components " + std::to_string(topology.Components) +
        (this->InnerBounding.empty() ? "" : ", and those of the inner surfaces, apart") +
        ": some part or gap is thinner than its cells; raise MaximumHexahedra, or thicken it");
    }
    if (this->Best->Fit.Inverted > 0)
    {
      ReleaseInverted(this->Best->Fit, this->Bounding, progress);
      this->MeasureInner(this->Best->Fit);
    }
    this->Best->Rounds = this->Rounds;
    return std::move(*this->Best);
  }

private:
  /// The hexahedra that cells of this size make, or of a smaller one that has the topology.
  std::optional<GridHexesResult> Fill(double size, const GridWarp& warp, const Progress& progress)
  {
    const double least = this->LeastSize(warp);
    for (; size >= least * (1.0 - 1e-9); size *= Shrinkage)
    {
      if (const std::optional<RegionCells> cells =
            this->Regions.Fill(size, warp, progress.Part(0.0, 0.1)))
      {
        GridHexesResult result;
        result.CellSize = size;
        result.Crossings = this->Cubes.Boundary().Crossings;
        result.Features = FindFeatures(
          this->Bounding.Surface(), this->Options.FeatureAngle, LeastPatch * size * size);
        result.InnerCreasesKept =
          std::all_of(this->InnerBounding.begin(), this->InnerBounding.end(),
            [&](const SurfaceLocator& inner)
            {
              return FindFeatures(
                inner.Surface(), this->Options.FeatureAngle, LeastPatch * size * size)
                .Curves.empty();
            });
        result.Fit = FitHexahedra(cells->Solid, this->Bounding, result.Features,
          { this->Options.PaddingLayers, this->Options.MaximumHexahedra }, progress.Part(0.1, 1.0),
          { &*cells, &this->InnerBounding });
        return result;
      }
    }
    return std::nullopt;
  }

  bool IsAsWanted(const GridHexesResult& result) const
  {
    return this->Reaches(
             result, this->Options.WantedScaledJacobian, this->Options.WantedDistance) &&
      result.Fit.Creases.Distance <= this->Options.WantedCreaseDistance * this->Diagonal;
  }

  /// Where the boundary's points were moved, those of interfaces near them were, too.
  void MeasureInner(HexFit& fit) const
  {
    fit.InnerDistance = InnerDistance(fit.Solid.Points, fit.Interfaces, this->InnerBounding);
  }

  /// Puts the boundary on what is farther than wanted.
  void Snap(GridHexesResult& result, const Progress& progress) const
  {
    SnappingOptions options;
    options.WantedDistance = this->Options.WantedDistance * this->Diagonal;
    options.ScaledJacobians = { this->Options.WantedScaledJacobian, AcceptedScaledJacobian };
    if (this->Options.Snap && result.Fit.Inverted == 0 &&
      result.Fit.Distance > options.WantedDistance)
    {
      SnapToSurface(result.Fit, this->Bounding, options, progress);
      this->MeasureInner(result.Fit);
    }
  }

  /// Whether snapping may well make it what is wanted, or what is accepted where nothing is yet.
  bool IsWorthSnapping(const GridHexesResult& result) const
  {
    return this->Reaches(result,
      this->IsAccepted() ? this->Options.WantedScaledJacobian : AcceptedScaledJacobian,
      SnappedFrom * AcceptedDistance);
  }

  /// That the search is for.
  static double Distance(const GridHexesResult& result)
  {
    return result.InnerCreasesKept ? std::max(result.Fit.Distance, result.Fit.InnerDistance)
                                   : result.Fit.Distance;
  }

  bool Reaches(const GridHexesResult& result, double scaledJacobian, double distance) const
  {
    return result.Fit.LeastScaledJacobian >= scaledJacobian &&
      Distance(result) <= distance * this->Diagonal;
  }

  /// The greater, the better. Creases count most among what is not inverted, then what is accepted.
  double Score(const GridHexesResult& result) const
  {
    const HexFit& fit = result.Fit;
    if (fit.Inverted > 0)
    {
      return -fit.Inverted;
    }
    const bool accepted = this->Reaches(result, AcceptedScaledJacobian, AcceptedDistance);
    return std::min(fit.LeastScaledJacobian / this->Options.WantedScaledJacobian, 1.0) +
      std::min(this->Options.WantedDistance * this->Diagonal / Distance(result), 1.0) +
      std::min(this->Options.WantedCreaseDistance * this->Diagonal / fit.Creases.Distance, 1.0) +
      (accepted ? 1.0 : 0.0) + (fit.CreasesKept ? 1.0 : 0.0);
  }

  /// Adds magnifiers where the surfaces or their creases are far from each other, at corners that
  /// patches too small for the cells have, and at bad hexahedra.
  void Magnify(const GridHexesResult& result, std::vector<Magnifier>& magnifiers) const
  {
    constexpr double radius = 2.5, apart = 1.5; // cells, radii
    constexpr double strength = 0.4, share = 0.9;
    const HexMesh& solid = result.Fit.Solid;
    const std::size_t before = magnifiers.size();
    const auto add = [&](const Eigen::RowVector3d& centre, double times = 1.0)
    {
      if (std::none_of(magnifiers.begin() + static_cast<std::ptrdiff_t>(before), magnifiers.end(),
            [&](const Magnifier& other)
            { return (other.Centre - centre).norm() < apart * other.Radius; }))
      {
        magnifiers.push_back({ centre, radius * result.CellSize, times * strength });
      }
    };
    const auto addFar = [&](const PlacesAndDistances& far, double wanted)
    {
      std::vector<int> order(far.Distances.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(),
        [&](int a, int b) { return far.Distances(a) > far.Distances(b); });
      for (const int i : order)
      {
        if (far.Distances(i) < share * wanted * this->Diagonal)
        {
          break;
        }
        // What is more than four times too far would take too many rounds.
        const double times = far.Distances(i) / (wanted * this->Diagonal);
        constexpr double most = 2.0;
        add(far.Places.row(i), std::clamp(std::log2(0.5 * times), 1.0, most));
      }
    };
    const auto addFarOnSurface = [&](const Mesh& surface, const Eigen::MatrixXi& quads)
    {
      addFar(DistancesBetween(surface, SurfaceLocator({ solid.Points, SplitQuads(quads) })),
        this->Options.WantedDistance);
    };
    addFarOnSurface(this->Bounding.Surface(), result.Fit.Quads);
    for (std::size_t i = 0; result.InnerCreasesKept && i < this->InnerBounding.size(); ++i)
    {
      addFarOnSurface(this->InnerBounding[i].Surface(), result.Fit.Interfaces[i]);
    }
    if (result.Fit.CreasesKept)
    {
      addFar(DistancesOfCurves(this->Bounding.Surface(), result.Features, solid.Points,
               result.Fit.Quads, result.Fit.PatchOf),
        this->Options.WantedCreaseDistance);
    }
    for (const int corner : this->AllFeatures.Corners)
    {
      if (!result.Features.Curves.empty() &&
        !std::binary_search(result.Features.Corners.begin(), result.Features.Corners.end(), corner))
      {
        add(this->Bounding.Surface().Points.row(corner));
      }
    }
    const Eigen::VectorXd quality = ScaledJacobians(solid);
    for (Eigen::Index hex = 0; hex < quality.size(); ++hex)
    {
      if (quality(hex) < AcceptedScaledJacobian)
      {
        add(solid.Points(solid.Hexahedra.row(hex), Eigen::all).colwise().mean());
      }
    }
  }

  const GridHexesOptions& Options;
  RegionCubes Regions;
  const SolidCubes& Cubes;       ///< of the whole solid
  const SurfaceLocator Bounding; ///< what bounds it
  std::vector<SurfaceLocator> InnerBounding;
  const double Diagonal;
  const SurfaceFeatures AllFeatures; ///< patches of any size
  std::optional<GridHexesResult> Best;
  bool BestIsSnapped = false;
  int Rounds = 0;
};

void RequireInRange(const GridHexesOptions& options)
{
  RequireOption(std::isfinite(options.CellSize) && options.CellSize >= 0.0, "CellSize",
    options.CellSize, "positive, or 0 for an automatic one");
  RequireOption(
    options.MaximumHexahedra >= 1, "MaximumHexahedra", options.MaximumHexahedra, "at least 1");
  RequireOption(options.PaddingLayers >= 1, "PaddingLayers", options.PaddingLayers, "at least 1");
  RequireOption(options.Rounds >= 1, "Rounds", options.Rounds, "at least 1");
  RequireOption(options.FeatureAngle > 0.0 && options.FeatureAngle <= 180.0, "FeatureAngle",
    options.FeatureAngle, "in (0, 180]");
  RequireOption(options.WantedCreaseDistance > 0.0, "WantedCreaseDistance",
    options.WantedCreaseDistance, "positive");
  RequireOption(options.WantedDistance > 0.0, "WantedDistance", options.WantedDistance, "positive");
}

GridHexesResult Ended(GridHexesResult result, const Progress& progress)
{
  progress(1.0);
  return result;
}

GridHexesResult OfOneGrid(const Mesh& surface, const GridHexesOptions& options,
  const Progress& progress, const std::vector<Mesh>& innerSurfaces)
{
  GridSearch search(surface, innerSurfaces, options, progress.Part(0.0, 0.05));
  if (options.CellSize > 0.0)
  {
    const double least = search.LeastSize(GridWarp(options.Magnifiers));
    if (options.CellSize < least)
    {
      throw InvalidInput("CellSize is " + std::to_string(options.CellSize) +
        ", which makes more than " + std::to_string(options.MaximumHexahedra) +
        " hexahedra; at least " + std::to_string(least) +
        " is needed, or a greater MaximumHexahedra");
    }
    search.Refine(options.CellSize, 0.0, options.Rounds, progress.Part(0.05, 0.95));
    return Ended(search.Result(progress.Part(0.95, 1.0)), progress);
  }
  double begin = 0.05, before = -std::numeric_limits<double>::infinity();
  int rounds = options.Rounds;
  for (double hexahedra = std::min<double>(options.FirstHexahedra, options.MaximumHexahedra);
       hexahedra <= options.MaximumHexahedra; hexahedra *= Growth)
  {
    const double end = 0.5 * (begin + 0.95);
    search.Refine(0.0, hexahedra, rounds, progress.Part(begin, end));
    const double score = search.BestScore();
    if (search.IsAccepted() || (std::isfinite(score) && score < before + LeastGain))
    {
      break;
    }
    before = score;
    begin = end;
    rounds = (rounds + 1) / 2;
  }
  search.TakeAnyTopology(progress.Part(begin, 0.95));
  return Ended(search.Result(progress.Part(0.95, 1.0)), progress);
}

/// The share of the hexahedra that each solid may have.
std::vector<double> Shares(const std::vector<Mesh>& solids)
{
  // So many for all that are small.
  constexpr double small = 0.25;
  std::vector<double> shares;
  double sum = 0.0;
  for (const Mesh& solid : solids)
  {
    shares.push_back(EnclosedVolume(solid));
    sum += shares.back();
  }
  double all = 0.0;
  for (double& share : shares)
  {
    share = std::max(share / sum, small / static_cast<double>(solids.size()));
    all += share;
  }
  for (double& share : shares)
  {
    share /= all;
  }
  return shares;
}

GridHexesResult OfSeveralGrids(const Mesh& surface, const std::vector<Mesh>& solids,
  const GridHexesOptions& options, const Progress& progress)
{
  const std::vector<double> shares = Shares(solids);
  std::vector<HexFit> fits;
  std::vector<SurfaceFeatures> features;
  GridHexesResult result;
  double begin = 0.0;
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    GridHexesOptions own = options;
    own.Diagonal = options.Diagonal > 0.0 ? options.Diagonal : BoxDiagonal(surface.Points);
    own.FirstHexahedra = shares[i] * options.FirstHexahedra;
    own.MaximumHexahedra = std::max(1, static_cast<int>(shares[i] * options.MaximumHexahedra));
    GridHexesResult one = OfOneGrid(solids[i], own, progress.Part(begin, begin + shares[i]), {});
    begin += shares[i];
    fits.push_back(std::move(one.Fit));
    features.push_back(std::move(one.Features));
    result.CellSize = std::max(result.CellSize, one.CellSize);
    result.Rounds = std::max(result.Rounds, one.Rounds);
  }
  result.Fit = JoinedFit(fits);
  result.Features = JoinedFeatures(features, solids);
  return result;
}

} // namespace

GridHexesResult GridHexes(const Mesh& surface, const GridHexesOptions& options,
  const Progress& progress, const std::vector<Mesh>& innerSurfaces)
{
  RequireInRange(options);
  if (innerSurfaces.empty())
  {
    const std::vector<Mesh> solids = SeparateSolids(surface, progress.Part(0.0, 0.02));
    if (!solids.empty())
    {
      return OfSeveralGrids(surface, solids, options, progress.Part(0.02, 1.0));
    }
  }
  return OfOneGrid(surface, options, progress.Part(0.02, 1.0), innerSurfaces);
}

} // namespace shape
