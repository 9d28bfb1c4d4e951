#include "Geodesics/CreasePath.h"

#include "Base/Errors.h"
#include "Geometry/SegmentProjection.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Tolerance of costs, relative.
constexpr double CostRounding = 1e-12;

/// Returns the angle between the normals of an edge's triangles in radians, from -pi to pi. It is
/// positive at a concave edge.
double AngleAt(const Surface& surface, int side, int twin)
{
  const RowVector3d normal = surface.AreaVectors().row(side / 3);
  const RowVector3d other = surface.AreaVectors().row(twin / 3);
  const auto corner = [&](int halfEdge) -> RowVector3d
  { return surface.Points().row(surface.Triangles()(halfEdge / 3, halfEdge % 3)); };
  const double angle = std::atan2(normal.cross(other).norm(), normal.dot(other));
  return (corner(PreviousHalfEdge(twin)) - corner(side)).dot(normal) > 0.0 ? angle : -angle;
}

/// Returns the index of the edge from one node to a neighbour.
int FindLink(const Graph& graph, int node, int neighbour)
{
  const auto begin = graph.Neighbours.begin();
  return static_cast<int>(
    std::lower_bound(begin + graph.First[node], begin + graph.First[node + 1], neighbour) - begin);
}

double FactorAt(const Surface& surface, int side, int twin, const CreaseOptions& options)
{
  const double angle = AngleAt(surface, side, twin);
  using Type = CreaseOptions::CreasesType;
  const double share = options.Creases == Type::Concave ? std::max(angle, 0.0)
    : options.Creases == Type::Convex                   ? std::max(-angle, 0.0)
                                                        : std::abs(angle);
  return 1.0 / (1.0 + options.CreaseWeight * share / (0.5 * M_PI));
}

} // namespace

void RequireOptions(const CreaseOptions& options)
{
  RequireOption(options.CreaseWeight >= 0.0 && options.CreaseWeight <= 1e6, "CreaseWeight",
    options.CreaseWeight, "from 0 to 1e+06");
  RequireOption(options.CreaseReach >= 0.0 && options.CreaseReach <= 0.5, "CreaseReach",
    options.CreaseReach, "from 0 to 0.5");
}

CreasePaths::CreasePaths(const Surface& surface, SurfacePaths& paths, const CreaseOptions& options)
  : Searched(surface)
  , Paths(paths)
  , Edges(GetEdgeGraph(surface))
  , Factors(surface.Triangles().size(), 1.0)
  , Costs(this->Edges->Lengths)
  , Triangles(this->Edges->Lengths.size(), -1)
{
  RequireOptions(options);
  for (int side = 0; side < static_cast<int>(this->Factors.size()); ++side)
  {
    const int twin = paths.Twins()[side];
    if (twin >= 0)
    {
      this->Factors[side] = FactorAt(surface, side, twin, options);
    }
    const int next = NextHalfEdge(side);
    const int ends[] = { surface.Triangles()(side / 3, side % 3),
      surface.Triangles()(next / 3, next % 3) };
    for (const int i : { 0, 1 })
    {
      const int link = FindLink(*this->Edges, ends[i], ends[1 - i]);
      this->Costs[link] = this->Edges->Lengths[link] * this->Factors[side];
      this->Triangles[link] = side / 3;
    }
  }
}

SurfacePoint CreasePaths::AtPoint(int point, int triangle) const
{
  const Eigen::RowVector3i corners = this->Searched.Triangles().row(triangle);
  return { triangle, (corners.array() == point).cast<double>() };
}

/// The straight path between two points of a triangle.
CreasePaths::Piece CreasePaths::Straight(
  const SurfacePoint& from, const SurfacePoint& to, int triangle) const
{
  const PointSupport begin(this->Searched, from), end(this->Searched, to);
  Piece piece{ { { begin.In(this->Searched, triangle), end.In(this->Searched, triangle) },
                 { triangle }, 0.0 },
    0.0, false };
  piece.Path.Length = (GetPosition(this->Searched, to) - GetPosition(this->Searched, from)).norm();
  piece.Cost = piece.Path.Length;
  for (int k = 0; k < 3; ++k)
  {
    const int a = this->Searched.Triangles()(triangle, k);
    const int b = this->Searched.Triangles()(triangle, (k + 1) % 3);
    if (begin.IsOn(a, b) && end.IsOn(a, b))
    {
      piece.Cost = this->Factors[3 * triangle + k] * piece.Path.Length;
    }
  }
  return piece;
}

std::vector<CreasePaths::NextPoint> CreasePaths::NextPoints(const SurfacePoint& end) const
{
  const PointSupport support(this->Searched, end);
  if (support.Count == 1)
  {
    return { { support.Points[0], 0.0, end.Triangle } };
  }
  std::vector<NextPoint> points;
  for (const int triangle : this->Paths.TrianglesAt(end))
  {
    for (const int corner : this->Searched.Triangles().row(triangle))
    {
      points.push_back(
        { corner, this->Straight(end, this->AtPoint(corner, triangle), triangle).Cost, triangle });
    }
  }
  return points;
}

/// Dijkstra's algorithm over the edges, and over the lines from the two ends to the corners of
/// their triangles. Returns the cheapest path, in pieces of one edge or line; empty if there is
/// none.
std::vector<CreasePaths::Piece> CreasePaths::FindAlongEdges(
  const SurfacePoint& from, const SurfacePoint& to) const
{
  const std::vector<NextPoint> starts = this->NextPoints(from), ends = this->NextPoints(to);
  GraphSources sources;
  sources.Distances.resize(static_cast<Eigen::Index>(starts.size()));
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    sources.Nodes.push_back(starts[i].Point);
    sources.Distances(static_cast<Eigen::Index>(i)) = starts[i].Cost;
  }
  Eigen::VectorXd costs = Eigen::VectorXd::Constant(
    this->Searched.Points().rows(), std::numeric_limits<double>::infinity());
  std::vector<int> before(costs.size(), -1);
  double best = std::numeric_limits<double>::infinity();
  const NextPoint* last = nullptr;
  RunDijkstra(
    *this->Edges, sources, costs, [&](double cost, int link) { return cost + this->Costs[link]; },
    [&](int node, int previous) { before[node] = previous; },
    [&](int node)
    {
      for (const NextPoint& end : ends)
      {
        if (end.Point == node && costs(node) + end.Cost < best)
        {
          best = costs(node) + end.Cost;
          last = &end;
        }
      }
      return costs(node) >= best;
    });
  std::vector<Piece> pieces;
  if (!last)
  {
    return pieces;
  }
  if (last->Cost > 0.0)
  {
    pieces.push_back(
      this->Straight(this->AtPoint(last->Point, last->Triangle), to, last->Triangle));
  }
  int node = last->Point;
  for (; before[node] >= 0; node = before[node])
  {
    const int triangle = this->Triangles[FindLink(*this->Edges, node, before[node])];
    pieces.push_back(this->Straight(
      this->AtPoint(before[node], triangle), this->AtPoint(node, triangle), triangle));
  }
  const NextPoint* first = nullptr;
  for (const NextPoint& start : starts)
  {
    if (start.Point == node && (!first || start.Cost < first->Cost))
    {
      first = &start;
    }
  }
  if (first->Cost > 0.0)
  {
    pieces.push_back(
      this->Straight(from, this->AtPoint(first->Point, first->Triangle), first->Triangle));
  }
  std::reverse(pieces.begin(), pieces.end());
  return pieces;
}

/// Returns the shortest path between two points as a piece, if its length is less than `limit`.
std::optional<CreasePaths::Piece> CreasePaths::FindShorter(
  const SurfacePoint& from, const SurfacePoint& to, double limit, const Progress& progress)
{
  // A path is at least as long as the straight line through space.
  if (!((GetPosition(this->Searched, to) - GetPosition(this->Searched, from)).norm() < limit))
  {
    return std::nullopt;
  }
  std::optional<SurfacePath> path = this->Paths.FindIfConnected(from, to, progress);
  if (!path || !(path->Length < limit))
  {
    return std::nullopt;
  }
  const double length = path->Length;
  return Piece{ std::move(*path), length, false };
}

/// Replaces two consecutive pieces by the shortest path over both if this lowers the cost. Away
/// from creases it always does (triangle inequality), so straight paths double their length in each
/// pass; at creases they stop. Returns whether there was a change.
bool CreasePaths::Join(std::vector<Piece>& pieces, const Progress& progress)
{
  bool isChanged = false;
  std::vector<Piece> joined;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    progress(0.5);
    Piece& own = pieces[i];
    if (i + 1 < pieces.size() && !own.IsKept)
    {
      const Piece& next = pieces[i + 1];
      const bool isStraight = own.Cost == own.Path.Length && next.Cost == next.Path.Length;
      std::optional<Piece> both = this->FindShorter(own.Path.Positions.front(),
        next.Path.Positions.back(),
        (isStraight ? 1.0 + CostRounding : 1.0 - CostRounding) * (own.Cost + next.Cost), progress);
      if (both)
      {
        if (!joined.empty())
        {
          joined.back().IsKept = false; // it has another neighbour
        }
        joined.push_back(std::move(*both));
        isChanged = true;
        ++i;
        continue;
      }
      own.IsKept = true;
    }
    joined.push_back(std::move(own));
  }
  pieces = std::move(joined);
  return isChanged;
}

/// Lets straight paths meet creases earlier. If a piece ends at a point with a crease, it may end
/// at the other point of the crease instead, with the crease as another piece. Returns whether
/// there was a change.
bool CreasePaths::Slide(std::vector<Piece>& pieces, const Progress& progress)
{
  bool isChanged = false;
  for (std::size_t i = 0; i < 2 * pieces.size(); ++i)
  {
    const bool isBack = i % 2 == 1;
    const std::size_t index = i / 2;
    const Piece& own = pieces[index];
    const SurfacePoint& near = isBack ? own.Path.Positions.back() : own.Path.Positions.front();
    const SurfacePoint& far = isBack ? own.Path.Positions.front() : own.Path.Positions.back();
    const PointSupport joint(this->Searched, near);
    const bool isInside = isBack ? index + 1 < pieces.size() : index > 0;
    // A piece of one edge has nothing to gain: Dijkstra's algorithm found it.
    if (!isInside || joint.Count > 1 || own.Path.Triangles.size() < 2)
    {
      continue;
    }
    for (int k = this->Edges->First[joint.Points[0]]; k < this->Edges->First[joint.Points[0] + 1];
         ++k)
    {
      if (!(this->Costs[k] < this->Edges->Lengths[k]))
      {
        continue;
      }
      const SurfacePoint other = this->AtPoint(this->Edges->Neighbours[k], this->Triangles[k]);
      const double left = (1.0 - CostRounding) * own.Cost - this->Costs[k];
      std::optional<Piece> shorter = isBack ? this->FindShorter(far, other, left, progress)
                                            : this->FindShorter(other, far, left, progress);
      if (shorter)
      {
        const SurfacePoint end = this->AtPoint(joint.Points[0], this->Triangles[k]);
        Piece edge = isBack ? this->Straight(other, end, this->Triangles[k])
                            : this->Straight(end, other, this->Triangles[k]);
        pieces[index] = std::move(*shorter);
        pieces.insert(
          pieces.begin() + static_cast<std::ptrdiff_t>(index + (isBack ? 1 : 0)), std::move(edge));
        isChanged = true;
        break;
      }
    }
  }
  if (isChanged)
  {
    for (Piece& piece : pieces)
    {
      piece.IsKept = false;
    }
  }
  return isChanged;
}

// 1. Find the shortest path. If creases save nothing, it is the result.
// 2. Find the cheapest path along edges (FindAlongEdges).
// 3. Straighten it where creases save nothing (Join), and move the points where it meets creases
//    (Slide), until neither lowers the cost.
SurfacePath CreasePaths::Find(
  const SurfacePoint& from, const SurfacePoint& to, const Progress& progress)
{
  SurfacePath shortest = this->Paths.Find(from, to, progress);
  std::vector<Piece> pieces = this->FindAlongEdges(from, to);
  if (shortest.Triangles.size() == 1)
  {
    // Both ends lie in one triangle: perhaps on an edge of it, which is not a link of two points.
    Piece straight = this->Straight(from, to, shortest.Triangles.front());
    if (straight.Cost < shortest.Length)
    {
      pieces = { std::move(straight) };
    }
  }
  while (this->Join(pieces, progress) || this->Slide(pieces, progress))
  {
  }
  SurfacePath path;
  double cost = 0.0;
  for (const Piece& piece : pieces)
  {
    const std::vector<SurfacePoint>& positions = piece.Path.Positions;
    path.Positions.insert(
      path.Positions.end(), positions.begin() + (path.Positions.empty() ? 0 : 1), positions.end());
    path.Triangles.insert(
      path.Triangles.end(), piece.Path.Triangles.begin(), piece.Path.Triangles.end());
    path.Length += piece.Path.Length;
    cost += piece.Cost;
  }
  return !pieces.empty() && cost < shortest.Length ? path : shortest;
}

SurfacePoint CreasePaths::MoveToCrease(const SurfacePoint& point, double reach) const
{
  constexpr double largest = 0.5; // cost over length of an edge that counts as a crease
  const RowVector3d position = GetPosition(this->Searched, point);
  SurfacePoint best = point;
  RowVector3d bestPosition = position;
  double bestScore = 0.0;
  std::vector<int> triangles = this->Paths.TrianglesAt(point);
  std::vector<char> isVisited(this->Searched.Triangles().rows(), 0);
  for (const int triangle : triangles)
  {
    isVisited[triangle] = 1;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const int triangle = triangles[i];
    const Eigen::Matrix3d corners = GetCorners(this->Searched, triangle);
    for (int k = 0; k < 3; ++k)
    {
      const int side = 3 * triangle + k, twin = this->Paths.Twins()[side];
      const RowVector3d begin = corners.row(k), edge = corners.row((k + 1) % 3) - begin;
      const double share = ProjectOntoSegment(position, begin, begin + edge);
      const RowVector3d on = begin + share * edge;
      const double distance = (on - position).norm();
      if (twin < 0 || !(distance < reach))
      {
        continue;
      }
      if (isVisited[twin / 3] == 0)
      {
        isVisited[twin / 3] = 1;
        triangles.push_back(twin / 3);
      }
      const double score = (1.0 - this->Factors[side]) * (1.0 - distance / reach);
      // Of equal scores, the position decides, and not the numbering.
      const auto key = [](double own, const RowVector3d& at)
      { return std::make_tuple(own, at(0), at(1), at(2)); };
      if (this->Factors[side] <= largest && key(score, on) > key(bestScore, bestPosition))
      {
        bestScore = score;
        bestPosition = on;
        best = { triangle, RowVector3d::Zero() };
        best.Barycentric(k) = 1.0 - share;
        best.Barycentric((k + 1) % 3) = share;
      }
    }
  }
  return best;
}

} // namespace shape
