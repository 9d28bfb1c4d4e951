#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
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

/// How many random places on a surface are compared with the other one.
inline constexpr int ComparedPositions = 50000;

/// Those of the points that triangles of `from` use, and of `random` places evenly over its area.
/// Throws InvalidInput where it has no triangle, Aborted.
SampledDistances ComputeDistancesToSurface(const Mesh& from, const SurfaceLocator& to,
  int random = ComparedPositions, const Progress& progress = {});

/// How far two surfaces are apart, in their units.
struct HausdorffDistances
{
  double FromFirst = 0.0;  ///< the largest distance of a place on the first to the second
  double FromSecond = 0.0; ///< of a place on the second to the first
  double Larger() const { return std::max(this->FromFirst, this->FromSecond); }
};

/**
 * The two one-sided Hausdorff distances between triangulated surfaces, at the places of
 * ComputeDistancesToSurface: what is found is never more than the distance, and misses it by less
 * than the mean spacing of the places.
 *
 * Throws InvalidInput where a surface has no triangle, Aborted.
 */
HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress = {});

} // namespace shape
