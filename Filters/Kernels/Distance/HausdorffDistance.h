#pragma once

#include "Base/Progress.h"
#include "Search/ClosestPoint.h"

#include <algorithm>

namespace shape
{

/// Positions on a surface, and how far each is from another one.
struct SampledDistances
{
  Eigen::MatrixXd Positions; ///< n x 3
  Eigen::MatrixXd Nearest;   ///< n x 3: on the other one
  Eigen::VectorXd Distances; ///< n
};

/// Those of the points that triangles of `from` use, and of 50,000 random positions evenly over its
/// area, which are kept with the surface. Throws InvalidInput if it has no triangle, Aborted.
SampledDistances ComputeDistancesToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress = {});

/// How far two surfaces are apart, in their units.
struct HausdorffDistances
{
  double FromFirst = 0.0;  ///< the largest distance of a position on the first to the second
  double FromSecond = 0.0; ///< of a position on the second to the first
  double Larger() const { return std::max(this->FromFirst, this->FromSecond); }
};

/**
 * The two one-sided Hausdorff distances between triangulated surfaces, at the positions of
 * ComputeDistancesToSurface: what is found is never more than the distance, and misses it by less
 * than the mean spacing of the positions.
 *
 * Throws InvalidInput if a surface has no triangle, Aborted.
 */
HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress = {});

} // namespace shape
