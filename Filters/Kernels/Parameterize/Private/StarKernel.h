#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Whether every triangle from `place` to a side of the ring, a closed polygon of `points` on the
/// unit sphere that runs counter-clockwise, faces outwards for certain.
bool IsInStarKernel(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& position, const std::vector<int>& ring);

/**
 * Gives points.row(point) a place on the unit sphere that sees the whole ring: the middle of the
 * ring's kernel, found by clipping the lune at ring[0] with the planes of the other sides. ring[0]
 * must see all sides but its own two, as after a half-edge collapse; then the kernel is not empty.
 * Returns false, and moves nothing, where rounding leaves no such place.
 */
bool MovePointIntoKernel(Eigen::MatrixXd& points, int point, const std::vector<int>& ring);

} // namespace shape
