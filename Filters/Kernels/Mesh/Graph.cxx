#include "Mesh/Graph.h"

#include "Mesh/HalfEdges.h"

#include <algorithm>

namespace shape
{
namespace
{

Graph BuildEdgeGraph(const Surface& surface)
{
  const Eigen::MatrixXd& points = surface.Points();
  std::vector<HalfEdge> edges = surface.HalfEdges();
  const auto same = [](const HalfEdge& a, const HalfEdge& b)
  { return a.Low() == b.Low() && a.High() == b.High(); };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  Graph graph;
  graph.First.assign(points.rows() + 1, 0);
  for (const HalfEdge& edge : edges)
  {
    ++graph.First[edge.Begin + 1];
    ++graph.First[edge.End + 1];
  }
  for (std::size_t i = 1; i < graph.First.size(); ++i)
  {
    graph.First[i] += graph.First[i - 1];
  }
  graph.Neighbours.resize(2 * edges.size());
  graph.Lengths.resize(2 * edges.size());
  std::vector<int> next = graph.First;
  // Sorted by lower ends, so that each node's neighbours are in ascending order.
  for (const HalfEdge& edge : edges)
  {
    const double length = (points.row(edge.Low()) - points.row(edge.High())).norm();
    for (const auto& [from, to] :
      { std::pair(edge.Low(), edge.High()), std::pair(edge.High(), edge.Low()) })
    {
      graph.Neighbours[next[from]] = to;
      graph.Lengths[next[from]++] = length;
    }
  }
  return graph;
}

} // namespace

std::shared_ptr<const Graph> GetEdgeGraph(const Surface& surface)
{
  struct EdgeGraph : Graph
  {
  };
  return surface.Cached<EdgeGraph>([&]() { return EdgeGraph{ BuildEdgeGraph(surface) }; });
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
