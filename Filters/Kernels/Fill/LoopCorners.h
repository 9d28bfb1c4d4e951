#pragma once

#include "Mesh/Mesh.h"

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
  UsedEdges(const Mesh& surface, const std::vector<std::vector<int>>& loops);

  /// For a rim, by number, and points of it.
  std::function<bool(int, int)> Of(int loop, const std::vector<int>& corners) const;

private:
  std::vector<int> Position;             ///< of each point, the first one there
  std::vector<std::vector<int>> LoopsOf; ///< of each place
  std::vector<std::vector<int>> Joined;  ///< of each place on a rim, those joined to it, in order
};

} // namespace shape
