#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The triangles that a triangle is split into. Points are numbered as given, then those added.
struct TriangleSplit
{
  Eigen::MatrixXi Triangles; ///< m x 3, with the orientation of the triangle
  Eigen::MatrixXd Added;     ///< a x 3: barycentric coordinates of the crossings of chords
  std::vector<std::vector<int>> Chords; ///< the points along each chord, from end to end
};

/**
 * Splits a triangle so that chords are unions of edges; no point is added on its boundary.
 *
 * corners: positions, one per row; the triangle may have no area. points: n x 3 barycentric
 * coordinates that sum exactly to 1. The first `outline` points lie on the boundary, with a
 * coordinate of exactly 0. They include the corners and are in order, starting at corner 0. The
 * others lie inside. chords: pairs of points that do not both lie on one edge. Throws SolveFailure
 * if chords cross too near to the boundary.
 */
TriangleSplit SplitTriangle(const Eigen::Matrix3d& corners, const Eigen::MatrixXd& points,
  int outline, const std::vector<std::array<int, 2>>& chords);

} // namespace shape
