#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

/// An undirected graph whose nodes and edges have costs >= 0.
struct CostGraph
{
  std::vector<double> NodeCosts;
  std::map<std::pair<int, int>, double> EdgeCosts; ///< each edge once
};

/**
 * Finds paths of minimum total cost from one node to each of several others; no other node is on
 * two paths. A minimum-cost flow (Boost.Graph: successive shortest paths) in the graph whose nodes
 * are split into an entry and an exit.
 *
 * ends: the last nodes of the paths. Returns the steps of all paths, each from a node to its
 * successor; nothing if an end is not reached.
 */
std::optional<std::vector<std::pair<int, int>>> FindDisjointPaths(
  const CostGraph& graph, int from, const std::vector<int>& ends);

} // namespace shape
