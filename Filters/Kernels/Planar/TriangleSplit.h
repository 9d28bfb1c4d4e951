#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// What a triangle is split into. Points count as given, then those added.
struct TriangleSplit
{
  Eigen::MatrixXi Triangles; ///< m x 3, facing as the triangle does
  Eigen::MatrixXd Added;     ///< a x 3: barycentric coordinates of points where chords cross
  std::vector<std::vector<int>>
    Chords; ///< the points that each chord runs through, from end to end
};

/**
 * Splits a triangle such that chords run along edges; its outline gets no further point.
 *
 * corners: its places, one a row; it may have no area. points: n x 3 barycentric coordinates, their
 * sums exactly 1; first those on its outline, `outline` of them, in order and from corner 0 on,
 * with coordinates of exactly 0, the corners among them; then those inside. chords: pairs of
 * points, of which not both lie on one side. Throws SolveFailure where chords cross so near to the
 * outline that this cannot be done.
 */
TriangleSplit SplitTriangle(const Eigen::Matrix3d& corners, const Eigen::MatrixXd& points,
  int outline, const std::vector<std::array<int, 2>>& chords);

} // namespace shape
