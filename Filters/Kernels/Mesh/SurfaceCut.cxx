#include "Mesh/SurfaceCut.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/Graph.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The length of an edge that is closed to a path.
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Finds the path through the stops, or the path up to a leg that does not exist. toll: the cost of
/// passing a neighbour of a stop at which the leg does not end. factors: see FindEdgePathThrough.
EdgePath FindPath(const Graph& graph, const std::vector<int>& stops, double toll,
  const Eigen::MatrixXd& factors, const Progress& progress)
{
  std::vector<char> blocked(graph.Size(), 0);
  std::vector<double> tolls(graph.Size(), 0.0);
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
      for (int k = graph.First[stops[other]]; k < graph.First[stops[other] + 1]; ++k)
      {
        tolls[graph.Neighbours[k]] += toll;
      }
    }
    const std::vector<int> leg = FindShortestPath(graph, stops[i - 1], stops[i],
      [&](double distance, int link)
      {
        const int next = graph.Neighbours[link];
        const double factor =
          factors.size() > 0 ? factors(next, static_cast<Eigen::Index>(i) - 1) : 1.0;
        return blocked[next] == 0 || next == stops[i]
          ? distance + tolls[next] + factor * graph.Lengths[link]
          : Infinity;
      });
    if (leg.empty())
    {
      break;
    }
    for (const int point : leg)
    {
      // Later legs must not meet this one.
      blocked[point] = 1;
    }
    path.Points.insert(path.Points.end(), leg.begin() + 1, leg.end());
    path.Stops.push_back(static_cast<int>(path.Points.size()) - 1);
  }
  return path;
}

} // namespace

CutSurface CutAlongEdges(const Surface& surface, const std::vector<std::array<int, 2>>& edges)
{
  std::set<std::array<int, 2>> cut;
  for (const auto& [a, b] : edges)
  {
    cut.insert({ std::min(a, b), std::max(a, b) });
  }
  // Corners stay together across every edge that is not cut.
  const std::vector<int>& twins = surface.Twins();
  const Eigen::MatrixXi& triangles = surface.Triangles();
  DisjointSets parts(static_cast<int>(twins.size()));
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int begin = triangles(side / 3, side % 3);
    const int end = triangles(side / 3, (side + 1) % 3);
    if (twins[side] >= 0 && cut.count({ std::min(begin, end), std::max(begin, end) }) == 0)
    {
      parts.Merge(side, NextHalfEdge(twins[side]));
      parts.Merge(NextHalfEdge(side), twins[side]);
    }
  }
  CutSurface result{ surface, {} };
  std::vector<int> originals(surface.Points().rows());
  std::iota(originals.begin(), originals.end(), 0);
  std::vector<int> number(twins.size(), -1);
  std::vector<char> isTaken(surface.Points().rows(), 0);
  for (int corner = 0; corner < static_cast<int>(twins.size()); ++corner)
  {
    const int point = triangles(corner / 3, corner % 3);
    int& own = number[parts.Find(corner)];
    if (own < 0)
    {
      // The first part to be met, that with the first triangle, keeps the point; each further part
      // gets a copy.
      own = point;
      if (isTaken[point] != 0)
      {
        own = static_cast<int>(originals.size());
        originals.push_back(point);
      }
      isTaken[point] = 1;
    }
    result.Surface.Triangles(corner / 3, corner % 3) = own;
  }
  result.Surface.Points = surface.Points()(originals, Eigen::all);
  const auto count = static_cast<int>(triangles.rows());
  result.Provenance = TraceCopies(
    originals, surface.Points().rows(), Eigen::VectorXi::LinSpaced(count, 0, count - 1));
  return result;
}

EdgePath FindEdgePathThrough(const Surface& surface, const std::vector<int>& stops,
  const Progress& progress, const Eigen::MatrixXd& factors)
{
  const std::shared_ptr<const Graph> graph = GetEdgeGraph(surface);
  EdgePath path = FindPath(*graph, stops, 0.0, factors, progress.Part(0.0, 0.5));
  if (path.Stops.size() < stops.size())
  {
    // A stop was enclosed: now passing near stops costs as much as ten times across the surface.
    path = FindPath(
      *graph, stops, 10.0 * ComputeBoxDiagonal(surface.Points()), factors, progress.Part(0.5, 1.0));
  }
  if (path.Stops.size() < stops.size())
  {
    throw InvalidInput("no path along edges leads from point " +
      std::to_string(stops[path.Stops.size() - 1]) + " to point " +
      std::to_string(stops[path.Stops.size()]) +
      " without meeting the path so far; refine the surface with Linear Subdivision");
  }
  progress(1.0);
  return path;
}

} // namespace shape
