#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"

#include <functional>
#include <vector>

namespace shape
{

/// Splits tetrahedra that cannot be made positive by moving their points. Throws Aborted.
class CellSplits
{
public:
  /// movable: returns whether a point may move.
  CellSplits(SolidCells& solid, std::function<bool(int point)> movable);

  /// Splits inverted tetrahedra without a movable point. A new point is inserted into an edge or,
  /// if no edge can be split, into a face. Adjacent tetrahedra that share this edge or face are
  /// split, too. bad: inverted cells.
  void Impossible(const std::vector<int>& bad, const Progress& progress = {});

  /// Splits edges at tetrahedra that stay inverted. All inner edges from a fixed point of such a
  /// tetrahedron are split, at most `allowed` times for each point. The cells around one fixed
  /// point can then move independently of the cells around another. A tetrahedron without a point
  /// treated in this way is split at its longest edge or, failing that, at a face. bad: inverted
  /// cells.
  void Stubborn(const std::vector<int>& bad, int allowed, const Progress& progress = {});

private:
  /// Splits all inner edges from a point.
  void SplitAround(int point, const Progress& progress);
  /// Splits the longest edge of a tetrahedron. Edges with two fixed ends are preferred, then edges
  /// with one fixed end. Returns false if no edge can be split.
  bool SplitLongest(const std::vector<int>& points);
  /// Splits a face of a tetrahedron. Returns false if no face can be split.
  bool SplitFace(const std::vector<int>& points);

  SolidCells& Solid;
  std::function<bool(int)> Movable;
  std::vector<int> Collared; ///< for each point: how often all its inner edges were split
};

} // namespace shape
