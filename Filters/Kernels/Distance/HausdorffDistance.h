#pragma once

#include "Base/Progress.h"
#include "Search/ClosestPoint.h"

#include <algorithm>

namespace shape
{

/// Positions on a surface and their distances from another surface.
struct SampledDistances
{
  Eigen::MatrixXd Positions; ///< n x 3
  Eigen::MatrixXd Nearest;   ///< n x 3: the nearest points on the other surface
  Eigen::VectorXd Distances; ///< n: from each position to its nearest point
};

/// Computes the distances from `to` at the points that triangles of `from` use, and at 50,000
/// uniformly distributed random positions on `from`. The positions are cached in `from`. Throws
/// InvalidInput if `from` has no triangle; Aborted.
SampledDistances ComputeDistancesToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress = {});

/// The distances between two surfaces, in their units.
struct HausdorffDistances
{
  double FromFirst = 0.0;  ///< the largest distance from a position on the first to the second
  double FromSecond = 0.0; ///< the largest distance from a position on the second to the first
  double Larger() const { return std::max(this->FromFirst, this->FromSecond); }
};

/**
 * Computes the two one-sided Hausdorff distances between triangulated surfaces, sampled at the
 * positions of ComputeDistancesToSurface. A result never exceeds the true distance; it is usually
 * smaller by less than the mean spacing of the positions.
 *
 * Throws InvalidInput if a surface has no triangle; Aborted.
 */
HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress = {});

} // namespace shape
