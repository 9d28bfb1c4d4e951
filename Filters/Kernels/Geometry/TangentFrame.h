#pragma once

#include <Eigen/Core>

namespace shape
{

/// A position on a surface with right-handed orthonormal axes.
struct TangentFrame
{
  Eigen::RowVector3d Origin, XAxis, YAxis, Normal;
};

/// Applies to `vector` the smallest rotation that takes the unit vector `from` to the unit vector
/// `to`. If `from` and `to` are opposite, the rotation is a half turn around the x axis, projected
/// onto the plane perpendicular to `from`. If `from` is parallel to x, the y axis is taken instead.
Eigen::RowVector3d RotateBetweenNormals(
  const Eigen::RowVector3d& vector, const Eigen::RowVector3d& from, const Eigen::RowVector3d& to);

/**
 * Builds the frame at `origin` with a unit normal. Its x axis is the normalised projection of
 * xDirection onto the tangent plane. If the projection is zero, the x axis is (1, 0, 0), rotated by
 * RotateBetweenNormals from (0, 0, 1) to the normal. This axis depends continuously on the normal,
 * except at the normal (0, 0, -1).
 */
TangentFrame BuildTangentFrame(const Eigen::RowVector3d& origin, const Eigen::RowVector3d& normal,
  const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero());

} // namespace shape
