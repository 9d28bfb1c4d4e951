#pragma once

#include "Untangle/Private/SolidCells.h"

#include <functional>
#include <vector>

namespace shape
{

/// Splits tetrahedra of a solid that have no room to become positive.
class CellSplits
{
public:
  /// movable: whether a point may be elsewhere.
  CellSplits(SolidCells& solid, std::function<bool(int point)> movable);

  /// Inverted tetrahedra without a point that may move get one in an edge between such points, or
  /// in a face, which neighbours share, too.
  void Impossible(const std::vector<int>& bad);

  /// Tetrahedra that stay inverted get room: every edge from their fixed points into the solid is
  /// split, so that what lies around one fixed point can move without what lies around the others;
  /// that is done `allowed` times for each point in all. Other tetrahedra's longest edge is split.
  void Stubborn(const std::vector<int>& bad, int allowed);

private:
  /// Edges between points that cannot move come first, then those with one.
  bool SplitLongest(const std::vector<int>& points);
  bool SplitFace(const std::vector<int>& points);

  SolidCells& Solid;
  std::function<bool(int)> Movable;
  std::vector<int> Collared; ///< how often the edges of a fixed point were split
};

} // namespace shape
