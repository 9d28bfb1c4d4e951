#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Samples of a surface scaled to area 1: a few points, evenly spread over it.
struct GeodesicSamples
{
  std::vector<int> Points; ///< s: indices of the samples, which are as far apart as possible
  /// n x s: distances from all points to the samples along the surface, divided by Length.
  Eigen::MatrixXd Distances;
  /// s values: for each sample, the share of the area that is nearest to it; > 0, with sum 1.
  Eigen::VectorXd Weights;
  double Length = 0.0; ///< the root of the area, in the model's units
  /// Returns the distances between the samples (s x s), made symmetric.
  Eigen::MatrixXd Between() const;
};

/// Samples a surface at the distinct points `first`, then at those of its `count` farthest points
/// (SampleFarthestPoints, from `start`) that are not in `first`. Computes the distances of all
/// points from the samples (ComputeHeatDistances). surface: one that RequireConnected accepts.
/// Throws SolveFailure, Aborted.
GeodesicSamples SampleSurface(const Surface& surface, int count, const Progress& progress = {},
  const std::vector<int>& first = {}, int start = -1);

/// Returns the first `count` samples only, with their weights computed again. areas: n values, the
/// areas of the surface's points (ComputePointAreas).
GeodesicSamples GetFirstSamples(
  const GeodesicSamples& sampled, int count, const Eigen::VectorXd& areas);

} // namespace shape
