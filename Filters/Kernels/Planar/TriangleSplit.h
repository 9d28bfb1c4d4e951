#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The triangles that a triangle is split into. The given points keep their numbers; the added
/// points follow.
struct TriangleSplit
{
  Eigen::MatrixXi Triangles; ///< m x 3, oriented like the triangle that is split
  /// a x 3: barycentric coordinates of the points added where chords cross
  Eigen::MatrixXd Added;
  std::vector<std::vector<int>> Chords; ///< for each chord, the points along it, from end to end
};

/**
 * Splits a triangle so that each given chord becomes a sequence of edges. No point is added on the
 * triangle's boundary.
 *
 * corners: the positions of the corners, one per row; the triangle may have no area. points: n x 3
 * barycentric coordinates, which sum exactly to 1. The first `outline` points lie on the boundary,
 * where a coordinate is exactly 0. They include the corners, and are in order along the boundary,
 * starting at corner 0. The other points lie inside. chords: pairs of points that do not lie on the
 * same edge of the triangle. Throws SolveFailure if chords cross too near to the boundary.
 */
TriangleSplit SplitTriangle(const Eigen::Matrix3d& corners, const Eigen::MatrixXd& points,
  int outline, const std::vector<std::array<int, 2>>& chords);

} // namespace shape
