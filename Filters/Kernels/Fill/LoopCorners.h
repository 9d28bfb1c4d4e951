#pragma once

#include "Fill/FairSurface.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// A loop without its duplicate points, as HoleFiller takes it.
struct LoopCorners
{
  std::vector<int> Points; ///< of the loop, no two consecutive ones coincide
  Eigen::MatrixXi Slivers; ///< t x 3 points: triangles without area between a fill of these and the
                           ///< loop itself, so that edges match by index
};

/// loop: at least 3 points with the fill to the left. points: n x 3.
LoopCorners FindLoopCorners(const std::vector<int>& loop, const Eigen::MatrixXd& points);

/**
 * The edges that fills must not have: between two points of a loop that an edge of the surface
 * joins already, or that are both on another loop, whose fill may have that edge. Coincident points
 * count as one.
 */
class UsedEdges
{
public:
  UsedEdges(const Surface& surface, const std::vector<std::vector<int>>& loops);

  /// For a loop, by index, and points of it.
  std::function<bool(int, int)> Of(int loop, const std::vector<int>& corners) const;

private:
  std::vector<int> Position;             ///< of each point, the first coincident one
  std::vector<std::vector<int>> LoopsOf; ///< of each position
  std::vector<std::vector<int>> Joined;  ///< of each position on a loop, those joined to it, sorted
};

/**
 * Whether a fill should have no edge between two points of its loop, by index: seen along the
 * loop's normals, the few points between them are on the other side, so that the edge would cut off
 * a piece that lies over the surface around the hole; or they are collinear with it. False if more
 * than eight edges are between them, and if neither is certain.
 */
std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop);

} // namespace shape
