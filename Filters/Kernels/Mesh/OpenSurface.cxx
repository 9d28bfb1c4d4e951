#include "Mesh/OpenSurface.h"

#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <string>

namespace shape
{
namespace
{

double ComputeLoopLength(const std::vector<int>& loop, const Eigen::MatrixXd& points)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
  }
  return length;
}

} // namespace

void RequireSurfaceWithBoundary(const Surface& surface, LoopCount loops)
{
  const Topology topology = RequireManifold(surface, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components; keep one with Connectivity / Extract Largest");
  }
  if (topology.BoundaryLoops == 0)
  {
    throw InvalidInput("the surface is closed; cut it first with Shape Cut Feature");
  }
  if (topology.BoundaryLoops > 1 && loops == LoopCount::One)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.BoundaryLoops) +
      " open loops (first at point " + std::to_string(topology.FirstOpenPoint) +
      "); fill all but the outer one with Shape Fill Holes");
  }
  const int flat = 2 - topology.BoundaryLoops;
  if (topology.EulerNumber != flat)
  {
    throw InvalidInput("the surface has Euler number " + std::to_string(topology.EulerNumber) +
      " (genus " + std::to_string((flat - topology.EulerNumber) / 2) +
      "); a map to the plane needs" + " Euler number " + std::to_string(flat) +
      ": cut its handles and fill the holes");
  }
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    const auto first = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), -1) -
      topology.ComponentId.begin();
    throw InvalidInput("the surface has " + std::to_string(unused) +
      (unused == 1 ? " point that no triangle uses" : " points that no triangle uses") +
      " (first at point " + std::to_string(first) + "); remove them with Clean");
  }
}

std::vector<std::vector<int>> FindManifoldBoundaryLoops(const Surface& surface)
{
  const std::vector<int>& twins = surface.Twins();
  const Eigen::MatrixXi& triangles = surface.Triangles();
  std::vector<int> next(surface.Points().rows(), -1);
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    if (twins[side] < 0)
    {
      next[triangles(side / 3, side % 3)] = triangles(side / 3, (side + 1) % 3);
    }
  }
  std::vector<std::vector<int>> loops;
  for (int first = 0; first < static_cast<int>(next.size()); ++first)
  {
    if (next[first] >= 0)
    {
      loops.emplace_back();
      for (int point = first; next[point] >= 0;)
      {
        loops.back().push_back(point);
        const int following = next[point];
        next[point] = -1;
        point = following;
      }
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [&](const std::vector<int>& a, const std::vector<int>& b)
    { return ComputeLoopLength(a, surface.Points()) > ComputeLoopLength(b, surface.Points()); });
  return loops;
}

Mesh FillWithFans(const Mesh& surface, const std::vector<std::vector<int>>& loops)
{
  Eigen::Index sides = 0;
  for (const std::vector<int>& loop : loops)
  {
    sides += static_cast<Eigen::Index>(loop.size());
  }
  Mesh filled{ Eigen::MatrixXd(surface.Points.rows() + static_cast<Eigen::Index>(loops.size()), 3),
    Eigen::MatrixXi(surface.Triangles.rows() + sides, 3) };
  filled.Points.topRows(surface.Points.rows()) = surface.Points;
  filled.Triangles.topRows(surface.Triangles.rows()) = surface.Triangles;
  auto middle = static_cast<int>(surface.Points.rows());
  Eigen::Index row = surface.Triangles.rows();
  for (const std::vector<int>& loop : loops)
  {
    filled.Points.row(middle) = surface.Points(loop, Eigen::all).colwise().mean();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      filled.Triangles.row(row++) << loop[(i + 1) % loop.size()], loop[i], middle;
    }
    ++middle;
  }
  return filled;
}

} // namespace shape
