#pragma once

#include "Fill/FairSurface.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// A rim of doubled points, as HoleFiller wants it.
struct LoopCorners
{
  std::vector<int> Points; ///< of the rim, no two neighbours at the same place
  Eigen::MatrixXi Slivers; ///< t x 3 points: triangles without area between a fill of these and the
                           ///< rim itself, so that sides match by number
};

/// rim: at least 3 points with the fill to the left. points: n x 3.
LoopCorners FindRimCorners(const std::vector<int>& loop, const Eigen::MatrixXd& points);

/**
 * Which edges fills must not have: two points of a rim that an edge of the surface joins already,
 * or that are both on another rim, whose fill may have that edge. Points at the same place count as
 * one.
 */
class UsedEdges
{
public:
  UsedEdges(const Surface& surface, const std::vector<std::vector<int>>& loops);

  /// For a rim, by number, and points of it.
  std::function<bool(int, int)> Of(int loop, const std::vector<int>& corners) const;

private:
  std::vector<int> Position;             ///< of each point, the first one there
  std::vector<std::vector<int>> LoopsOf; ///< of each place
  std::vector<std::vector<int>> Joined;  ///< of each place on a rim, those joined to it, in order
};

/**
 * Whether a fill should have no edge between two points of its rim, by number: seen along the rim's
 * normals the few points between them are on the other side, so that the edge would cut off a piece
 * that lies over the surface around the hole; or they are on one line with it. False where more
 * than eight sides are between them, and where neither is sure.
 */
std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop);

} // namespace shape
