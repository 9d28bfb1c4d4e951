#include "Geodesics/TriangleStrip.h"

#include "Geodesics/Private/PlanarFunnel.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

double Cross(const RowVector2d& a, const RowVector2d& b)
{
  return a(0) * b(1) - a(1) * b(0);
}

/// Returns the angle between two directions, in [0, pi].
double Angle(const RowVector2d& a, const RowVector2d& b)
{
  return std::atan2(std::abs(Cross(a, b)), a.dot(b));
}

} // namespace

PointSupport::PointSupport(const Mesh& surface, const SurfacePoint& position)
{
  for (int k = 0; k < 3; ++k)
  {
    if (position.Barycentric(k) > 0.0)
    {
      this->Points[this->Count] = surface.Triangles(position.Triangle, k);
      this->Weights[this->Count++] = position.Barycentric(k);
    }
  }
}

bool PointSupport::IsIn(const Eigen::RowVector3i& triangle) const
{
  return std::all_of(this->Points.begin(), this->Points.begin() + this->Count,
    [&](int point) { return (triangle.array() == point).any(); });
}

bool PointSupport::IsOn(int a, int b) const
{
  return std::all_of(this->Points.begin(), this->Points.begin() + this->Count,
    [&](int point) { return point == a || point == b; });
}

SurfacePoint PointSupport::In(const Mesh& surface, int triangle) const
{
  SurfacePoint position{ triangle, RowVector3d::Zero() };
  for (int i = 0; i < this->Count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (surface.Triangles(triangle, k) == this->Points[i])
      {
        position.Barycentric(k) = this->Weights[i];
      }
    }
  }
  return position;
}

TriangleStrip::TriangleStrip(const Mesh& surface, const std::vector<int>& twins,
  const SurfacePoint& from, const SurfacePoint& to, int first, std::vector<int> sides)
  : Triangulation(surface)
  , Twins(twins)
  , From(surface, from)
  , To(surface, to)
  , First(first)
  , Sides(std::move(sides))
{
}

void TriangleStrip::FindPath()
{
  this->Trim();
  this->LayOut();
  this->FindTurns();
}

/// Xin and Wang: a path that turns at a point is shortest only if the angle on the other side is at
/// least pi, too.
bool TriangleStrip::LeadAround()
{
  constexpr double rounding = 1e-9; // tolerance of an angle
  // From last to first, so the indices of half-edges still to be visited do not change.
  bool hasChanged = false;
  auto unchanged = static_cast<int>(this->Sides.size());
  // A detour replaces the half-edges around a point by those on its other side.
  for (int i = static_cast<int>(this->Turns.size()) - 1; i >= 0; --i)
  {
    const Turn& turn = this->Turns[i];
    std::vector<int> detour;
    if (turn.Last < unchanged &&
      this->AngleAround(this->Sides[turn.First], turn.Point) - this->AngleInStrip(i) <
        M_PI - rounding &&
      this->Detour(turn, detour))
    {
      const auto begin = this->Sides.begin();
      this->Sides.erase(begin + turn.First, begin + turn.Last + 1);
      this->Sides.insert(this->Sides.begin() + turn.First, detour.begin(), detour.end());
      unchanged = turn.First;
      hasChanged = true;
    }
  }
  return hasChanged;
}

/// Returns the triangle after `step` half-edges.
int TriangleStrip::TriangleAt(int step) const
{
  return step == 0 ? this->First : this->Twins[this->Sides[step - 1]] / 3;
}

int TriangleStrip::Begin(int side) const
{
  return this->Triangulation.Triangles(side / 3, side % 3);
}

int TriangleStrip::End(int side) const
{
  return this->Begin(NextHalfEdge(side));
}

int TriangleStrip::Apex(int side) const
{
  return this->Begin(PreviousHalfEdge(side));
}

bool TriangleStrip::Touches(int side, int point) const
{
  return this->Begin(side) == point || this->End(side) == point;
}

/// Removes steps that go forth and back, and edges that contain an end of the path.
void TriangleStrip::Trim()
{
  std::vector<int> kept;
  for (const int side : this->Sides)
  {
    if (!kept.empty() && this->Twins[side] == kept.back())
    {
      kept.pop_back();
    }
    else
    {
      kept.push_back(side);
    }
  }
  std::size_t begin = 0;
  while (begin < kept.size() && this->From.IsOn(this->Begin(kept[begin]), this->End(kept[begin])))
  {
    this->First = this->Twins[kept[begin++]] / 3;
  }
  while (kept.size() > begin && this->To.IsOn(this->Begin(kept.back()), this->End(kept.back())))
  {
    kept.pop_back();
  }
  this->Sides.assign(kept.begin() + static_cast<std::ptrdiff_t>(begin), kept.end());
}

/// Returns the apex of a half-edge's triangle, to the left of the half-edge in the plane.
RowVector2d TriangleStrip::ApexPosition(
  int side, const RowVector2d& begin, const RowVector2d& end) const
{
  const auto& points = this->Triangulation.Points;
  const RowVector3d edge = points.row(this->End(side)) - points.row(this->Begin(side));
  const RowVector3d apex = points.row(this->Apex(side)) - points.row(this->Begin(side));
  const double length = edge.norm();
  if (!(length > 0.0))
  {
    return begin + RowVector2d(0.0, apex.norm());
  }
  // The same coordinates along and across the edge as in space, so lengths are kept.
  const RowVector2d along = (end - begin).normalized();
  return begin + (apex.dot(edge) / length) * along +
    (apex.cross(edge).norm() / length) * RowVector2d(-along(1), along(0));
}

/// Returns the planar position of a point in the triangle of a half-edge.
RowVector2d TriangleStrip::PositionOf(const PointSupport& support, int side,
  const RowVector2d& begin, const RowVector2d& end, const RowVector2d& apex) const
{
  RowVector2d position = RowVector2d::Zero();
  for (int i = 0; i < support.Count; ++i)
  {
    const int point = support.Points[i];
    position += support.Weights[i] *
      (point == this->Begin(side)    ? begin
          : point == this->End(side) ? end
                                     : apex);
  }
  return position;
}

/// Unfolds the strip into the plane. A half-edge begins on the right of the path across it.
void TriangleStrip::LayOut()
{
  this->Portals.clear();
  const bool isOneTriangle = this->Sides.empty();
  const int first = isOneTriangle ? 3 * this->First : this->Sides.front();
  const RowVector3d edge = this->Triangulation.Points.row(this->End(first)) -
    this->Triangulation.Points.row(this->Begin(first));
  Portal portal{ { edge.norm(), 0.0 }, { 0.0, 0.0 } };
  RowVector2d apex = this->ApexPosition(first, portal.Right, portal.Left);
  this->FromPosition = this->PositionOf(this->From, first, portal.Right, portal.Left, apex);
  this->ToPosition = this->PositionOf(this->To, first, portal.Right, portal.Left, apex);
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    this->Portals.push_back(portal);
    const int twin = this->Twins[this->Sides[i]];
    apex = this->ApexPosition(twin, portal.Left, portal.Right);
    if (i + 1 == this->Sides.size())
    {
      this->ToPosition = this->PositionOf(this->To, twin, portal.Left, portal.Right, apex);
    }
    else if (this->Sides[i + 1] == NextHalfEdge(twin))
    {
      portal.Left = apex;
    }
    else
    {
      portal.Right = apex;
    }
  }
}

/// Computes the turns and the length of the shortest path in the plane.
void TriangleStrip::FindTurns()
{
  PlanarFunnel funnel(this->FromPosition);
  const auto count = static_cast<int>(this->Portals.size());
  for (int i = 0; i < count; ++i)
  {
    // Consecutive half-edges share a point, on the left or on the right; only the other end is new.
    if (i == 0 || this->End(this->Sides[i]) != this->End(this->Sides[i - 1]))
    {
      funnel.AddLeft(this->Portals[i].Left, i);
    }
    if (i == 0 || this->Begin(this->Sides[i]) != this->Begin(this->Sides[i - 1]))
    {
      funnel.AddRight(this->Portals[i].Right, i);
    }
  }
  // The target closes the funnel as the end of a last portal.
  funnel.AddLeft(this->ToPosition, count);
  this->Turns.clear();
  this->PathLength = 0.0;
  RowVector2d before = this->FromPosition;
  for (const FunnelPoint& at : funnel.PathToLast())
  {
    const int side = this->Sides[at.Portal];
    const int point = at.IsLeft ? this->End(side) : this->Begin(side);
    // A path that turns at a point touches all half-edges of the strip around it.
    int last = at.Portal;
    while (last + 1 < count && this->Touches(this->Sides[last + 1], point))
    {
      ++last;
    }
    this->Turns.push_back({ at.Portal, last, at.IsLeft, point, at.Position });
    this->PathLength += (at.Position - before).norm();
    before = at.Position;
  }
  this->PathLength += (this->ToPosition - before).norm();
}

/// Returns the angle between the path before and after a turn, measured through the strip.
double TriangleStrip::AngleInStrip(std::size_t turn) const
{
  const Turn& at = this->Turns[turn];
  const RowVector2d before = turn == 0 ? this->FromPosition : this->Turns[turn - 1].Position;
  const RowVector2d after =
    turn + 1 == this->Turns.size() ? this->ToPosition : this->Turns[turn + 1].Position;
  RowVector2d direction = before - at.Position;
  double angle = 0.0;
  for (int i = at.First; i <= at.Last; ++i)
  {
    const RowVector2d next =
      (at.IsLeft ? this->Portals[i].Right : this->Portals[i].Left) - at.Position;
    angle += Angle(direction, next);
    direction = next;
  }
  return angle + Angle(direction, after - at.Position);
}

/// Returns the sum of the angles of all triangles around a point of a half-edge; infinite on the
/// boundary.
double TriangleStrip::AngleAround(int side, int point) const
{
  const int first = this->Begin(side) == point ? side : NextHalfEdge(side);
  double angle = 0.0;
  int at = first;
  do
  {
    const RowVector3d position = this->Triangulation.Points.row(point);
    const RowVector3d a = this->Triangulation.Points.row(this->End(at)) - position;
    const RowVector3d b = this->Triangulation.Points.row(this->Apex(at)) - position;
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
    at = this->Twins[PreviousHalfEdge(at)];
  } while (at >= 0 && at != first);
  return at < 0 ? std::numeric_limits<double>::infinity() : angle;
}

/// Finds the half-edges on the other side of a point, from the triangle before a turn to the one
/// after it. Returns false if the boundary is in between.
bool TriangleStrip::Detour(const Turn& turn, std::vector<int>& sides) const
{
  const int after = this->TriangleAt(turn.Last + 1);
  for (int at = this->Sides[turn.First]; at / 3 != after;)
  {
    const int side = turn.IsLeft ? NextHalfEdge(at) : PreviousHalfEdge(at);
    at = this->Twins[side];
    if (at < 0)
    {
      return false;
    }
    sides.push_back(side);
  }
  return true;
}

/// Returns where the straight line between two positions in the plane crosses a half-edge.
SurfacePoint TriangleStrip::Crossing(
  int step, const RowVector2d& before, const RowVector2d& after) const
{
  // relative to the edge: a position this close to an end is that end
  constexpr double rounding = 1e-12;
  const Portal& portal = this->Portals[step];
  const RowVector2d across = portal.Left - portal.Right, along = after - before;
  const double sine = Cross(across, along);
  double share = sine != 0.0 ? Cross(before - portal.Right, along) / sine : 0.5;
  share = share < rounding ? 0.0 : share > 1.0 - rounding ? 1.0 : share;
  const int side = this->Sides[step];
  SurfacePoint position{ side / 3, RowVector3d::Zero() };
  position.Barycentric(side % 3) = 1.0 - share;
  position.Barycentric(NextHalfEdge(side) % 3) = share;
  return position;
}

/// Returns a triangle, among some steps of the strip, that contains two points of the path.
int TriangleStrip::TriangleOfBoth(
  const PointSupport& a, const PointSupport& b, int first, int last) const
{
  int step = first;
  while (step < last &&
    !(a.IsIn(this->Triangulation.Triangles.row(this->TriangleAt(step))) &&
      b.IsIn(this->Triangulation.Triangles.row(this->TriangleAt(step)))))
  {
    ++step;
  }
  return this->TriangleAt(step);
}

SurfacePath TriangleStrip::Path() const
{
  SurfacePath path;
  path.Length = this->PathLength;
  path.Positions.push_back(this->From.In(this->Triangulation, this->First));
  const auto add = [&](const SurfacePoint& position, int triangle)
  {
    const PointSupport before(this->Triangulation, path.Positions.back()),
      own(this->Triangulation, position);
    if (own.Count > 1 || before.Count > 1 || own.Points[0] != before.Points[0])
    {
      path.Positions.push_back(position);
      path.Triangles.push_back(triangle);
    }
  };
  // From turn to turn: the edges that a segment crosses do not touch its two turns.
  const auto count = static_cast<int>(this->Sides.size());
  int begin = 0, next = 0; // the first step at the previous turn, and the first one after it
  RowVector2d before = this->FromPosition;
  for (std::size_t i = 0; i <= this->Turns.size(); ++i)
  {
    const bool isEnd = i == this->Turns.size();
    const RowVector2d after = isEnd ? this->ToPosition : this->Turns[i].Position;
    const int until = isEnd ? count : this->Turns[i].First;
    const int end = isEnd ? count : this->Turns[i].Last + 1;
    const bool crosses = next < until;
    for (; next < until; ++next)
    {
      add(this->Crossing(next, before, after), this->Sides[next] / 3);
    }
    SurfacePoint position{ this->TriangleAt(end), RowVector3d::Zero() };
    if (isEnd)
    {
      position = this->To.In(this->Triangulation, position.Triangle);
    }
    else
    {
      const Eigen::RowVector3i corners = this->Triangulation.Triangles.row(position.Triangle);
      position.Barycentric = (corners.array() == this->Turns[i].Point).cast<double>();
    }
    add(position,
      crosses ? this->TriangleAt(until)
              : this->TriangleOfBoth(PointSupport(this->Triangulation, path.Positions.back()),
                  PointSupport(this->Triangulation, position), begin, end));
    begin = until;
    next = std::max(next, end);
    before = after;
  }
  return path;
}

} // namespace shape
