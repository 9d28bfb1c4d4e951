#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Whether a, b, c run counter-clockwise for certain: their determinant is larger than the bound of
/// its rounding error (the first filter of Shewchuk 1997's orient2d), so that exact arithmetic
/// cannot find the opposite.
bool RunsCounterClockwise(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c);

/// The triangles (m x 3) that do not run counter-clockwise for certain, ascending. points: n x 2 or
/// more columns, of which the first two count.
std::vector<int> ClockwiseTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

} // namespace shape
