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

/// A graph whose edges have lengths, stored in compressed rows. For each k from First[i] to
/// First[i + 1] - 1, an edge of length Lengths[k] connects node i to Neighbours[k].
struct Graph
{
  std::vector<int> First;      ///< n + 1 indices into Neighbours
  std::vector<int> Neighbours; ///< for each node, in ascending order
  std::vector<double> Lengths; ///< lengths of the edges, each >= 0

  int Size() const { return static_cast<int>(this->First.size()) - 1; }
};

/// Builds a graph. links: pairs of different nodes in any order, possibly repeated. positions:
/// n x 3; the length of an edge is the distance between the positions of its nodes.
Graph BuildGraph(const Eigen::MatrixXd& positions, std::vector<std::pair<int, int>> links);

/// Returns the graph of a surface's points and edges, which is computed once and cached in the
/// surface. Throws InvalidInput under the conditions of RequireIndices.
std::shared_ptr<const Graph> GetEdgeGraph(const Surface& surface);

/// The nodes where paths start, and the initial distance of each.
struct GraphSources
{
  std::vector<int> Nodes; ///< a node may occur several times
  Eigen::VectorXd Distances;
  /// For each source, the previous node on its path, or -1. If empty, it is -1 for all sources.
  std::vector<int> Before = {};
};

/**
 * Dijkstra's algorithm ("A note on two problems in connexion with graphs", 1959): visits the nodes
 * of a graph in ascending order of their distance from the sources.
 *
 * distances: n initial values, each lowered if a path from the sources is shorter. extend(distance,
 * k): for the distance at the start of edge k, returns the distance at its end. The result must not
 * be less than `distance`; it is infinity if the edge is closed. reach(node, before): called
 * whenever the distance of `node` is lowered; `before` is the previous node on the path, or -1.
 * settle(node): called when the distance of `node` is final; returns true to end the search.
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

/// Lowers each of `distances` (n) to the length of the shortest path from the sources, if that is
/// shorter. The search does not continue past a node whose distance is not lowered. Throws Aborted.
void LowerDistances(const Graph& graph, const GraphSources& sources, Eigen::VectorXd& distances,
  const Progress& progress = {});

/// Returns the nodes of the shortest path between two nodes, including both; empty if there is no
/// path. extend: see RunDijkstra.
std::vector<int> FindShortestPath(
  const Graph& graph, int from, int to, const std::function<double(double, int)>& extend);

} // namespace shape
