#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// A point of a cut soup on the loop: on the line from the loop's point number Segment to the next
/// one, at the share Along of its length. At the loop's points Along is exactly 0.
struct SeamPoint
{
  int Point;
  int Segment;
  double Along;
};

/// Triangles that a loop in the plane has cut.
struct SoupImprint
{
  Eigen::MatrixXi Triangles;   ///< oriented like the given ones; indices of given and new points
  std::vector<int> Original;   ///< for each triangle, the given one
  std::vector<char> IsCovered; ///< for each triangle, whether it lies inside the loop
  /// For each new point, the given points of which it is the weighted mean, and the weights.
  std::vector<std::vector<std::pair<int, double>>> NewPoints;
  std::vector<SeamPoint> Seam; ///< the given points that were snapped to the loop, and the new ones
};

/**
 * Cuts triangles along a loop in the plane. The triangles may overlap, have any orientation, and
 * share edges or not: each sheet is cut for itself. An edge is split once for all triangles that
 * have it, so what was connected remains connected.
 *
 * First, given points closer to the loop than `snap` are put on it: on a point of the loop if that
 * is as close, otherwise on the nearest line. Then each triangle that contains a point of the loop
 * is split into three. Then each edge that crosses a line of the loop is split where it crosses,
 * and so are its triangles. Afterwards no edge crosses the loop, and the parts of the loop inside a
 * triangle are edges. Which edges cross is decided by exact signs and by the lines on which split
 * points lie, so rounding cannot lose an intersection.
 *
 * images: n x 2, finite. triangles: m x 3. loop: k x 2, a simple polygon in general position: no
 * point of it lies on an edge, and no line of it goes through an image. Small random moves of its
 * points achieve this. snap: a distance in the plane, which keeps edges from being almost parallel
 * to the loop.
 */
SoupImprint ImprintLoop(const Eigen::MatrixXd& images, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& loop, double snap);

} // namespace shape
