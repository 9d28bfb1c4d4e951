#pragma once

#include "Fill/FairSurface.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// A loop without duplicate points, as HoleFiller requires.
struct LoopCorners
{
  std::vector<int> Points; ///< points of the loop, of which no two consecutive ones coincide
  /// t x 3 indices of points: triangles without area between the loop and a fill of Points. With
  /// them, the fill and the surface share edges by point index.
  Eigen::MatrixXi Slivers;
};

/// Removes consecutive duplicates. points: n x 3. loop: at least 3 points, with the fill to the
/// left.
LoopCorners FindLoopCorners(const std::vector<int>& loop, const Eigen::MatrixXd& points);

/**
 * The edges between two points of a loop that its fill must not contain. Either an edge of the
 * surface already joins the two points. Or both points are also on another loop, whose fill may
 * contain the edge. Coincident points are treated as one point.
 */
class UsedEdges
{
public:
  UsedEdges(const Surface& surface, const std::vector<std::vector<int>>& loops);

  /// Returns a function that tells whether the fill of a loop must not contain an edge. loop: the
  /// index of the loop. corners: points of the loop. The function takes the indices in `corners` of
  /// the edge's two ends.
  std::function<bool(int, int)> Of(int loop, const std::vector<int>& corners) const;

private:
  std::vector<int> Position;             ///< for each point, the first coincident one
  std::vector<std::vector<int>> LoopsOf; ///< for each position, the loops that contain it
  /// For each position on a loop, the positions joined to it, sorted.
  std::vector<std::vector<int>> Joined;
};

/**
 * Returns a function that takes the indices of two points of a loop. It tells whether the fill
 * should avoid an edge between them. The edge and the shorter part of the loop between its points
 * form a polygon. The result is true if this polygon runs clockwise around the loop's normals,
 * since it is then over the surface around the hole. It is also true if the points of the polygon
 * are collinear. It is false if this part of the loop has more than eight edges, or if neither case
 * is certain.
 */
std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop);

} // namespace shape
