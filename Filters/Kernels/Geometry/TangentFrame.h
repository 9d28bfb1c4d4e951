#pragma once

#include <Eigen/Core>

namespace shape
{

/// A place on a surface with right-handed orthonormal axes there.
struct TangentFrame
{
  Eigen::RowVector3d Origin, XAxis, YAxis, Normal;
};

/// `vector`, turned as the unit vector `from` is turned to the unit vector `to` by the shortest
/// way; where they are opposite, half around the x axis, or the y axis where that is along them.
Eigen::RowVector3d RotateBetweenNormals(
  const Eigen::RowVector3d& vector, const Eigen::RowVector3d& from, const Eigen::RowVector3d& to);

/**
 * The frame at `origin` with a unit normal. Its x axis is xDirection, without its part along the
 * normal. Where that leaves nothing it is (1, 0, 0), turned as (0, 0, 1) is turned to the normal by
 * the shortest way: as the normal changes so does that axis without a jump, but at (0, 0, -1).
 */
TangentFrame BuildTangentFrame(const Eigen::RowVector3d& origin, const Eigen::RowVector3d& normal,
  const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero());

} // namespace shape
