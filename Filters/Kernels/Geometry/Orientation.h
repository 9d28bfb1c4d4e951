#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * On which side of the plane through a, b, c the point d lies: 1 where the tetrahedron a b c d is
 * positive, (b - a) x (c - a) . (d - a) > 0, -1 where it is negative, 0 where the four points lie
 * in one plane.
 *
 * Exact for the coordinates as they are: a floating-point filter decides where it can, else
 * expansions (Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997) do. Coordinates must be finite; the sixth power of their differences must
 * neither over- nor underflow.
 */
int EvaluateOrientation(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& d);

/// The same in the plane: 1 where a, b, c run counter-clockwise, 0 where they lie on one line.
int EvaluateOrientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c);

/// 1 where d lies inside the circle through a, b, c, which run counter-clockwise; 0 on it. Exact as
/// above; the fourth power of the differences must neither over- nor underflow.
int EvaluateInCircle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::RowVector2d& c, const Eigen::RowVector2d& d);

/// Whether the segment from a to b runs through the inside of a triangle whose corners run
/// counter-clockwise: no line along a side of either has them on different sides. Exact as above.
bool SegmentMeetsTriangle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::Matrix<double, 3, 2>& triangle);

/// The rows of triangles (m x 3) that do not run counter-clockwise between places (n x 2). Exact as
/// above.
std::vector<int> FindInvertedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& positions);

} // namespace shape
