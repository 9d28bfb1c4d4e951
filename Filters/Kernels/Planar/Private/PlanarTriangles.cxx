#include "Planar/Private/PlanarTriangles.h"

#include "Geometry/Orientation.h"

#include <array>

namespace shape
{

PlanarTriangles::PlanarTriangles(const Eigen::MatrixXd& points, const Eigen::Matrix2d& metric)
  : Metric(metric)
  , HasMetric(!metric.isIdentity(0.0))
{
  this->Positions.reserve(points.rows());
  this->Images.reserve(points.rows());
  this->FirstEdges.reserve(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    this->AddPosition(points.row(i));
  }
  const std::size_t sides = 6 * this->Positions.size();
  this->Begins.reserve(sides);
  this->Twins.reserve(sides);
  this->Marks.reserve(sides);
}

void PlanarTriangles::Start(int a, int b, int c)
{
  if (this->Turn(a, b, c) < 0)
  {
    std::swap(b, c);
  }
  const std::array<int, 3> corners = { a, b, c };
  for (int t = 0; t < 4; ++t)
  {
    this->NewTriangle();
  }
  for (int k = 0; k < 3; ++k)
  {
    // Triangle k + 1 lies outside side k.
    const int outside = 3 * (k + 1);
    this->SetBegin(k, corners[k]);
    this->SetBegin(outside, corners[(k + 1) % 3]);
    this->SetBegin(outside + 1, corners[k]);
    this->SetBegin(outside + 2, Far);
    this->Link(k, outside);
    this->Link(outside + 1, 3 * ((k + 2) % 3 + 1) + 2);
  }
}

int PlanarTriangles::AddPosition(const Eigen::RowVector2d& position)
{
  this->Positions.push_back(position);
  this->Images.push_back(this->HasMetric ? Eigen::RowVector2d(position * this->Metric) : position);
  this->FirstEdges.push_back(-1);
  return this->Points() - 1;
}

void PlanarTriangles::RemoveLastPosition()
{
  this->Positions.pop_back();
  this->Images.pop_back();
  this->FirstEdges.pop_back();
}

int PlanarTriangles::Insert(int point)
{
  const Location where = this->Locate(this->Positions[point]);
  if (where.Corner != Far)
  {
    return where.Corner;
  }
  if (where.IsOnEdge)
  {
    this->SplitEdge(where.Side, point);
  }
  else
  {
    this->SplitTriangle(where.Side / 3, point);
  }
  this->FlipAround();
  // The next point is likely to be near, so its search starts here.
  this->Last = this->From(point);
  while (this->IsFar(this->Last / 3))
  {
    this->Last = this->Twin(PreviousHalfEdge(this->Last));
  }
  return point;
}

bool PlanarTriangles::IsFar(int triangle) const
{
  const int side = 3 * triangle;
  return this->Begins[side] == Far || this->Begins[side + 1] == Far ||
    this->Begins[side + 2] == Far;
}

int PlanarTriangles::Turn(int a, int b, int c) const
{
  return EvaluateOrientation(this->Positions[a], this->Positions[b], this->Positions[c]);
}

void PlanarTriangles::SetMark(int side, const SegmentMark& mark)
{
  this->Marks[side] = mark;
  this->Marks[this->Twins[side]] = { mark.Group, -mark.Winding };
}

void PlanarTriangles::Flip(int side)
{
  const int twin = this->Twins[side];
  const int x = this->Begin(side), y = this->Begin(twin);
  const int c = this->Apex(side), d = this->Apex(twin);
  const int sideNext = NextHalfEdge(side), sideLast = PreviousHalfEdge(side);
  const int twinNext = NextHalfEdge(twin), twinLast = PreviousHalfEdge(twin);
  // The four outer half-edges change their numbers, with their twins and marks.
  const std::array<int, 4> from = { sideLast, twinNext, twinLast, sideNext };
  const std::array<int, 4> to = { sideNext, sideLast, twinNext, twinLast };
  std::array<int, 4> twins;
  std::array<SegmentMark, 4> marks;
  for (int i = 0; i < 4; ++i)
  {
    twins[i] = this->Twins[from[i]];
    marks[i] = this->Marks[from[i]];
  }
  for (int i = 0; i < 4; ++i)
  {
    this->Link(to[i], twins[i]);
    this->Marks[to[i]] = marks[i];
  }
  this->SetBegin(side, d);
  this->SetBegin(sideNext, c);
  this->SetBegin(sideLast, x);
  this->SetBegin(twin, c);
  this->SetBegin(twinNext, d);
  this->SetBegin(twinLast, y);
}

void PlanarTriangles::MakeDelaunay(std::vector<int> sides)
{
  while (!sides.empty())
  {
    const int side = sides.back();
    sides.pop_back();
    if (this->SplitsBetter(side))
    {
      const int twin = this->Twins[side];
      this->Flip(side);
      sides.insert(sides.end(),
        { NextHalfEdge(side), PreviousHalfEdge(side), NextHalfEdge(twin), PreviousHalfEdge(twin) });
    }
  }
}

/// Walks towards the position, across half-edges that separate the triangle from it.
PlanarTriangles::Location PlanarTriangles::Locate(const Eigen::RowVector2d& position) const
{
  int triangle = this->Last / 3, entered = -1;
  // In a Delaunay triangulation the walk ends; marked edges could make it cycle.
  for (int step = 0; step < this->Sides(); ++step)
  {
    int across = -1;
    for (int k = 0; k < 3 && across < 0; ++k)
    {
      // The first edge that is tested changes at every step, which makes a cycle unlikely.
      const int side = 3 * triangle + (k + step) % 3;
      if (side != entered &&
        EvaluateOrientation(
          this->Positions[this->Begin(side)], this->Positions[this->End(side)], position) < 0)
      {
        across = side;
      }
    }
    if (across < 0)
    {
      return this->LocateIn(triangle, position);
    }
    entered = this->Twins[across];
    triangle = entered / 3;
    if (this->IsFar(triangle))
    {
      return { entered };
    }
  }
  // The walk did not end: all triangles are tested.
  triangle = 0;
  while (!this->Contains(triangle, position))
  {
    ++triangle;
  }
  return this->IsFar(triangle) ? Location{ 3 * triangle } : this->LocateIn(triangle, position);
}

/// A triangle at infinity contains the positions strictly outside its hull edge.
bool PlanarTriangles::Contains(int triangle, const Eigen::RowVector2d& position) const
{
  for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
  {
    const int begin = this->Begin(side), end = this->End(side);
    if (begin != Far && end != Far &&
      EvaluateOrientation(this->Positions[begin], this->Positions[end], position) <
        (this->IsFar(triangle) ? 1 : 0))
    {
      return false;
    }
  }
  return true;
}

/// Returns the location of a position in a triangle that contains it.
PlanarTriangles::Location PlanarTriangles::LocateIn(
  int triangle, const Eigen::RowVector2d& position) const
{
  Location where{ 3 * triangle };
  for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
  {
    const Eigen::RowVector2d& begin = this->Positions[this->Begin(side)];
    if (begin == position)
    {
      where.Corner = this->Begin(side);
    }
    else if (EvaluateOrientation(begin, this->Positions[this->End(side)], position) == 0)
    {
      where.Side = side;
      where.IsOnEdge = true;
    }
  }
  return where;
}

/// Whether the edge is not marked and a flip makes it locally Delaunay. The circle of a triangle at
/// infinity is the half-plane outside its hull edge.
bool PlanarTriangles::SplitsBetter(int side) const
{
  const int x = this->Begin(side), y = this->End(side);
  const int c = this->Apex(side), d = this->Apex(this->Twins[side]);
  if (this->Marks[side].Group >= 0 || c == Far || d == Far)
  {
    return false;
  }
  if (x == Far)
  {
    return this->Turn(d, y, c) > 0;
  }
  if (y == Far)
  {
    return this->Turn(c, x, d) > 0;
  }
  // Images are rounded, so convexity does not follow from the circle test and is tested as well.
  return EvaluateInCircle(this->Images[x], this->Images[y], this->Images[c], this->Images[d]) > 0 &&
    (!this->HasMetric || (this->Turn(d, y, c) > 0 && this->Turn(c, x, d) > 0));
}

void PlanarTriangles::SplitTriangle(int triangle, int point)
{
  // Three triangles around the new point; the given one keeps its first edge.
  const int first = 3 * triangle;
  const std::array<int, 3> corners = { this->Begins[first], this->Begins[first + 1],
    this->Begins[first + 2] };
  const std::array<int, 3> outer = { first, 3 * this->NewTriangle(), 3 * this->NewTriangle() };
  for (int k = 1; k < 3; ++k)
  {
    this->Move(first + k, outer[k]);
  }
  for (int k = 0; k < 3; ++k)
  {
    this->SetBegin(outer[k], corners[k]);
    this->SetBegin(outer[k] + 1, corners[(k + 1) % 3]);
    this->SetBegin(outer[k] + 2, point);
    this->Link(outer[k] + 1, outer[(k + 1) % 3] + 2);
    this->Marks[outer[k] + 1] = this->Marks[outer[k] + 2] = {};
  }
  this->Suspects.assign(outer.begin(), outer.end());
}

void PlanarTriangles::SplitEdge(int side, int point)
{
  const int twin = this->Twins[side];
  const int x = this->Begin(side), y = this->Begin(twin);
  const int c = this->Apex(side), d = this->Apex(twin);
  // Four triangles around the new point. Both halves of the edge keep its mark.
  const SegmentMark mark = this->Marks[side];
  const int beyond = 3 * this->NewTriangle(), twinBeyond = 3 * this->NewTriangle();
  this->Move(NextHalfEdge(side), beyond + 1);
  this->Move(NextHalfEdge(twin), twinBeyond + 1);
  this->SetBegin(side, x);
  this->SetBegin(NextHalfEdge(side), point);
  this->SetBegin(beyond, point);
  this->SetBegin(beyond + 1, y);
  this->SetBegin(beyond + 2, c);
  this->SetBegin(twin, y);
  this->SetBegin(NextHalfEdge(twin), point);
  this->SetBegin(twinBeyond, point);
  this->SetBegin(twinBeyond + 1, x);
  this->SetBegin(twinBeyond + 2, d);
  this->Link(side, twinBeyond);
  this->Link(beyond, twin);
  this->Link(NextHalfEdge(side), beyond + 2);
  this->Link(NextHalfEdge(twin), twinBeyond + 2);
  this->SetMark(side, mark);
  this->SetMark(beyond, mark);
  this->SetMark(beyond + 2, {});
  this->SetMark(twinBeyond + 2, {});
  this->Suspects = { PreviousHalfEdge(side), beyond + 1, PreviousHalfEdge(twin), twinBeyond + 1 };
}

/// Flips the edges whose circles contain the new point, the apex of the suspects. Each flip adds an
/// edge to the new point, so the flips end.
void PlanarTriangles::FlipAround()
{
  while (!this->Suspects.empty())
  {
    const int side = this->Suspects.back();
    this->Suspects.pop_back();
    if (this->SplitsBetter(side))
    {
      const int twin = this->Twins[side];
      this->Flip(side);
      this->Suspects.push_back(PreviousHalfEdge(side));
      this->Suspects.push_back(NextHalfEdge(twin));
    }
  }
}

int PlanarTriangles::NewTriangle()
{
  this->Begins.resize(this->Begins.size() + 3, Far);
  this->Twins.resize(this->Twins.size() + 3, -1);
  this->Marks.resize(this->Marks.size() + 3);
  return this->Sides() / 3 - 1;
}

void PlanarTriangles::SetBegin(int side, int point)
{
  this->Begins[side] = point;
  if (point != Far)
  {
    this->FirstEdges[point] = side;
  }
}

void PlanarTriangles::Link(int side, int twin)
{
  this->Twins[side] = twin;
  this->Twins[twin] = side;
}

/// Moves the twin and the mark of a half-edge to another number.
void PlanarTriangles::Move(int from, int to)
{
  this->Link(to, this->Twins[from]);
  this->Marks[to] = this->Marks[from];
}

} // namespace shape
