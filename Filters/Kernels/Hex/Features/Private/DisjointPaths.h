#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

/// An undirected graph. Each node and each edge has a cost >= 0.
struct CostGraph
{
  std::vector<double> NodeCosts;
  std::map<std::pair<int, int>, double> EdgeCosts; ///< lists each edge once
};

/**
 * Finds paths of minimum total cost from one node to each of several others. The paths share no
 * node except the first. They are a minimum-cost flow (Boost.Graph: successive shortest paths) in a
 * graph in which each node is split into an entry and an exit.
 *
 * ends: the last nodes of the paths. Returns the steps of all paths, each as a node and the next
 * node on its path. Returns nothing if an end is not reached.
 */
std::optional<std::vector<std::pair<int, int>>> FindDisjointPaths(
  const CostGraph& graph, int from, const std::vector<int>& ends);

} // namespace shape
