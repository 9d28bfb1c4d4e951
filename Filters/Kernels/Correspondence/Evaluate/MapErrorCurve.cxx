#include "Correspondence/Evaluate/MapErrorCurve.h"

#include "Base/Errors.h"
#include "Geodesics/ExactGeodesics.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

using NormalisationType = MapErrorCurveOptions::NormalisationType;

constexpr double CoveredWithin = 0.01; ///< of the root of the area

double RootOfArea(const Mesh& mesh)
{
  return std::sqrt(ComputeArea(mesh));
}

void RequireMap(const Mesh& mesh, const Eigen::MatrixXd& map, const std::string& name)
{
  if (map.rows() != mesh.Points.rows() || map.cols() != 3)
  {
    throw InvalidInput("the map of " + name + " has " + std::to_string(map.rows()) +
      " positions for its " + std::to_string(mesh.Points.rows()) + " points; give one for each");
  }
  RequireFinite(map, "the map of " + name);
}

void RequireTruth(const GroundTruth& truth)
{
  if (truth.Positions.rows() == 0)
  {
    throw InvalidInput("the Truth has no points; give at least one position whose image is known");
  }
  RequireFinite(truth.Positions, "the Truth");
  RequireFinite(truth.Targets, "the map of the Truth");
  RequireFinite(truth.Mirrored, "the mirrored map of the Truth");
}

double UnitOf(const Surface& target, NormalisationType normalisation, const Progress& progress)
{
  switch (normalisation)
  {
    case NormalisationType::SquareRootOfArea:
      return RootOfArea(target);
    case NormalisationType::GeodesicDiameter:
      return ComputeGeodesicDiameter(target, progress);
    case NormalisationType::None:
      break;
  }
  return 1.0;
}

/// Returns the finite distances divided by the unit, ascending.
Eigen::VectorXd Ascending(const Eigen::VectorXd& distances, double unit)
{
  std::vector<double> finite;
  std::copy_if(distances.begin(), distances.end(), std::back_inserter(finite),
    [](double distance) { return std::isfinite(distance); });
  std::sort(finite.begin(), finite.end());
  return Eigen::Map<Eigen::VectorXd>(finite.data(), static_cast<Eigen::Index>(finite.size())) /
    unit;
}

/// The smallest error that at least this share of the errors does not exceed.
/// The nearest-rank definition: always one of the errors.
double ComputePercentile(const Eigen::VectorXd& errors, double share)
{
  const double rank = std::ceil(share * static_cast<double>(errors.size())) - 1.0;
  return errors(std::max<Eigen::Index>(static_cast<Eigen::Index>(rank), 0));
}

/// Shares are of all positions: those without a finite error never enter the curve.
void Summarise(MapErrorCurveResult& result, double positions, double largest)
{
  const Eigen::Index count = result.Errors.size();
  result.Shares = Eigen::VectorXd::LinSpaced(count, 1.0, static_cast<double>(count)) / positions;
  result.Mean = result.Errors.mean();
  result.Median = ComputePercentile(result.Errors, 0.5);
  result.Percentile95 = ComputePercentile(result.Errors, 0.95);
  result.Maximum = result.Errors(count - 1);
  // The area under a step function: each error raises the curve from there on to the limit.
  result.AreaUnderCurve = (1.0 - result.Errors.array() / largest).max(0.0).sum() / positions;
}

} // namespace

MapErrorCurveResult ComputeMapErrorCurve(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const GroundTruth& truth, const MapErrorCurveOptions& options,
  const Progress& progress)
{
  RequireManifold(input, "the Input");
  RequireManifold(target, "the Target");
  RequireMap(input, map, "the Input");
  RequireTruth(truth);
  RequireOption(options.LargestError > 0.0 && std::isfinite(options.LargestError), "LargestError",
    options.LargestError, "positive and finite");

  MapErrorCurveResult result;
  result.Unit = UnitOf(target, options.Normalisation, progress.Part(0.0, 0.1));
  // Kim et al., section 6: the image of each position, the exact geodesic distance from the true
  // image, and the sorted distances as a cumulative curve.
  const ClosestPoints positions =
    SurfaceLocator(input).Find(truth.Positions, progress.Part(0.1, 0.15));
  const SurfaceLocator locator(target);
  const ClosestPoints reached =
    locator.Find(PullBack(positions, input.Triangles(), map), progress.Part(0.15, 0.2));
  result.LargestGap = positions.Distances.maxCoeff();

  const auto measure = [&](const Eigen::MatrixXd& targets, const Progress& part)
  {
    const ClosestPoints wanted = locator.Find(targets, part.Part(0.0, 0.1));
    result.LargestGap = std::max(result.LargestGap, wanted.Distances.maxCoeff());
    return Eigen::VectorXd(
      ComputeExactGeodesicsBetween(target, wanted, reached, part.Part(0.1, 1.0)));
  };
  const bool hasMirrored = truth.Mirrored.size() > 0;
  Eigen::VectorXd distances = measure(
    truth.Targets, progress.Part(0.2, hasMirrored ? 0.6 : 1.0, "computing geodesic distances"));
  result.Errors = Ascending(distances, result.Unit);
  // The better of the two truths for all positions together: intrinsic methods cannot distinguish
  // them, but a map that mixes both is wrong.
  if (hasMirrored)
  {
    const Eigen::VectorXd others =
      measure(truth.Mirrored, progress.Part(0.6, 1.0, "computing geodesic distances"));
    const Eigen::VectorXd mirrored = Ascending(others, result.Unit);
    result.Mirrored =
      mirrored.size() > 0 && (result.Errors.size() == 0 || mirrored.mean() < result.Errors.mean());
    if (result.Mirrored)
    {
      result.Errors = mirrored;
      distances = others;
    }
  }
  if (result.Errors.size() == 0)
  {
    throw InvalidInput("none of the " + std::to_string(truth.Positions.rows()) +
      " positions of the Truth is mapped to the component of its true image; check that the "
      "Truth belongs to these surfaces");
  }
  result.PositionErrors = distances.array().isFinite().select(
    distances / result.Unit, Eigen::VectorXd::Constant(distances.size(), -1.0));
  result.Unreached = static_cast<int>(truth.Positions.rows() - result.Errors.size());
  Summarise(result, static_cast<double>(truth.Positions.rows()), options.LargestError);
  progress(1.0);
  return result;
}

Eigen::VectorXd ComputeRoundTripErrors(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const Eigen::MatrixXd& back, const Progress& progress)
{
  RequireManifold(input, "the Input");
  RequireManifold(target, "the Target");
  RequireMap(input, map, "the Input");
  RequireMap(target, back, "the Target");
  std::vector<int> used;
  const Eigen::VectorXi& component = input.Topology().ComponentId;
  for (int point = 0; point < component.size(); ++point)
  {
    if (component(point) >= 0)
    {
      used.push_back(point);
    }
  }
  const ClosestPoints there =
    SurfaceLocator(target).Find(map(used, Eigen::all), progress.Part(0.0, 0.05));
  const ClosestPoints again =
    SurfaceLocator(input).Find(PullBack(there, target.Triangles(), back), progress.Part(0.05, 0.1));
  const SurfacePoints start = MakeSurfacePointsAtVertices(
    Eigen::Map<Eigen::VectorXi>(used.data(), static_cast<Eigen::Index>(used.size())), input);
  return Ascending(
    ComputeExactGeodesicsBetween(input, start, again, progress.Part(0.1, 1.0)), RootOfArea(input));
}

double ComputeCoverage(
  const Surface& input, const Eigen::MatrixXd& map, const Surface& target, const Progress& progress)
{
  RequireMap(input, map, "the Input");
  const Eigen::VectorXd areas = 0.5 * target.AreaVectors().rowwise().norm();
  const Eigen::VectorXd distances = SurfaceLocator(Mesh{ map, input.Triangles() })
                                      .Find(ComputeCentroids(target), progress)
                                      .Distances;
  const double within = CoveredWithin * std::sqrt(areas.sum());
  return areas.dot((distances.array() <= within).cast<double>().matrix()) / areas.sum();
}

double ComputeGeodesicDiameter(const Surface& surface, const Progress& progress)
{
  constexpr int maximumSweeps = 10;
  double longest = 0.0;
  const std::vector<Mesh> components = SplitComponents(surface);
  // Repeated sweeps: the farthest point of the farthest point, as for the diameter of a tree.
  for (const Mesh& part : components)
  {
    const Surface component(part);
    double reach = -1.0;
    Eigen::VectorXi from = Eigen::VectorXi::Constant(1, component.Triangles()(0, 0));
    for (int sweep = 0; sweep < maximumSweeps; ++sweep)
    {
      ClosestPoints seed;
      static_cast<SurfacePoints&>(seed) = MakeSurfacePointsAtVertices(from, component);
      Eigen::Index farthest = 0;
      const double distance = ComputeExactGeodesics(component, seed, progress).maxCoeff(&farthest);
      if (distance <= reach)
      {
        break;
      }
      reach = distance;
      from(0) = static_cast<int>(farthest);
    }
    longest = std::max(longest, reach);
  }
  return longest;
}

} // namespace shape
