#include "Geodesics/TriangleStrip.h"

#include "Mesh/HalfEdges.h"
#include "Geodesics/Private/PlanarFunnel.h"

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

/// Between two directions: in [0, pi].
double Angle(const RowVector2d& a, const RowVector2d& b)
{
  return std::atan2(std::abs(Cross(a, b)), a.dot(b));
}

} // namespace

PlaceSupport::PlaceSupport(const Mesh& surface, const SurfacePlace& place)
{
  for (int k = 0; k < 3; ++k)
  {
    if (place.Barycentric(k) > 0.0)
    {
      this->Points[this->Count] = surface.Triangles(place.Triangle, k);
      this->Weights[this->Count++] = place.Barycentric(k);
    }
  }
}

bool PlaceSupport::IsIn(const Eigen::RowVector3i& triangle) const
{
  return std::all_of(this->Points.begin(), this->Points.begin() + this->Count,
    [&](int point) { return (triangle.array() == point).any(); });
}

bool PlaceSupport::IsOn(int a, int b) const
{
  return std::all_of(this->Points.begin(), this->Points.begin() + this->Count,
    [&](int point) { return point == a || point == b; });
}

SurfacePlace PlaceSupport::In(const Mesh& surface, int triangle) const
{
  SurfacePlace place{ triangle, RowVector3d::Zero() };
  for (int i = 0; i < this->Count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (surface.Triangles(triangle, k) == this->Points[i])
      {
        place.Barycentric(k) = this->Weights[i];
      }
    }
  }
  return place;
}

TriangleStrip::TriangleStrip(const Mesh& surface, const std::vector<int>& twins,
  const SurfacePlace& from, const SurfacePlace& to, int first, std::vector<int> sides)
  : Surface(surface)
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

bool TriangleStrip::LeadAround()
{
  constexpr double rounding = 1e-9; // of an angle
  // From the last to the first, so that the numbers of sides still to be looked at stay.
  bool hasChanged = false;
  auto unchanged = static_cast<int>(this->Sides.size());
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

/// The triangle after so many sides.
int TriangleStrip::TriangleAt(int step) const
{
  return step == 0 ? this->First : this->Twins[this->Sides[step - 1]] / 3;
}

int TriangleStrip::Begin(int side) const
{
  return this->Surface.Triangles(side / 3, side % 3);
}

int TriangleStrip::End(int side) const
{
  return this->Begin(NextSide(side));
}

int TriangleStrip::Apex(int side) const
{
  return this->Begin(PreviousSide(side));
}

bool TriangleStrip::Touches(int side, int point) const
{
  return this->Begin(side) == point || this->End(side) == point;
}

/// Leaves out what goes back at once, and sides that an end of the path lies on.
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

/// A side's apex, left of the side laid out in the plane.
RowVector2d TriangleStrip::ApexPlace(
  int side, const RowVector2d& begin, const RowVector2d& end) const
{
  const auto& points = this->Surface.Points;
  const RowVector3d edge = points.row(this->End(side)) - points.row(this->Begin(side));
  const RowVector3d apex = points.row(this->Apex(side)) - points.row(this->Begin(side));
  const double length = edge.norm();
  if (!(length > 0.0))
  {
    return begin + RowVector2d(0.0, apex.norm());
  }
  const RowVector2d along = (end - begin).normalized();
  return begin + (apex.dot(edge) / length) * along +
    (apex.cross(edge).norm() / length) * RowVector2d(-along(1), along(0));
}

/// A place in the triangle of a side whose corners are laid out.
RowVector2d TriangleStrip::PlaceOf(const PlaceSupport& support, int side, const RowVector2d& begin,
  const RowVector2d& end, const RowVector2d& apex) const
{
  RowVector2d place = RowVector2d::Zero();
  for (int i = 0; i < support.Count; ++i)
  {
    const int point = support.Points[i];
    place += support.Weights[i] *
      (point == this->Begin(side)    ? begin
          : point == this->End(side) ? end
                                     : apex);
  }
  return place;
}

/// Unfolds the strip into the plane. A side's begin is on the right of the way over it.
void TriangleStrip::LayOut()
{
  this->Portals.clear();
  const bool isOneTriangle = this->Sides.empty();
  const int first = isOneTriangle ? 3 * this->First : this->Sides.front();
  const RowVector3d edge =
    this->Surface.Points.row(this->End(first)) - this->Surface.Points.row(this->Begin(first));
  Portal portal{ { edge.norm(), 0.0 }, { 0.0, 0.0 } };
  RowVector2d apex = this->ApexPlace(first, portal.Right, portal.Left);
  this->FromPlace = this->PlaceOf(this->From, first, portal.Right, portal.Left, apex);
  this->ToPlace = this->PlaceOf(this->To, first, portal.Right, portal.Left, apex);
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    this->Portals.push_back(portal);
    const int twin = this->Twins[this->Sides[i]];
    apex = this->ApexPlace(twin, portal.Left, portal.Right);
    if (i + 1 == this->Sides.size())
    {
      this->ToPlace = this->PlaceOf(this->To, twin, portal.Left, portal.Right, apex);
    }
    else if (this->Sides[i + 1] == NextSide(twin))
    {
      portal.Left = apex;
    }
    else
    {
      portal.Right = apex;
    }
  }
}

/// The shortest path in the plane: where it turns, and its length.
void TriangleStrip::FindTurns()
{
  PlanarFunnel funnel(this->FromPlace);
  const auto count = static_cast<int>(this->Portals.size());
  for (int i = 0; i < count; ++i)
  {
    if (i == 0 || this->End(this->Sides[i]) != this->End(this->Sides[i - 1]))
    {
      funnel.AddLeft(this->Portals[i].Left, i);
    }
    if (i == 0 || this->Begin(this->Sides[i]) != this->Begin(this->Sides[i - 1]))
    {
      funnel.AddRight(this->Portals[i].Right, i);
    }
  }
  funnel.AddLeft(this->ToPlace, count);
  this->Turns.clear();
  this->PathLength = 0.0;
  RowVector2d before = this->FromPlace;
  for (const FunnelPoint& at : funnel.PathToLast())
  {
    const int side = this->Sides[at.Portal];
    const int point = at.IsLeft ? this->End(side) : this->Begin(side);
    int last = at.Portal;
    while (last + 1 < count && this->Touches(this->Sides[last + 1], point))
    {
      ++last;
    }
    this->Turns.push_back({ at.Portal, last, at.IsLeft, point, at.Place });
    this->PathLength += (at.Place - before).norm();
    before = at.Place;
  }
  this->PathLength += (this->ToPlace - before).norm();
}

/// Between the path before and after a turn, through the strip.
double TriangleStrip::AngleInStrip(std::size_t turn) const
{
  const Turn& at = this->Turns[turn];
  const RowVector2d before = turn == 0 ? this->FromPlace : this->Turns[turn - 1].Place;
  const RowVector2d after =
    turn + 1 == this->Turns.size() ? this->ToPlace : this->Turns[turn + 1].Place;
  RowVector2d direction = before - at.Place;
  double angle = 0.0;
  for (int i = at.First; i <= at.Last; ++i)
  {
    const RowVector2d next =
      (at.IsLeft ? this->Portals[i].Right : this->Portals[i].Left) - at.Place;
    angle += Angle(direction, next);
    direction = next;
  }
  return angle + Angle(direction, after - at.Place);
}

/// The sum of the angles of all triangles around a point of a side; infinite on the border.
double TriangleStrip::AngleAround(int side, int point) const
{
  const int first = this->Begin(side) == point ? side : NextSide(side);
  double angle = 0.0;
  int at = first;
  do
  {
    const RowVector3d place = this->Surface.Points.row(point);
    const RowVector3d a = this->Surface.Points.row(this->End(at)) - place;
    const RowVector3d b = this->Surface.Points.row(this->Apex(at)) - place;
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
    at = this->Twins[PreviousSide(at)];
  } while (at >= 0 && at != first);
  return at < 0 ? std::numeric_limits<double>::infinity() : angle;
}

/// The sides on the other side of a point, from the triangle before a turn to the one after it;
/// false where the border is in between.
bool TriangleStrip::Detour(const Turn& turn, std::vector<int>& sides) const
{
  const int after = this->TriangleAt(turn.Last + 1);
  for (int at = this->Sides[turn.First]; at / 3 != after;)
  {
    const int side = turn.IsLeft ? NextSide(at) : PreviousSide(at);
    at = this->Twins[side];
    if (at < 0)
    {
      return false;
    }
    sides.push_back(side);
  }
  return true;
}

/// Where the straight way between two places of the plane crosses a side of the strip.
SurfacePlace TriangleStrip::Crossing(
  int step, const RowVector2d& before, const RowVector2d& after) const
{
  constexpr double rounding = 1e-12; // of a side: a place so near to its end is there
  const Portal& portal = this->Portals[step];
  const RowVector2d across = portal.Left - portal.Right, along = after - before;
  const double sine = Cross(across, along);
  double share = sine != 0.0 ? Cross(before - portal.Right, along) / sine : 0.5;
  share = share < rounding ? 0.0 : share > 1.0 - rounding ? 1.0 : share;
  const int side = this->Sides[step];
  SurfacePlace place{ side / 3, RowVector3d::Zero() };
  place.Barycentric(side % 3) = 1.0 - share;
  place.Barycentric(NextSide(side) % 3) = share;
  return place;
}

/// A triangle, of some steps of the strip, that two places of the path lie in.
int TriangleStrip::TriangleOfBoth(
  const PlaceSupport& a, const PlaceSupport& b, int first, int last) const
{
  int step = first;
  while (step < last &&
    !(a.IsIn(this->Surface.Triangles.row(this->TriangleAt(step))) &&
      b.IsIn(this->Surface.Triangles.row(this->TriangleAt(step)))))
  {
    ++step;
  }
  return this->TriangleAt(step);
}

SurfacePath TriangleStrip::Path() const
{
  SurfacePath path;
  path.Length = this->PathLength;
  path.Places.push_back(this->From.In(this->Surface, this->First));
  const auto add = [&](const SurfacePlace& place, int triangle)
  {
    const PlaceSupport before(this->Surface, path.Places.back()), own(this->Surface, place);
    if (own.Count > 1 || before.Count > 1 || own.Points[0] != before.Points[0])
    {
      path.Places.push_back(place);
      path.Triangles.push_back(triangle);
    }
  };
  // From turn to turn: the sides that the stretch crosses touch neither.
  const auto count = static_cast<int>(this->Sides.size());
  int begin = 0, next = 0; // the first step at the turn before, and the first one past it
  RowVector2d before = this->FromPlace;
  for (std::size_t i = 0; i <= this->Turns.size(); ++i)
  {
    const bool isEnd = i == this->Turns.size();
    const RowVector2d after = isEnd ? this->ToPlace : this->Turns[i].Place;
    const int until = isEnd ? count : this->Turns[i].First;
    const int end = isEnd ? count : this->Turns[i].Last + 1;
    const bool crosses = next < until;
    for (; next < until; ++next)
    {
      add(this->Crossing(next, before, after), this->Sides[next] / 3);
    }
    SurfacePlace place{ this->TriangleAt(end), RowVector3d::Zero() };
    if (isEnd)
    {
      place = this->To.In(this->Surface, place.Triangle);
    }
    else
    {
      const Eigen::RowVector3i corners = this->Surface.Triangles.row(place.Triangle);
      place.Barycentric = (corners.array() == this->Turns[i].Point).cast<double>();
    }
    add(place,
      crosses ? this->TriangleAt(until)
              : this->TriangleOfBoth(PlaceSupport(this->Surface, path.Places.back()),
                  PlaceSupport(this->Surface, place), begin, end));
    begin = until;
    next = std::max(next, end);
    before = after;
  }
  return path;
}

} // namespace shape
