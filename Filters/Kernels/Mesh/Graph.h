#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace shape
{

/// A graph whose links have lengths, in compressed rows: node i is linked with Neighbours[k], at
/// the length Lengths[k], for each k from First[i] to First[i + 1] - 1.
struct Graph
{
  std::vector<int> First;      ///< n + 1
  std::vector<int> Neighbours; ///< of each node in ascending order
  std::vector<double> Lengths; ///< >= 0

  int Size() const { return static_cast<int>(this->First.size()) - 1; }
};

/// The graph of these links, pairs of different nodes in any order, some perhaps twice; each is as
/// long as the straight way between its nodes' positions (n x 3).
Graph BuildGraph(const Eigen::MatrixXd& positions, std::vector<std::pair<int, int>> links);

/// The points and edges of a surface, built once and kept with it. Throws InvalidInput as
/// RequireIndices.
std::shared_ptr<const Graph> GetEdgeGraph(const Surface& surface);

/// Nodes that paths start from, and the distance that each starts with.
struct GraphSources
{
  std::vector<int> Nodes; ///< a node may be there several times
  Eigen::VectorXd Distances;
  std::vector<int> Before = {}; ///< the node before each on the path, or -1; empty: -1 for all
};

/**
 * Dijkstra's algorithm ("A note on two problems in connexion with graphs", 1959): visits the nodes
 * of a graph in ascending order of their distance from the sources.
 *
 * distances (n): lowered where a path from the sources is shorter; infinite ones stay so if no path
 * leads there. extend(distance, k): the distance at the end of link k from that at its start, not
 * less than it; infinite if the link is closed. reach(node, before): called whenever a distance is
 * lowered, with the node before it on the path, or -1. settle(node): called when a distance is
 * final; the search ends if it returns true.
 */
template <typename Extend, typename Reach, typename Settle>
void RunDijkstra(const Graph& graph, const GraphSources& sources, Eigen::VectorXd& distances,
  const Extend& extend, const Reach& reach, const Settle& settle)
{
  using Item = std::pair<double, int>; // distance and node
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto lower = [&](int node, double distance, int before)
  {
    if (distance < distances(node))
    {
      distances(node) = distance;
      reach(node, before);
      queue.emplace(distance, node);
    }
  };
  for (std::size_t i = 0; i < sources.Nodes.size(); ++i)
  {
    lower(sources.Nodes[i], sources.Distances(static_cast<Eigen::Index>(i)),
      sources.Before.empty() ? -1 : sources.Before[i]);
  }
  while (!queue.empty())
  {
    const auto [distance, node] = queue.top();
    queue.pop();
    if (distance > distances(node))
    {
      continue; // it was lowered after this entry
    }
    if (settle(node))
    {
      return;
    }
    for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
    {
      lower(graph.Neighbours[k], extend(distance, k), node);
    }
  }
}

/// Lowers distances (n) to the lengths of shortest paths from the sources where these are less, and
/// searches no farther. Throws Aborted.
void LowerDistances(const Graph& graph, const GraphSources& sources, Eigen::VectorXd& distances,
  const Progress& progress = {});

/// The shortest path between two nodes, both ends included; empty if there is none. extend: as in
/// RunDijkstra.
std::vector<int> FindShortestPath(
  const Graph& graph, int from, int to, const std::function<double(double, int)>& extend);

} // namespace shape
