#include "Mesh/Graph.h"

#include "Mesh/HalfEdges.h"

#include <algorithm>

namespace shape
{

Graph BuildGraph(const Eigen::MatrixXd& positions, std::vector<std::pair<int, int>> links)
{
  for (auto& [a, b] : links)
  {
    if (b < a)
    {
      std::swap(a, b);
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  Graph graph;
  graph.First.assign(positions.rows() + 1, 0);
  for (const auto& [a, b] : links)
  {
    ++graph.First[a + 1];
    ++graph.First[b + 1];
  }
  for (std::size_t i = 1; i < graph.First.size(); ++i)
  {
    graph.First[i] += graph.First[i - 1];
  }
  graph.Neighbours.resize(2 * links.size());
  graph.Lengths.resize(2 * links.size());
  std::vector<int> next = graph.First;
  // Sorted by lower ends, so that each node's neighbours are in ascending order.
  for (const auto& [a, b] : links)
  {
    const double length = (positions.row(a) - positions.row(b)).norm();
    for (const auto& [from, to] : { std::pair(a, b), std::pair(b, a) })
    {
      graph.Neighbours[next[from]] = to;
      graph.Lengths[next[from]++] = length;
    }
  }
  return graph;
}

std::shared_ptr<const Graph> GetEdgeGraph(const Surface& surface)
{
  struct EdgeGraph : Graph
  {
  };
  return surface.Cached<EdgeGraph>(
    [&]()
    {
      std::vector<std::pair<int, int>> edges;
      for (const HalfEdge& edge : surface.HalfEdges())
      {
        edges.emplace_back(edge.Low(), edge.High());
      }
      return EdgeGraph{ BuildGraph(surface.Points(), std::move(edges)) };
    });
}

void LowerDistances(const Graph& graph, const GraphSources& sources, Eigen::VectorXd& distances,
  const Progress& progress)
{
  constexpr int between = 65536; // nodes
  int settled = 0;
  RunDijkstra(
    graph, sources, distances,
    [&](double distance, int link) { return distance + graph.Lengths[link]; }, [](int, int) {},
    [&](int)
    {
      if (settled++ % between == 0)
      {
        progress(0.0);
      }
      return false;
    });
}

std::vector<int> FindShortestPath(
  const Graph& graph, int from, int to, const std::function<double(double, int)>& extend)
{
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(graph.Size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(graph.Size(), -1);
  RunDijkstra(
    graph, { { from }, Eigen::VectorXd::Zero(1) }, distances, extend,
    [&](int node, int previous) { before[node] = previous; }, [&](int node) { return node == to; });
  std::vector<int> path;
  for (int node = before[to] >= 0 ? to : -1; node >= 0; node = before[node])
  {
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace shape
