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
  Eigen::VectorXd Distances; ///< n: distance of each position to its nearest point
};

/// Computes the distances of positions on `from` to the surface `to`. The positions are the points
/// used by triangles of `from`, and 50,000 uniformly distributed random positions. They are cached
/// in `from`, in an order in which neighbours in space are mostly neighbours. enough: distances
/// below this value may be too large, but are below it (SurfaceLocator). Throws InvalidInput if
/// `from` has no triangle; Aborted.
SampledDistances ComputeDistancesToSurface(const Surface& from, const SurfaceLocator& to,
  const Progress& progress = {}, double enough = 0.0);

/// Computes the largest of these distances, in a fraction of the time. Throws in the same way.
double ComputeLargestDistanceToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress = {});

/// The distances between two surfaces, in their units.
struct HausdorffDistances
{
  double FromFirst = 0.0;  ///< largest distance of a position on the first surface to the second
  double FromSecond = 0.0; ///< largest distance of a position on the second surface to the first
  double Larger() const { return std::max(this->FromFirst, this->FromSecond); }
};

/**
 * Computes the two one-sided Hausdorff distances between triangulated surfaces, sampled at the
 * positions of ComputeDistancesToSurface. A result never exceeds the true distance. It is usually
 * too small, but by less than the mean spacing of the positions.
 *
 * Throws InvalidInput if a surface has no triangle; Aborted.
 */
HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress = {});

} // namespace shape
