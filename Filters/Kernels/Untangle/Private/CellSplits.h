#pragma once

#include "Untangle/Private/SolidCells.h"

#include <functional>
#include <vector>

namespace shape
{

/// Splits tetrahedra of a solid that cannot become positive otherwise.
class CellSplits
{
public:
  /// movable: whether a point may move.
  CellSplits(SolidCells& solid, std::function<bool(int point)> movable);

  /// Splits inverted tetrahedra without a movable point: a new point is inserted in an edge between
  /// fixed points, or in a face. Neighbours that share the edge or face are split, too.
  void Impossible(const std::vector<int>& bad);

  /// Splits around tetrahedra that stay inverted. Every inner edge from their fixed points is
  /// split, so that the cells around one fixed point can move independently of those around the
  /// others. This is done at most `allowed` times for each point. Otherwise the longest edge is
  /// split.
  void Stubborn(const std::vector<int>& bad, int allowed);

private:
  /// Splits the longest edge: edges between two fixed points are preferred, then those with one.
  bool SplitLongest(const std::vector<int>& points);
  bool SplitFace(const std::vector<int>& points);

  SolidCells& Solid;
  std::function<bool(int)> Movable;
  std::vector<int> Collared; ///< number of times that the edges of each fixed point were split
};

} // namespace shape
