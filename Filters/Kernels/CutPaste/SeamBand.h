#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The triangles that join a loop to the ring around it.
struct SeamBand
{
  /// t x 3, counter-clockwise: the loop's points count from 0, the ring's after them, then
  /// Midpoints. Where a point of the ring lies on one of the loop's it counts as that one.
  Eigen::MatrixXi Triangles;
  Eigen::VectorXi RingPoints; ///< of each point of the ring: its number there, or the loop's
  /// Points in the middle between two others: an edge of the band that joins two points of the ring
  /// could be one of the surface around it, too, and is cut in two.
  std::vector<std::array<int, 2>> Midpoints;
};

/**
 * Joins a loop to the ring around it by the constrained Delaunay triangulation of what is between
 * them in the plane. They may have points and sides in common.
 *
 * Edges may join two points of the loop: what is within must not have them (FindLoopChords).
 *
 * loop: n x 2, a polygon that does not cross itself, in either sense. ring: m x 2, another,
 * counter-clockwise, the loop within. Throws InvalidInput where they cross.
 */
SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring);

} // namespace shape
