#include "Geodesics/SurfacePath.h"

#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Like FindTwins, for any triangles: half-edges have a twin only if their edge has exactly two, in
/// opposite directions.
std::vector<int> TwinsOf(const Surface& surface)
{
  std::vector<int> twins(surface.Triangles().size(), -1);
  const std::vector<HalfEdge>& edges = surface.HalfEdges();
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    while (next < edges.size() && edges[next].Low() == edges[first].Low() &&
      edges[next].High() == edges[first].High())
    {
      ++next;
    }
    const HalfEdge &one = edges[first], &other = edges[next - 1];
    if (next - first == 2 && one.Begin == other.End)
    {
      const int side = 3 * one.Triangle + one.Corner, twin = 3 * other.Triangle + other.Corner;
      twins[side] = twin;
      twins[twin] = side;
    }
  }
  return twins;
}

} // namespace

/// Searches for the half-edges that lead from one point to another (A* search: Hart, Nilsson and
/// Raphael 1968). Each is crossed on the shortest line from the previous crossing to the target.
class SurfacePaths::StripSearch
{
public:
  StripSearch(const Mesh& mesh, const std::vector<int>& twins)
    : Triangulation(mesh)
    , Twins(twins)
    , Bounds(twins.size(), std::numeric_limits<double>::infinity())
    , Distances(twins.size())
    , Crossings(twins.size())
    , Before(twins.size(), -1)
    , IsDone(twins.size(), 0)
  {
  }

  /// from, to: the triangles that contain the points. Returns the first triangle and the
  /// half-edges; -1 if there is no path.
  std::pair<int, std::vector<int>> Find(const std::vector<int>& from, const RowVector3d& start,
    const std::vector<int>& to, const RowVector3d& target, const Progress& progress)
  {
    this->Clear();
    this->Target = target;
    for (const int triangle : from)
    {
      if (std::find(to.begin(), to.end(), triangle) != to.end())
      {
        return { triangle, {} };
      }
      for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
      {
        this->Reach(side, -1, start, 0.0);
      }
    }
    double best = std::numeric_limits<double>::infinity();
    int last = -1;
    // A* search over half-edges. The straight distance to the target never exceeds the length of
    // the path that is left.
    for (int steps = 0; !this->Queue.empty() && this->Queue.top().first < best; ++steps)
    {
      const auto [bound, side] = this->Queue.top();
      this->Queue.pop();
      if (steps % 1024 == 0)
      {
        progress(0.0);
      }
      if (this->IsDone[side] != 0)
      {
        continue;
      }
      this->IsDone[side] = 1;
      const int twin = this->Twins[side];
      if (std::find(to.begin(), to.end(), twin / 3) != to.end())
      {
        best = bound;
        last = side;
        continue;
      }
      const RowVector3d from = this->Crossings[side];
      for (const int next : { NextHalfEdge(twin), PreviousHalfEdge(twin) })
      {
        this->Reach(next, side, from, this->Distances[side]);
      }
    }
    std::vector<int> sides;
    for (int side = last; side >= 0; side = this->Before[side])
    {
      sides.push_back(side);
    }
    std::reverse(sides.begin(), sides.end());
    return { sides.empty() ? -1 : sides.front() / 3, sides };
  }

private:
  /// Clears the last search.
  void Clear()
  {
    for (const int side : this->Reached)
    {
      this->Bounds[side] = std::numeric_limits<double>::infinity();
      this->IsDone[side] = 0;
    }
    this->Reached.clear();
    this->Queue = {};
  }

  /// Returns where the shortest path from a position to the target, straight on both sides of a
  /// half-edge, crosses it.
  RowVector3d CrossingOf(int side, const RowVector3d& from) const
  {
    const int next = NextHalfEdge(side);
    const RowVector3d begin =
      this->Triangulation.Points.row(this->Triangulation.Triangles(side / 3, side % 3));
    const RowVector3d edge =
      this->Triangulation.Points.row(this->Triangulation.Triangles(next / 3, next % 3)) - begin;
    const double squared = edge.squaredNorm();
    if (!(squared > 0.0))
    {
      return begin;
    }
    const auto foot = [&](const RowVector3d& position)
    { return (position - begin).dot(edge) / squared; };
    const double near = foot(from), far = foot(this->Target);
    const double height = (from - begin - near * edge).norm();
    const double both = height + (this->Target - begin - far * edge).norm();
    // Both are unfolded about the edge into one plane, on its two sides: the straight line divides
    // the edge in the ratio of the heights.
    const double share = both > 0.0 ? near + (far - near) * height / both : near;
    return begin + std::clamp(share, 0.0, 1.0) * edge;
  }

  void Reach(int side, int before, const RowVector3d& from, double distance)
  {
    if (this->Twins[side] < 0 || this->IsDone[side] != 0)
    {
      return;
    }
    const RowVector3d crossing = this->CrossingOf(side, from);
    const double own = distance + (crossing - from).norm();
    const double left = (this->Target - crossing).norm();
    if (own + left < this->Bounds[side])
    {
      if (std::isinf(this->Bounds[side]))
      {
        this->Reached.push_back(side);
      }
      this->Bounds[side] = own + left;
      this->Crossings[side] = crossing;
      this->Distances[side] = own;
      this->Before[side] = before;
      this->Queue.push({ own + left, side });
    }
  }

  using Item = std::pair<double, int>;

  const Mesh& Triangulation;
  const std::vector<int>& Twins;
  RowVector3d Target;
  // For each half-edge: a lower bound for paths through it, the length up to it, the crossing, and
  // the previous half-edge.
  std::vector<double> Bounds, Distances;
  std::vector<RowVector3d> Crossings;
  std::vector<int> Before;
  std::vector<char> IsDone;
  std::vector<int> Reached;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> Queue;
};

SurfacePaths::SurfacePaths(const Surface& surface)
  : Searched(surface)
  , OppositeHalfEdges(TwinsOf(surface))
  , Search(std::make_unique<StripSearch>(this->Searched, this->OppositeHalfEdges))
{
}

SurfacePaths::~SurfacePaths() = default;

std::vector<int> SurfacePaths::TrianglesAt(const SurfacePoint& position) const
{
  std::vector<int> triangles = { position.Triangle };
  const PointSupport support(this->Searched, position);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int side = 3 * triangles[i]; side < 3 * triangles[i] + 3; ++side)
    {
      const int twin = this->OppositeHalfEdges[side];
      if (twin >= 0 && support.IsIn(this->Searched.Triangles().row(twin / 3)) &&
        std::find(triangles.begin(), triangles.end(), twin / 3) == triangles.end())
      {
        triangles.push_back(twin / 3);
      }
    }
  }
  return triangles;
}

// 1. Find a strip of triangles by A* search (StripSearch).
// 2. Find the shortest path within it in the plane (TriangleStrip::FindPath).
// 3. Xin and Wang: lead the strip around each point that the path can be shortened around, and
//    repeat while that makes the path shorter.
std::optional<SurfacePath> SurfacePaths::FindIfConnected(
  const SurfacePoint& from, const SurfacePoint& to, const Progress& progress)
{
  auto [first, sides] =
    this->Search->Find(this->TrianglesAt(from), GetPosition(this->Searched, from),
      this->TrianglesAt(to), GetPosition(this->Searched, to), progress);
  if (first < 0)
  {
    return std::nullopt;
  }
  TriangleStrip strip(this->Searched, this->OppositeHalfEdges, from, to, first, std::move(sides));
  strip.FindPath();
  double length = std::numeric_limits<double>::infinity();
  while (strip.Length() < length && strip.LeadAround())
  {
    progress(0.5);
    length = strip.Length();
    strip.FindPath();
  }
  return strip.Path();
}

SurfacePath SurfacePaths::Find(
  const SurfacePoint& from, const SurfacePoint& to, const Progress& progress)
{
  std::optional<SurfacePath> path = this->FindIfConnected(from, to, progress);
  if (!path)
  {
    throw InvalidInput("no path over the surface leads from triangle " +
      std::to_string(from.Triangle) + " to triangle " + std::to_string(to.Triangle) +
      "; they lie on parts that are not connected or not consistently oriented: merge their points "
      "with Clean, orient them with Generate Surface Normals (Consistency), or give points on one "
      "part");
  }
  return std::move(*path);
}

} // namespace shape
