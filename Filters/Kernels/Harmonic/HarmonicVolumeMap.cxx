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
  { RequireOption(value > 0.0 && std::isfinite(value), name, value, "positive and finite"); };
  positive(options.FeatureWeight, "FeatureWeight");
  positive(options.MostRefined, "MostRefined");
  RequireOption(options.ChargeDistance >= 0.3 && options.ChargeDistance <= 3.0, "ChargeDistance",
    options.ChargeDistance, "from 0.3 to 3");
  positive(options.CollocationRatio, "CollocationRatio");
  positive(options.SourceRatio, "SourceRatio");
  positive(options.SingularValueThreshold, "SingularValueThreshold");
  positive(options.MaximumMemory, "MaximumMemory");
  positive(options.MaximumLevels, "MaximumLevels");
  positive(options.SourceSubsets, "SourceSubsets");
  const auto notNegative = [](double value, const char* name)
  { RequireOption(value >= 0.0 && std::isfinite(value), name, value, "at least 0 and finite"); };
  notNegative(options.Tolerance, "Tolerance");
  notNegative(options.OffsetDistance, "OffsetDistance");
  RequireOption(options.LeastGain >= 0.0 && options.LeastGain <= 1.0, "LeastGain",
    options.LeastGain, "at least 0 and at most 1");
  const Eigen::Index count = features.Points.rows();
  if (features.Targets.rows() != count || features.Points.cols() != 3 ||
    features.Targets.cols() != 3 ||
    (features.Weights.size() != 0 && features.Weights.size() != count))
  {
    throw InvalidInput("there are " + std::to_string(count) + " features, " +
      std::to_string(features.Targets.rows()) + " images and " +
      std::to_string(features.Weights.size()) +
      " weights; give each feature one image and one weight");
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

/// Returns the distance of the nearest charges from the boundary. The default is about the distance
/// between collocation points. With nearer charges the map oscillates between those points; with
/// farther ones it cannot follow the boundary's detail. The upper limit is the paper's offset.
double NearestOffset(const Surface& boundary, const HarmonicVolumeMapOptions& options)
{
  if (options.OffsetDistance == 0.0)
  {
    const double area = ComputePointAreas(boundary).sum();
    const double spacing = std::sqrt(area / (options.CollocationRatio * boundary.Points().rows()));
    return std::clamp(1.25 * spacing, 0.01, 0.15);
  }
  // The option is the distance of the farthest charges; those of MultiLevel's last subset are
  // nearest.
  return options.Method == HarmonicVolumeMapOptions::MethodType::SingleShot
    ? options.OffsetDistance
    : options.OffsetDistance / ComputeCoarseness(ComputeSubsetCount(boundary, options));
}

} // namespace

HarmonicVolumeMapResult ComputeHarmonicVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const VolumeFeatures& features,
  const HarmonicVolumeMapOptions& given, const Progress& progress, AcceleratedSetup* setup)
{
  // Outline (Li et al. 2010, section 3.3):
  // 1. Boundary and images are scaled to a longest side of 1, because thresholds are absolute.
  // 2. The affine part is fitted. If it meets the tolerance, it is the map.
  // 3. Charges are fitted to the residual by the chosen method. Every fitted map is harmonic, and
  //    so is their sum.
  // 4. Accelerated has no rows for features: further levels of MultiLevel fit them.
  // 5. The sum is converted to the coordinates of the input.
  if (given.Method == HarmonicVolumeMapOptions::MethodType::FiniteElements)
  {
    throw InvalidInput(
      "FiniteElements makes no charges, which are needed here; choose Accelerated");
  }
  RequireValidInput(features, given);
  const bool several = setup && setup->Processes.Count > 1;
  if (several &&
    (given.Method != HarmonicVolumeMapOptions::MethodType::Accelerated ||
      features.Points.rows() > 0))
  {
    throw InvalidInput("several processes share the work only of Accelerated without features; use "
                       "one process");
  }
  // Step 1: unit size. Several processes share memory because it is scarce: what surfaces cache is
  // freed as soon as it has been used.
  ScaledBoundary scaled = ScaleBoundary(several ? Surface(boundary.AsMesh()) : boundary, targets);
  if (several)
  {
    scaled.Surface = Surface(scaled.Surface.AsMesh());
  }
  HarmonicVolumeMapOptions options = given;
  options.OffsetDistance = NearestOffset(scaled.Surface, options);
  // Step 2: the affine part.
  AcceleratedSetup own;
  AcceleratedSetup& kept = setup ? *setup : own;
  FundamentalSolutionFit problem(
    scaled, features, options, kept.Processes, progress.Part(0.0, 0.02, "fitting the affine part"));
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
    // Step 3: all charges at once.
    SolveSingleShot(problem, options, result, progress.Part(0.02, 1.0, "fitting the charges"));
  }
  else if (options.Method == HarmonicVolumeMapOptions::MethodType::MultiLevel)
  {
    // Step 3: a sum of maps.
    SolveMultiLevel(problem, options, result, progress.Part(0.02, 1.0, "fitting the charges"));
  }
  else
  {
    // Step 3: charges close to the boundary.
    SolveAccelerated(problem, options, kept, result,
      progress.Part(0.02, problem.HasFeatures() ? 0.7 : 1.0, "fitting the charges"));
    if (problem.HasFeatures())
    {
      // Step 4. The correction for features is smooth near the boundary, so a few distant charges
      // suffice.
      constexpr double maximumCollocations = 6000.0, maximumSources = 8000.0;
      const auto points = static_cast<double>(scaled.Surface.Points().rows());
      HarmonicVolumeMapOptions smooth = options;
      smooth.CollocationRatio = std::min(smooth.CollocationRatio, maximumCollocations / points);
      smooth.SourceRatio = std::min(smooth.SourceRatio, maximumSources / points);
      const double near = result.OffsetDistance;
      SolveMultiLevel(problem, smooth, result, progress.Part(0.7, 1.0, "fitting the features"));
      result.OffsetDistance = std::min(near, result.OffsetDistance);
    }
  }
  // Step 5: the map in the coordinates of the input.
  result.Map = problem.Map();
  result.RMSEFeatures = problem.FeatureError();
  progress(1.0);
  return result;
}

} // namespace shape
