#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface of area 1 as a few points that are evenly spread over it.
struct SampledSurface
{
  std::vector<int> Points;   ///< s: of the surface, the farthest from each other
  Eigen::MatrixXd Distances; ///< n x s: along the surface, over the root of its area
  Eigen::VectorXd Weights; ///< s: the share of the area that is nearest to each, > 0; the sum is 1
  double Length = 0.0;     ///< the root of the area, in the model's units
  Eigen::MatrixXd Between() const; ///< s x s: Distances of the samples, made symmetric
};

/// Some points, none twice, and `count` of SampleFarthestPoints or as many as the surface has, and
/// the distances of all points from them (ComputeHeatDistances). surface: RequireConnected. Throws
/// SolveFailure, Aborted.
SampledSurface SampleSurface(const Surface& surface, int count, const Progress& progress = {},
  const std::vector<int>& first = {});

/// The first `count` samples alone; areas: n, of the surface's points.
SampledSurface GetFirstSamples(
  const SampledSurface& sampled, int count, const Eigen::VectorXd& areas);

} // namespace shape
