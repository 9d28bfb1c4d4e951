#include "Harmonic/HarmonicVolumeMap.h"

#include "Harmonic/NearSourceSystem.h"
#include "Harmonic/Private/FundamentalSolutionSolvers.h"

#include <algorithm>
#include <cmath>

namespace shape
{

namespace
{

/// The distance of the nearest charges. By default about as far from the boundary as its
/// collocation points are from each other: nearer, the map swings between those points; farther, it
/// cannot follow the boundary's detail. The farthest is the paper's.
double NearestOffset(const Mesh& boundary, const HarmonicVolumeMapOptions& options)
{
  if (options.OffsetDistance == 0.0)
  {
    const double area = ComputePointAreas(boundary).sum();
    const double spacing = std::sqrt(area / (options.CollocationRatio * boundary.Points.rows()));
    return std::clamp(1.25 * spacing, 0.01, 0.15);
  }
  return options.Method == HarmonicVolumeMapOptions::MethodType::SingleShot
    ? options.OffsetDistance
    : options.OffsetDistance / ComputeCoarseness(ComputeSubsetCount(boundary, options));
}

} // namespace

HarmonicVolumeMapResult ComputeHarmonicVolumeMap(const Mesh& boundary,
  const Eigen::MatrixXd& targets, const VolumeFeatures& features,
  const HarmonicVolumeMapOptions& given, const Progress& progress, AcceleratedSetup* setup)
{
  RequireSupportedFeatures(features, given);
  const ScaledBoundary scaled = ScaleBoundary(boundary, targets);
  HarmonicVolumeMapOptions options = given;
  options.OffsetDistance = NearestOffset(scaled.Surface, options);
  FundamentalSolutionFit problem(scaled, features, options, progress.Part(0.0, 0.05));
  HarmonicVolumeMapResult result;
  result.OffsetDistance = options.OffsetDistance;
  result.Levels.push_back(problem.Errors());
  if (result.Levels.front().RMSEInside <= options.Tolerance &&
    problem.FeatureError() <= options.Tolerance)
  {
    result.Reason = HarmonicVolumeMapResult::Stop::Tolerance;
  }
  else if (options.Method == HarmonicVolumeMapOptions::MethodType::SingleShot)
  {
    SolveSingleShot(problem, options, result, progress.Part(0.05, 1.0));
  }
  else if (options.Method == HarmonicVolumeMapOptions::MethodType::MultiLevel)
  {
    SolveMultiLevel(problem, options, result, progress.Part(0.05, 1.0));
  }
  else
  {
    AcceleratedSetup own;
    SolveAccelerated(problem, options, setup ? *setup : own, result, progress.Part(0.05, 0.7));
    if (problem.HasFeatures())
    {
      // What the features ask for beyond is smooth near the boundary: few, farther charges can.
      constexpr double maximumCollocations = 6000.0, maximumSources = 8000.0;
      const auto points = static_cast<double>(scaled.Surface.Points.rows());
      HarmonicVolumeMapOptions smooth = options;
      smooth.CollocationRatio = std::min(smooth.CollocationRatio, maximumCollocations / points);
      smooth.SourceRatio = std::min(smooth.SourceRatio, maximumSources / points);
      const double near = result.OffsetDistance;
      SolveMultiLevel(problem, smooth, result, progress.Part(0.7, 1.0));
      result.OffsetDistance = std::min(near, result.OffsetDistance);
    }
  }
  result.Map = problem.Map();
  result.RMSEFeatures = problem.FeatureError();
  progress(1.0);
  return result;
}

} // namespace shape
