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
 * Paths of minimum total cost from one node to each of several others, such that no node but the
 * first is on two of them: a minimum-cost flow (successive shortest paths, by Boost.Graph) in the
 * graph whose nodes are split into an entry and an exit.
 *
 * ends: the last nodes of the paths. Returns the steps of all paths, each from a node to the next;
 * nothing if there are no such paths.
 */
std::optional<std::vector<std::pair<int, int>>> FindDisjointPaths(
  const CostGraph& graph, int from, const std::vector<int>& ends);

} // namespace shape
