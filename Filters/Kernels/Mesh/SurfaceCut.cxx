#include "Mesh/SurfaceCut.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The neighbours of each point along edges.
class EdgeGraph
{
public:
  explicit EdgeGraph(const Mesh& surface)
    : Points(surface.Points)
    , Neighbours(surface.Points.rows())
  {
    const std::vector<HalfEdge> sides = SortHalfEdges(surface.Triangles, surface.Points.rows());
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const int low = sides[i].Low(), high = sides[i].High();
      if (i == 0 || low != sides[i - 1].Low() || high != sides[i - 1].High())
      {
        this->Neighbours[low].push_back(high);
        this->Neighbours[high].push_back(low);
      }
    }
  }

  /// The shortest path that avoids blocked points (Dijkstra 1959), both ends included; empty where
  /// there is none. toll: what it costs to pass through each point.
  std::vector<int> Path(
    int from, int to, const std::vector<char>& blocked, const std::vector<double>& toll) const
  {
    std::vector<double> distances(this->Neighbours.size(), Infinity);
    std::vector<int> before(this->Neighbours.size(), -1);
    using Item = std::pair<double, int>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    distances[from] = 0.0;
    queue.push({ 0.0, from });
    while (!queue.empty() && queue.top().second != to)
    {
      const auto [distance, point] = queue.top();
      queue.pop();
      if (distance > distances[point])
      {
        continue;
      }
      for (const int next : this->Neighbours[point])
      {
        const double length =
          distance + toll[next] + (this->Points.row(next) - this->Points.row(point)).norm();
        if (length < distances[next] && (blocked[next] == 0 || next == to))
        {
          distances[next] = length;
          before[next] = point;
          queue.push({ length, next });
        }
      }
    }
    std::vector<int> path;
    for (int point = before[to] >= 0 ? to : -1; point >= 0; point = before[point])
    {
      path.push_back(point);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const std::vector<int>& NeighboursOf(int point) const { return this->Neighbours[point]; }

private:
  const Eigen::MatrixXd& Points;
  std::vector<std::vector<int>> Neighbours;
};

/// The path through the stops; where a leg is missing, the path up to there. toll: of passing a
/// point beside a stop that the leg does not end at.
EdgePath FindPath(const EdgeGraph& graph, const std::vector<int>& stops, Eigen::Index points,
  double toll, const Progress& progress)
{
  std::vector<char> blocked(points, 0);
  std::vector<double> tolls(points, 0.0);
  for (const int stop : stops)
  {
    blocked[stop] = 1;
  }
  EdgePath path{ { stops.front() }, { 0 } };
  for (std::size_t i = 1; i < stops.size(); ++i)
  {
    progress(static_cast<double>(i - 1) / static_cast<double>(stops.size() - 1));
    std::fill(tolls.begin(), tolls.end(), 0.0);
    for (std::size_t other = i; other < stops.size(); ++other)
    {
      for (const int neighbour : graph.NeighboursOf(stops[other]))
      {
        tolls[neighbour] += toll;
      }
    }
    const std::vector<int> leg = graph.Path(stops[i - 1], stops[i], blocked, tolls);
    if (leg.empty())
    {
      break;
    }
    for (const int point : leg)
    {
      blocked[point] = 1;
    }
    path.Points.insert(path.Points.end(), leg.begin() + 1, leg.end());
    path.Stops.push_back(static_cast<int>(path.Points.size()) - 1);
  }
  return path;
}

} // namespace

CutSurface CutAlongEdges(const Mesh& surface, const std::vector<std::array<int, 2>>& edges)
{
  std::set<std::array<int, 2>> cut;
  for (const auto& [a, b] : edges)
  {
    cut.insert({ std::min(a, b), std::max(a, b) });
  }
  // Corners stay together across every edge that is not cut.
  const std::vector<int> twins = FindTwins(surface.Triangles, surface.Points.rows());
  DisjointSets parts(static_cast<int>(twins.size()));
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int begin = surface.Triangles(side / 3, side % 3);
    const int end = surface.Triangles(side / 3, (side + 1) % 3);
    if (twins[side] >= 0 && cut.count({ std::min(begin, end), std::max(begin, end) }) == 0)
    {
      parts.Merge(side, NextHalfEdge(twins[side]));
      parts.Merge(NextHalfEdge(side), twins[side]);
    }
  }
  CutSurface result{ surface, {} };
  for (int point = 0; point < static_cast<int>(surface.Points.rows()); ++point)
  {
    result.Originals.push_back(point);
  }
  std::vector<int> number(twins.size(), -1);
  std::vector<char> isTaken(surface.Points.rows(), 0);
  for (int corner = 0; corner < static_cast<int>(twins.size()); ++corner)
  {
    const int point = surface.Triangles(corner / 3, corner % 3);
    int& own = number[parts.Find(corner)];
    if (own < 0)
    {
      own = point;
      if (isTaken[point] != 0)
      {
        own = static_cast<int>(result.Originals.size());
        result.Originals.push_back(point);
      }
      isTaken[point] = 1;
    }
    result.Surface.Triangles(corner / 3, corner % 3) = own;
  }
  result.Surface.Points = surface.Points(result.Originals, Eigen::all);
  return result;
}

EdgePath FindEdgePathThrough(
  const Mesh& surface, const std::vector<int>& stops, const Progress& progress)
{
  const EdgeGraph graph(surface);
  const Eigen::Index points = surface.Points.rows();
  EdgePath path = FindPath(graph, stops, points, 0.0, progress.Part(0.0, 0.5));
  if (path.Stops.size() < stops.size())
  {
    // A stop was walled in: now that costs as much as ten times across the surface.
    path = FindPath(
      graph, stops, points, 10.0 * ComputeBoxDiagonal(surface.Points), progress.Part(0.5, 1.0));
  }
  if (path.Stops.size() < stops.size())
  {
    throw InvalidInput("no path along edges leads from point " +
      std::to_string(stops[path.Stops.size() - 1]) + " to point " +
      std::to_string(stops[path.Stops.size()]) +
      " past the path through the points before; subdivide the surface with Linear Subdivision");
  }
  progress(1.0);
  return path;
}

} // namespace shape
