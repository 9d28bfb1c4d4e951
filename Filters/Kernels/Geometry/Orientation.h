#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Returns the sign of (b - a) x (c - a) . (d - a): 1 or -1, depending on the side of the plane
 * through a, b, c on which d lies; 0 if the four points are coplanar.
 *
 * The result is exact for the given coordinates. A floating-point filter computes the sign where it
 * is certain; elsewhere, exact expansions do (Shewchuk, "Adaptive precision floating-point
 * arithmetic and fast robust geometric predicates", 1997). Coordinates must be finite; the sixth
 * power of their differences must neither overflow nor underflow.
 */
int EvaluateOrientation(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& d);

/// The same in the plane: 1 if a, b, c are counter-clockwise, -1 if clockwise, 0 if collinear.
int EvaluateOrientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c);

/// Returns 1 if d lies inside the circle through a, b, c (counter-clockwise), 0 on it, -1 outside.
/// Exact as above; the fourth power of the differences must neither overflow nor underflow.
int EvaluateInCircle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::RowVector2d& c, const Eigen::RowVector2d& d);

/// Whether the segment from a to b intersects the interior of a triangle with counter-clockwise
/// corners. If they do not intersect, the line through the segment or through an edge of the
/// triangle separates them. Exact as above.
bool SegmentMeetsTriangle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::Matrix<double, 3, 2>& triangle);

/// Returns the rows of triangles (m x 3) that are not counter-clockwise at positions (n x 2). Exact
/// as above.
std::vector<int> FindInvertedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& positions);

} // namespace shape
