#include "Harmonic/VolumeMap.h"

#include "Base/Errors.h"
#include "Distance/TargetDistance.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/FreeBoundary.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Wraps one harmonic map as a piecewise map of one region.
PiecewiseVolumeMapResult AsOneRegion(HarmonicVolumeMapResult map, const Surface& boundary)
{
  PiecewiseVolumeMapResult result;
  result.Charges.Maps = { map.Map };
  result.Charges.Surface = boundary;
  result.Charges.Farthest = ComputeFarthest(map.OffsetDistance, boundary.Points());
  // The last level holds the errors of the complete sum, whether or not its own map was kept.
  const HarmonicVolumeMapResult::Level& last = map.Levels.back();
  result.Borders.push_back({ last.RMSEVertices, last.RMSEInside, last.Maximum });
  result.RMSEFeatures = map.RMSEFeatures;
  result.OffsetDistance = map.OffsetDistance;
  result.Layers.push_back(std::move(map));
  return result;
}

void RequireFeasibleByElements(
  const VolumeMapConditions& conditions, const VolumeMapOptions& options)
{
  const auto refuse = [](const std::string& what)
  {
    throw InvalidInput("FiniteElements " + what + "; choose the Method Accelerated, or do without");
  };
  if (options.Exact)
  {
    refuse("cannot be Exact on inner surfaces");
  }
  if (options.FreeBoundary)
  {
    refuse("cannot free the boundary");
  }
  if (conditions.Features.Points.rows() > 0)
  {
    refuse("cannot fit Features");
  }
  if (conditions.Targets.rows() != conditions.Boundary.Points().rows() ||
    conditions.Targets.cols() != 3)
  {
    throw InvalidInput("the boundary has " + std::to_string(conditions.Boundary.Points().rows()) +
      " points and " + std::to_string(conditions.Targets.rows()) +
      " images; give each point one image of three coordinates");
  }
  RequireFinite(conditions.Targets, "the list of images of the boundary");
}

/// One map of the whole solid by finite elements, with its errors.
VolumeMapResult SolveByElements(
  const VolumeMapConditions& conditions, int tetrahedra, const Progress& progress)
{
  const auto start = std::chrono::steady_clock::now();
  const Surface& boundary = conditions.Boundary;
  VolumeMapResult result;
  result.Targets = conditions.Targets;
  result.Elements =
    ComputeFiniteElements(boundary, conditions.Targets, tetrahedra, progress.Part(0.0, 0.9));
  // The boundary is met up to rounding: this checks it.
  const FiniteElementMap map(*result.Elements, progress.Part(0.9, 0.95));
  const double size = ComputeLongestBoxEdge(Mesh{ conditions.Targets, boundary.Triangles() });
  const auto misses = [&](const Eigen::MatrixXd& points, const Eigen::MatrixXd& targets)
  { return Eigen::VectorXd((map.Evaluate(points).Images - targets).rowwise().norm() / size); };
  const Eigen::VectorXd vertices = misses(boundary.Points(), conditions.Targets);
  const Eigen::VectorXd inside =
    misses(ComputeOffCentres(boundary), InterpolateAtOffCentres(boundary, conditions.Targets));
  HarmonicVolumeMapResult::Level level;
  level.Sources = level.Collocations = result.Elements->FreePoints;
  level.RMSEVertices = std::sqrt(vertices.squaredNorm() / vertices.size());
  level.RMSEInside = std::sqrt(inside.squaredNorm() / inside.size());
  level.Maximum = std::max(vertices.maxCoeff(), inside.maxCoeff());
  level.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.Map.Charges.Surface = boundary;
  result.Map.Borders.push_back({ level.RMSEVertices, level.RMSEInside, level.Maximum });
  result.Map.Layers.resize(1);
  result.Map.Layers.front().Levels.push_back(level);
  progress(1.0);
  return result;
}

} // namespace

VolumeMapResult ComputeVolumeMap(const VolumeMapConditions& conditions,
  const VolumeMapOptions& options, const Progress& progress, AcceleratedSetup* setup)
{
  if (options.FreeBoundary && !conditions.Target)
  {
    throw InvalidInput("FreeBoundary needs the input 'Target', the surface that the boundary's "
                       "images slide on; connect it, or turn FreeBoundary off");
  }
  const int tetrahedra = options.Harmonic.Tetrahedra;
  RequireOption(tetrahedra >= 1000 && tetrahedra <= 100000000, "Tetrahedra", tetrahedra,
    "from 1,000 to 100,000,000");
  const bool byElements =
    options.Harmonic.Method == HarmonicVolumeMapOptions::MethodType::FiniteElements;
  if (byElements)
  {
    RequireFeasibleByElements(conditions, options);
  }
  const Surface& boundary = conditions.Boundary;
  VolumeMapResult result;
  result.Targets = conditions.Targets;
  // Step 1 of the header.
  if (conditions.Target)
  {
    result.TargetDistance = ComputeTargetDistance(
      boundary, conditions.Targets, *conditions.Target, progress.Part(0.0, 0.02));
  }
  if (byElements)
  {
    const double distance = result.TargetDistance;
    result = SolveByElements(conditions, options.Harmonic.Tetrahedra, progress.Part(0.02, 1.0));
    result.TargetDistance = distance;
    return result;
  }
  // Step 2: one map of the whole solid.
  HarmonicVolumeMapResult one;
  if (options.FreeBoundary || !options.Exact)
  {
    one = ComputeHarmonicVolumeMap(boundary, result.Targets, conditions.Features, options.Harmonic,
      progress.Part(0.02, options.FreeBoundary ? 0.3 : 1.0), setup);
  }
  if (options.FreeBoundary)
  {
    // Step 3: the boundary slides.
    FreeBoundaryResult slid = SlideBoundary(boundary, result.Targets, *conditions.Target,
      conditions.Features, options.Harmonic, one, progress.Part(0.3, options.Exact ? 0.6 : 1.0));
    result.DistortionBefore = slid.DistortionBefore;
    result.DistortionAfter = slid.DistortionAfter;
    result.FoldedBefore = slid.FoldedBefore;
    result.FoldedAfter = slid.FoldedAfter;
    result.SlidShare = slid.Share;
    result.Targets = std::move(slid.Targets);
    one = std::move(slid.Map);
  }
  // Step 4: one map for each layer.
  result.Map = options.Exact
    ? ComputePiecewiseVolumeMap(boundary, result.Targets, conditions.Surfaces, conditions.Features,
        options.Harmonic, {}, progress.Part(options.FreeBoundary ? 0.6 : 0.02, 1.0))
    : AsOneRegion(std::move(one), boundary);
  return result;
}

} // namespace shape
