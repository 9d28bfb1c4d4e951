#include "Harmonic/HarmonicVolumeMap.h"

#include "Base/Errors.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Harmonic/Private/AcceleratedSolver.h"
#include "Harmonic/Private/FundamentalSolutionSolvers.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{

namespace
{

/// Throws InvalidInput if an option is out of range or the features are incomplete.
void RequireValidInput(const VolumeFeatures& features, const HarmonicVolumeMapOptions& options)
{
  const auto positive = [](double value, const char* name)
  {
    if (!(value > 0.0) || !std::isfinite(value))
    {
      throw InvalidInput(std::string(name) + " must be a finite number greater than 0");
    }
  };
  positive(options.FeatureWeight, "FeatureWeight");
  positive(options.MostRefined, "MostRefined");
  positive(options.CollocationRatio, "CollocationRatio");
  positive(options.SourceRatio, "SourceRatio");
  positive(options.SingularValueThreshold, "SingularValueThreshold");
  positive(options.MaximumMemory, "MaximumMemory");
  positive(options.MaximumLevels, "MaximumLevels");
  positive(options.SourceSubsets, "SourceSubsets");
  const auto notNegative = [](double value, const char* name)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw InvalidInput(std::string(name) + " must be a finite number not less than 0");
    }
  };
  notNegative(options.Tolerance, "Tolerance");
  notNegative(options.OffsetDistance, "OffsetDistance");
  notNegative(options.LeastGain, "LeastGain");
  const Eigen::Index count = features.Points.rows();
  if (features.Targets.rows() != count || features.Points.cols() != 3 ||
    features.Targets.cols() != 3 ||
    (features.Weights.size() != 0 && features.Weights.size() != count))
  {
    throw InvalidInput("there are " + std::to_string(count) + " features, " +
      std::to_string(features.Targets.rows()) + " images and " +
      std::to_string(features.Weights.size()) + " weights; give one of each for a feature");
  }
  RequireFinite(features.Points, "the list of feature positions");
  RequireFinite(features.Targets, "the list of feature images");
  RequireFinite(features.Weights, "the list of feature weights");
  if (features.Weights.size() != 0 && features.Weights.minCoeff() <= 0.0)
  {
    Eigen::Index first = 0;
    const int bad = static_cast<int>((features.Weights.array() <= 0.0).count());
    (features.Weights.array() <= 0.0).maxCoeff(&first);
    throw InvalidInput(std::to_string(bad) +
      " feature points have a weight that is not greater than 0 (first at feature point " +
      std::to_string(first) + "); leave them out or give them positive weights");
  }
}

/// The distance of the nearest charges. By default about as far from the boundary as its
/// collocation points are from each other: nearer, the map swings between those points; farther, it
/// cannot follow the boundary's detail. The farthest is the paper's.
double NearestOffset(const Surface& boundary, const HarmonicVolumeMapOptions& options)
{
  if (options.OffsetDistance == 0.0)
  {
    const double area = ComputePointAreas(boundary).sum();
    const double spacing = std::sqrt(area / (options.CollocationRatio * boundary.Points().rows()));
    return std::clamp(1.25 * spacing, 0.01, 0.15);
  }
  return options.Method == HarmonicVolumeMapOptions::MethodType::SingleShot
    ? options.OffsetDistance
    : options.OffsetDistance / ComputeCoarseness(ComputeSubsetCount(boundary, options));
}

} // namespace

HarmonicVolumeMapResult ComputeHarmonicVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const VolumeFeatures& features,
  const HarmonicVolumeMapOptions& given, const Progress& progress, AcceleratedSetup* setup)
{
  RequireValidInput(features, given);
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
      const auto points = static_cast<double>(scaled.Surface.Points().rows());
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
