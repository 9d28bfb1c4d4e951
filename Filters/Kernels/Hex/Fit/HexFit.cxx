#include "Hex/Fit/HexFit.h"

#include "Base/Errors.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Features/PatchedBoundary.h"
#include "Hex/Fit/Private/Pillowing.h"
#include "Hex/Fit/Private/PillowingPlan.h"
#include "Hex/Fit/Private/Settling.h"
#include "Hex/Optimize/BoundaryRelaxation.h"
#include "Hex/Optimize/HexOptimization.h"
#include "Mesh/QuadSurface.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// Line segments between points.
struct Segments
{
  const Eigen::MatrixXd& Points;
  std::vector<std::array<int, 2>> Ends;

  double Length(const std::array<int, 2>& ends) const
  {
    return (this->Points.row(ends[0]) - this->Points.row(ends[1])).norm();
  }

  /// Returns the segments as triangles without area.
  Mesh AsMesh() const
  {
    Mesh mesh{ this->Points, Eigen::MatrixXi(static_cast<Eigen::Index>(this->Ends.size()), 3) };
    for (Eigen::Index i = 0; i < mesh.Triangles.rows(); ++i)
    {
      mesh.Triangles.row(i) << this->Ends[i][0], this->Ends[i][1], this->Ends[i][1];
    }
    return mesh;
  }

  /// Returns their ends and positions between them, about `count` in total.
  Eigen::MatrixXd Positions(int count) const
  {
    double whole = 0.0;
    for (const std::array<int, 2>& ends : this->Ends)
    {
      whole += this->Length(ends);
    }
    std::vector<Eigen::RowVector3d> positions;
    for (const std::array<int, 2>& ends : this->Ends)
    {
      const int steps =
        1 + (whole > 0.0 ? static_cast<int>(std::floor(count * this->Length(ends) / whole)) : 0);
      for (int i = 0; i <= steps; ++i)
      {
        const double share = static_cast<double>(i) / steps;
        positions.emplace_back(
          (1.0 - share) * this->Points.row(ends[0]) + share * this->Points.row(ends[1]));
      }
    }
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(positions.size()), 3);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      rows.row(i) = positions[i];
    }
    return rows;
  }
};

/// The edges of the surface's curves.
Segments CurvesOf(const Mesh& surface, const SurfaceFeatures& features)
{
  Segments curves{ surface.Points, {} };
  for (const FeatureCurve& curve : features.Curves)
  {
    const std::size_t count = curve.Points.size();
    for (std::size_t i = 0; i + (curve.Closed ? 0 : 1) < count; ++i)
    {
      curves.Ends.push_back({ curve.Points[i], curve.Points[(i + 1) % count] });
    }
  }
  return curves;
}

/// The edges between quads of different patches.
Segments ChainsOf(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  Segments chains{ points, {} };
  const QuadSurface boundary(quads);
  for (const auto& [edge, quad] : boundary.Edges())
  {
    if (edge.first < edge.second &&
      patchOf(quad) != patchOf(boundary.QuadAt({ edge.second, edge.first })))
    {
      chains.Ends.push_back({ edge.first, edge.second });
    }
  }
  return chains;
}

constexpr int ComparedAlong = 20000; // positions along curves, and along chains

/// Distances from the curves to the chains, or to the whole boundary if there are no chains.
SampledDistances Compare(const Segments& curves, const Segments& chains,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads)
{
  if (curves.Ends.empty())
  {
    return {};
  }
  const SurfaceLocator near(
    chains.Ends.empty() ? Mesh{ points, SplitQuads(quads) } : chains.AsMesh());
  Eigen::MatrixXd positions = curves.Positions(ComparedAlong);
  ClosestPoints closest = near.Find(positions);
  return { std::move(positions), std::move(closest.Positions), std::move(closest.Distances) };
}

} // namespace

FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  FeatureDeviation fit;
  const std::set<int> used(quads.data(), quads.data() + quads.size());
  for (const int corner : features.Corners)
  {
    const auto at = std::find_if(used.begin(), used.end(),
      [&](int point) { return points.row(point) == surface.Points.row(corner); });
    if (at != used.end())
    {
      fit.CornerPoints.push_back(*at);
    }
  }
  const Segments curves = CurvesOf(surface, features), chains = ChainsOf(points, quads, patchOf);
  if (curves.Ends.empty())
  {
    return fit;
  }
  fit.Distance = Compare(curves, chains, points, quads).Distances.maxCoeff();
  if (!chains.Ends.empty())
  {
    const SurfaceLocator along(curves.AsMesh());
    fit.Distance =
      std::max(fit.Distance, along.Find(chains.Positions(ComparedAlong)).Distances.maxCoeff());
  }
  return fit;
}

SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf)
{
  return Compare(CurvesOf(surface, features), ChainsOf(points, quads, patchOf), points, quads);
}

void Judge(HexFit& fit)
{
  const Eigen::VectorXd quality = ComputeScaledJacobians(fit.Solid);
  fit.MinimumScaledJacobian = quality.minCoeff();
  fit.MeanScaledJacobian = quality.mean();
  fit.Inverted = static_cast<int>((quality.array() <= 0.0).count());
}

namespace
{

/// Adds the layers that creases need. Returns false if these exceed the maximum number of
/// hexahedra, or if the creases of the result are not the surface's.
bool AddLayers(HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features, int maximum,
  PatchedBoundary& boundary, std::set<int>& unmatched)
{
  for (const std::vector<int>& patches : PlanLayers(surface, features, boundary))
  {
    PillowPatches(mesh, patches, boundary);
  }
  return (features.Curves.empty() || mesh.Hexahedra.rows() <= maximum) &&
    MatchCurves(mesh, surface, features, boundary, unmatched);
}

/// The quads that lie on the surface: those of the boundary and, if regions touch, of interfaces.
Eigen::MatrixXi FindFittedQuads(const HexFit& fit)
{
  if (fit.QuadRegions.size() == 0)
  {
    return fit.Quads;
  }
  Eigen::MatrixXi quads(fit.QuadRegions.rows(), 4);
  Eigen::Index row = fit.Quads.rows();
  quads.topRows(row) = fit.Quads;
  for (const Eigen::MatrixXi& interface : fit.Interfaces)
  {
    quads.middleRows(row, interface.rows()) = interface;
    row += interface.rows();
  }
  return quads;
}

/// Updates the distance, for which both surfaces are sampled.
void Measure(HexFit& fit, const Surface& surface, const Progress& progress)
{
  fit.Distance = ComputeHausdorffDistance(
    surface, { fit.Solid.Points, SplitQuads(FindFittedQuads(fit)) }, progress)
                   .Larger();
}

/// Fits hexahedra with these features; nothing if the features are not found on the hexahedra.
/// `unmatched` then gets the curves that are to blame, if any are (MatchFeatures).
/// 1. MatchFeatures: each quad of the boundary gets a patch, each curve a chain of edges.
/// 2. Layers: of interfaces, of the whole boundary, and those that creases need (AddLayers).
/// 3. Boundary points are put on the surface, and all points are smoothed.
/// 4. OptimizeHexahedra: repairs inverted hexahedra and raises the worst.
std::optional<HexFit> FitWith(const HexMesh& core, const Surface& surface,
  const SurfaceFeatures& features, const HexFitOptions& options, const InnerInterfaces& interfaces,
  std::set<int>& unmatched, const Progress& progress)
{
  progress(0.0);
  std::optional<PatchedBoundary> boundary = MatchFeatures(core, surface, features, unmatched);
  progress(0.0);
  if (!boundary)
  {
    return std::nullopt;
  }
  HexFit fit;
  fit.Solid = core;
  fit.Core = core.Hexahedra;
  const InterfaceLayers interfaceLayers(fit.Solid, interfaces, options.PaddingLayers);
  for (int layer = 1; layer < options.PaddingLayers; ++layer)
  {
    PillowBoundary(fit.Solid, *boundary);
  }
  if (!AddLayers(fit.Solid, surface, features, options.MaximumHexahedra, *boundary, unmatched))
  {
    return std::nullopt;
  }
  const Eigen::Index points = fit.Solid.Points.rows();
  fit.Constraint = std::make_shared<MultiSurfaceConstraint>(
    FeatureConstraint(surface, features, *boundary, points), interfaces, points);
  const PointConstraint& constraint = *fit.Constraint;
  for (const auto& [point, position] : boundary->Starts)
  {
    fit.Solid.Points.row(point) = position;
  }
  // Layers along creases begin without thickness, and untangling them takes long.
  SettlingOptions settling;
  settling.Smoothings = features.Curves.empty() ? 2 : 30;
  settling.RaisedFrom = options.RaisedFrom;
  if (options.Draft)
  {
    SettleAsDraft(settling);
  }
  Settle(
    fit.Solid, constraint,
    [&](Eigen::MatrixXd& points)
    {
      SmoothPillows(*boundary, points);
      interfaceLayers.Spread(points);
    },
    settling, progress.Part(0.0, 0.95));
  Judge(fit);
  fit.Quads = std::move(boundary->Quads);
  fit.PatchOf = std::move(boundary->PatchOf);
  Measure(fit, surface, progress.Part(0.95, 1.0, "measuring the distance to the surface"));
  fit.CreasesKept = true;
  fit.Followed = BuildCreaseLines(surface, features);
  fit.RegionOf = interfaceLayers.Regions(fit.Solid.Hexahedra.rows());
  if (interfaces.Count() > 0)
  {
    fit.Interfaces = interfaces.Cells->Interfaces;
    fit.InnerDistance =
      ComputeInterfaceDistance(fit.Solid.Points, fit.Interfaces, *interfaces.Surfaces);
  }
  return fit;
}

/// Returns the curves nearest to the hexahedra whose scaled Jacobian is below `minimum`.
std::set<int> FindCurvesAtBad(
  const HexFit& fit, const Surface& surface, const SurfaceFeatures& features, double minimum)
{
  const Eigen::VectorXd quality = ComputeScaledJacobians(fit.Solid);
  std::vector<Eigen::RowVector3d> centres;
  for (Eigen::Index hex = 0; hex < quality.size(); ++hex)
  {
    if (quality(hex) < minimum)
    {
      centres.emplace_back(
        fit.Solid.Points(fit.Solid.Hexahedra.row(hex), Eigen::all).colwise().mean());
    }
  }
  Eigen::MatrixXd positions(static_cast<Eigen::Index>(centres.size()), 3);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    positions.row(i) = centres[i];
  }
  return FindNearestCurves(surface, features, positions);
}

/// Fits with all features or with fewer curves: without those that hexahedra are too coarse for,
/// and without those at which hexahedra are too bad. Returns the best of the fits; nothing if there
/// is none, because no curve is to blame or too many attempts are needed.
std::optional<HexFit> FitWithFewer(const HexMesh& core, const Surface& surface,
  const SurfaceFeatures& features, const HexFitOptions& options, const InnerInterfaces& interfaces,
  const Progress& progress)
{
  // Finding that a curve is missing takes a small part of the time of a fit.
  constexpr int attempts = 24;
  SurfaceFeatures fewer = features;
  std::optional<HexFit> best;
  for (int attempt = 0, fitted = 0; attempt < attempts && fitted <= options.FurtherFits; ++attempt)
  {
    std::set<int> unmatched;
    std::optional<HexFit> fit =
      FitWith(core, surface, fewer, options, interfaces, unmatched, progress);
    if (fit)
    {
      ++fitted;
      fit->CreasesKept = attempt == 0;
      const bool isGood = fit->MinimumScaledJacobian >= options.MinimumWithFeatures;
      unmatched =
        isGood ? unmatched : FindCurvesAtBad(*fit, surface, fewer, options.MinimumWithFeatures);
      if (!best || fit->MinimumScaledJacobian > best->MinimumScaledJacobian)
      {
        best = std::move(fit);
      }
      if (isGood)
      {
        break;
      }
    }
    if (unmatched.empty() || options.NeedsCreases)
    {
      break;
    }
    fewer = WithoutCurves(surface, fewer, unmatched);
    if (fewer.Curves.empty())
    {
      break;
    }
  }
  return best;
}

} // namespace

double ComputeFollowedShare(const HexFit& fit, const Mesh& surface, const SurfaceFeatures& features)
{
  const double whole = ComputeLength(BuildCreaseLines(surface, features));
  return whole > 0.0 ? std::min(ComputeLength(fit.Followed) / whole, 1.0) : 1.0;
}

void RequireInRange(const HexMeshOptions& options)
{
  RequireOption(std::isfinite(options.CellSize) && options.CellSize >= 0.0, "CellSize",
    options.CellSize, "positive, or 0 for an automatic size");
  RequireOption(
    options.MaximumHexahedra >= 1, "MaximumHexahedra", options.MaximumHexahedra, "at least 1");
  RequireOption(options.PaddingLayers >= 1, "PaddingLayers", options.PaddingLayers, "at least 1");
  RequireOption(options.FeatureAngle > 0.0 && options.FeatureAngle <= 180.0, "FeatureAngle",
    options.FeatureAngle, "in (0, 180]");
}

SurfaceFeatures FindFeatures(const Surface& surface, const HexMeshOptions& options, double cellSize)
{
  constexpr double minimumPatch = 4.0;
  const double minimumArea = minimumPatch * cellSize * cellSize;
  return options.Patches.size() > 0 ? FindFeatures(surface, options.Patches, minimumArea)
                                    : FindFeatures(surface, options.FeatureAngle, minimumArea);
}

// Fits with as many creases as possible first. If that fails or gives bad hexahedra, fits with a
// single patch and keeps the better result.
HexFit FitHexahedra(const HexMesh& core, const Surface& surface, const SurfaceFeatures& features,
  const HexFitOptions& options, const Progress& progress, const InnerInterfaces& interfaces)
{
  const double first =
    features.Curves.empty() ? 1.0 : 0.7; // without creases there is no second fit
  std::optional<HexFit> fit =
    FitWithFewer(core, surface, features, options, interfaces, progress.Part(0.0, first));
  if (!fit ||
    (!features.Curves.empty() && fit->MinimumScaledJacobian <= options.MinimumWithFeatures))
  {
    if (options.NeedsCreases)
    {
      throw SolveFailure("hexahedra at creases are too bad, or too coarse");
    }
    std::set<int> none;
    std::optional<HexFit> smooth = FitWith(
      core, surface, RemoveCurves(features), options, interfaces, none, progress.Part(first, 1.0));
    if (!fit || smooth.value().MinimumScaledJacobian > fit->MinimumScaledJacobian)
    {
      fit = std::move(smooth);
      fit->CreasesKept = features.Curves.empty();
    }
  }
  progress(1.0);
  fit->Creases = CompareCreases(surface, features, fit->Solid.Points, fit->Quads, fit->PatchOf);
  return std::move(fit.value());
}

void SnapToSurface(
  HexFit& fit, const Surface& surface, const SnappingOptions& options, const Progress& progress)
{
  fit.Distance =
    SnapToFarPositions(fit.Solid, fit.Quads, surface, *fit.Constraint, options, progress);
  Judge(fit);
}

void ImproveWorst(HexFit& fit, const Surface& surface, const Progress& progress)
{
  if (fit.MinimumScaledJacobian < RaisedTo)
  {
    HexOptimizationOptions optimization;
    // FitHexahedra has done the sweeps over all points.
    optimization.Sweeps = 0;
    optimization.RaiseTo = RaisedTo;
    OptimizeHexahedra(fit.Solid, *fit.Constraint, optimization,
      progress.Part(0.0, 0.9, "improving the worst hexahedra"));
    Judge(fit);
    Measure(fit, surface, progress.Part(0.9, 1.0));
  }
}

void RelaxBoundaryAroundBad(HexFit& fit, const Surface& surface, double maximumDistance,
  const Progress& progress, double wanted)
{
  const auto released =
    std::make_shared<OverridableConstraint>(fit.Constraint, fit.Solid.Points.rows());
  OverridableConstraint& freedoms = *released;
  RelaxBoundaryOfInverted(fit.Solid, freedoms,
    progress.Part(0.0, 0.4, "releasing boundary points near inverted hexahedra"));
  Judge(fit);
  if (fit.Inverted == 0)
  {
    Measure(fit, surface, progress.Part(0.4, 0.45));
    constexpr double slack = 1.05;
    const double maximum = std::max(maximumDistance, slack * fit.Distance);
    const auto accepts = [&](const HexMesh& mesh)
    {
      return ComputeHausdorffDistance(surface, { mesh.Points, SplitQuads(FindFittedQuads(fit)) })
               .Larger() <= maximum;
    };
    RelaxBoundaryOfWorst(fit.Solid, freedoms, wanted, accepts,
      progress.Part(0.45, 0.95, "releasing boundary points near the worst hexahedra"));
    Judge(fit);
  }
  Measure(fit, surface, progress.Part(0.95, 1.0, "measuring the distance to the surface"));
  for (int point = 0; point < static_cast<int>(freedoms.Freedoms.size()); ++point)
  {
    fit.Released += freedoms.Freedom(point) > fit.Constraint->Freedom(point) ? 1 : 0;
  }
  fit.Constraint = released;
}

} // namespace shape
