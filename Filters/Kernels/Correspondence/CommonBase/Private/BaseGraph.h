#pragma once

#include "Base/DisjointSets.h"

#include <array>
#include <vector>

namespace shape
{

/**
 * A graph of paths on an oriented surface, up to homeomorphism: its nodes, its paths, and their
 * cyclic order around each node. Half-path 2 e leaves the first node of path e, and half-path
 * 2 e + 1 the second one.
 *
 * A corner is a gap between consecutive half-paths around a node: that after half-path h, counter-
 * clockwise, has the number h. A node without paths has one corner, the number -1 - node.
 */
class BaseGraph
{
public:
  explicit BaseGraph(int nodes)
    : Around(nodes)
    , Sets(nodes)
  {
  }

  int PathCount() const { return static_cast<int>(this->Paths.size()); }
  int NodeOf(int halfPath) const { return this->Paths[halfPath / 2][halfPath % 2]; }
  int NodeOfCorner(int corner) const { return corner < 0 ? -1 - corner : this->NodeOf(corner); }
  /// Returns all corners: first those of nodes without paths.
  std::vector<int> Corners() const;
  /// Whether a number is that of a corner: a node with paths has lost the corner that it had alone.
  bool IsCorner(int corner) const { return corner >= 0 || this->Around[-1 - corner].empty(); }
  /// Returns the number of sets of connected nodes.
  int ComponentCount();
  /// Whether paths connect two nodes.
  bool AreConnected(int node, int other) { return this->Sets.Find(node) == this->Sets.Find(other); }

  /// Returns the next half-path whose region to the left is that of a half-path, along the region's
  /// boundary.
  int NextAround(int halfPath) const;
  /// Returns for each half-path the number of its boundary cycle: that of its corner.
  std::vector<int> BoundaryCycles() const;

  /// Adds a path from one corner to another corner. Returns its number.
  int Add(int from, int to);

private:
  void Insert(int corner, int halfPath);

  std::vector<std::array<int, 2>> Paths;
  std::vector<std::vector<int>> Around; ///< the half-paths around each node, counter-clockwise
  DisjointSets Sets;
};

} // namespace shape
