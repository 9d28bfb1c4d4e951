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
  /// t x 3 points: triangles without area between the loop and a fill of Points. They make edges
  /// match by index.
  Eigen::MatrixXi Slivers;
};

/// Removes consecutive duplicates. points: n x 3. loop: at least 3 points, with the fill to the
/// left.
LoopCorners FindLoopCorners(const std::vector<int>& loop, const Eigen::MatrixXd& points);

/**
 * The edges that fills must not contain. These join two points of a loop that an edge of the
 * surface joins already, or two points that are both on another loop, whose fill may contain that
 * edge. Coincident points are treated as one point.
 */
class UsedEdges
{
public:
  UsedEdges(const Surface& surface, const std::vector<std::vector<int>>& loops);

  /// Returns the test for a loop, given by its index, and points of it.
  std::function<bool(int, int)> Of(int loop, const std::vector<int>& corners) const;

private:
  std::vector<int> Position;             ///< for each point, the first coincident one
  std::vector<std::vector<int>> LoopsOf; ///< for each position, the loops that contain it
  /// For each position on a loop, the positions joined to it, sorted.
  std::vector<std::vector<int>> Joined;
};

/**
 * Returns a test of whether a fill should avoid an edge between two points of its loop, given by
 * their indices. It should in two cases, seen along the loop's normals. Either the few points
 * between the two are on the other side, and the edge would cut off a piece over the surface around
 * the hole. Or these points are collinear with the edge. The test is false if more than eight edges
 * are between the two points, or if neither case is certain.
 */
std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop);

} // namespace shape
