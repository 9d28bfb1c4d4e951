#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Samples of a surface scaled to area 1: a few points, evenly spread over it.
struct SampledSurface
{
  std::vector<int> Points;   ///< s indices of points of the surface, as far apart as possible
  Eigen::MatrixXd Distances; ///< n x s: along the surface, divided by the root of its area
  Eigen::VectorXd Weights;   ///< s: the share of the area nearest to each sample, > 0; the sum is 1
  double Length = 0.0;       ///< the root of the area, in the model's units
  Eigen::MatrixXd Between() const; ///< s x s: distances between the samples, made symmetric
};

/// Samples a surface at the distinct points `first`, and then at farthest points
/// (SampleFarthestPoints) until there are `count`, or until no point is left. Computes the
/// distances of all points from the samples (ComputeHeatDistances). surface: RequireConnected.
/// Throws SolveFailure, Aborted.
SampledSurface SampleSurface(const Surface& surface, int count, const Progress& progress = {},
  const std::vector<int>& first = {});

/// Returns the first `count` samples alone. areas: n, of the surface's points.
SampledSurface GetFirstSamples(
  const SampledSurface& sampled, int count, const Eigen::VectorXd& areas);

} // namespace shape
