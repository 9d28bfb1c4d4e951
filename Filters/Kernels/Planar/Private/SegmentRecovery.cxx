#include "Planar/Private/SegmentRecovery.h"

#include "Base/Errors.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace shape
{

/// k segments cross at most k (k - 1) / 2 times; the limit leaves room for crossings that rounding
/// adds.
SegmentRecovery::SegmentRecovery(PlanarTriangles& plane, bool addCrossings, Eigen::Index segments)
  : Plane(plane)
  , AddsCrossings(addCrossings)
  , MaximumPointCount(plane.Points() + 16.0 * segments * segments + 1000.0)
{
}

void SegmentRecovery::Recover(int begin, int end, int segment, int winding)
{
  this->Groups.push_back({ segment });
  this->Pieces = { { begin, end, { static_cast<int>(this->Groups.size()) - 1, winding } } };
  while (!this->Pieces.empty())
  {
    const Piece piece = this->Pieces.back();
    this->Pieces.pop_back();
    for (int at = piece.Begin; at != piece.End;)
    {
      at = this->Advance(at, piece);
    }
  }
}

/// Whether c lies on the ray from a through b.
bool SegmentRecovery::IsAhead(int a, int b, int c) const
{
  const Eigen::RowVector2d& from = this->Plane.Position(a);
  const Eigen::RowVector2d& to = this->Plane.Position(b);
  const Eigen::RowVector2d& position = this->Plane.Position(c);
  // A collinear point is ahead if its coordinate is on the same side of a's as that of b.
  const int axis = from(0) != to(0) ? 0 : 1;
  return (from(axis) < to(axis)) == (from(axis) < position(axis)) && this->Plane.Turn(a, b, c) == 0;
}

/// Makes the part of the piece from one of its points to the next an edge. Returns the next point.
int SegmentRecovery::Advance(int from, const Piece& piece)
{
  // The triangles around `from` are visited until an edge lies on the segment, or the segment
  // leaves through the opposite edge.
  const int to = piece.End;
  int side = this->Plane.From(from);
  while (true)
  {
    const int right = this->Plane.End(side), left = this->Plane.Apex(side);
    if (right != PlanarTriangles::Far)
    {
      if (right == to || this->IsAhead(from, to, right))
      {
        this->AddMark(side, piece.Mark);
        return right;
      }
      if (left != PlanarTriangles::Far && this->Plane.Turn(from, to, right) < 0 &&
        this->Plane.Turn(from, to, left) > 0)
      {
        return this->Cross(from, piece, this->Plane.Twin(NextHalfEdge(side)));
      }
    }
    side = this->Plane.Twin(PreviousHalfEdge(side));
  }
}

/// The same if edges are crossed. ahead: the half-edge of the first one, on its far side.
int SegmentRecovery::Cross(int from, const Piece& piece, int ahead)
{
  // The edges that the segment crosses are visited up to the next point on it. At a marked edge a
  // crossing is added. Otherwise OpenWay flips the edges, and the changed triangles are made
  // Delaunay again.
  const int first = ahead;
  while (true)
  {
    if (this->Plane.Mark(ahead).Group >= 0)
    {
      this->AddCrossing(from, piece, ahead);
      return piece.End;
    }
    const int next = this->Plane.Apex(ahead);
    const int turn = next == piece.End ? 0 : this->Plane.Turn(from, piece.End, next);
    if (turn == 0)
    {
      this->AddMark(this->Plane.Twin(this->OpenWay(from, next, first)), piece.Mark);
      std::vector<int> sides;
      for (const int triangle : this->Flipped)
      {
        sides.insert(sides.end(), { 3 * triangle, 3 * triangle + 1, 3 * triangle + 2 });
      }
      this->Plane.MakeDelaunay(std::move(sides));
      return next;
    }
    ahead = this->Plane.Twin(turn > 0 ? NextHalfEdge(ahead) : PreviousHalfEdge(ahead));
  }
}

/// Flips the edges that the line between two points crosses until the points share an edge. Returns
/// its half-edge from `to` to `from`. Corners left of the line are cut off one by one where their
/// chain is convex, which is always possible.
int SegmentRecovery::OpenWay(int from, int to, int ahead)
{
  this->Flipped.clear();
  std::vector<int> chain = { from, this->Plane.Begin(ahead) };
  while (true)
  {
    const int next = this->Plane.Apex(ahead);
    const int turn = next == to ? 0 : this->Plane.Turn(from, to, next);
    if (turn < 0)
    {
      ahead = this->Plane.Twin(PreviousHalfEdge(ahead));
      continue;
    }
    int back = PreviousHalfEdge(ahead);
    ahead = this->Plane.Twin(NextHalfEdge(ahead));
    while (chain.size() > 1 && this->Plane.Turn(chain[chain.size() - 2], chain.back(), next) < 0)
    {
      back = this->CutOff(back, chain[chain.size() - 2]);
      chain.pop_back();
    }
    if (turn == 0)
    {
      return back;
    }
    chain.push_back(next);
  }
}

/// Flips the edges of a corner that cross the line, until the corners before and after it share an
/// edge. back: the half-edge to the corner from the one after it. Returns that of the new edge.
int SegmentRecovery::CutOff(int back, int before)
{
  const int after = this->Plane.Begin(back);
  int side = NextHalfEdge(back);
  while (this->Plane.End(side) != before)
  {
    const int twin = this->Plane.Twin(side);
    const int previous = this->Plane.Apex(twin), next = this->Plane.Apex(side);
    if (this->Plane.Turn(previous, this->Plane.End(side), next) <= 0)
    {
      side = NextHalfEdge(twin);
      continue;
    }
    this->Flipped.insert(this->Flipped.end(), { side / 3, twin / 3 });
    this->Plane.Flip(side);
    if (next == after)
    {
      back = NextHalfEdge(side);
      side = PreviousHalfEdge(side);
    }
    else
    {
      side = this->Plane.Twin(NextHalfEdge(side));
    }
  }
  return this->Plane.Twin(PreviousHalfEdge(back));
}

void SegmentRecovery::AddMark(int side, const PlanarTriangles::SegmentMark& mark)
{
  PlanarTriangles::SegmentMark own = this->Plane.Mark(side);
  if (own.Group < 0)
  {
    own.Group = mark.Group;
  }
  else if (own.Group != mark.Group)
  {
    std::vector<int> both;
    std::set_union(this->Groups[own.Group].begin(), this->Groups[own.Group].end(),
      this->Groups[mark.Group].begin(), this->Groups[mark.Group].end(), std::back_inserter(both));
    if (both.size() > this->Groups[own.Group].size())
    {
      own.Group = static_cast<int>(this->Groups.size());
      this->Groups.push_back(std::move(both));
    }
  }
  own.Winding += mark.Winding;
  this->Plane.SetMark(side, own);
}

/// Adds a point where the piece crosses a segment; both must then be recovered again, through it.
void SegmentRecovery::AddCrossing(int from, const Piece& piece, int side)
{
  const PlanarTriangles::SegmentMark mark = this->Plane.Mark(side);
  const int begin = this->Plane.Begin(side), end = this->Plane.End(side);
  const Eigen::RowVector2d a = this->Plane.Position(from), b = this->Plane.Position(piece.End);
  const Eigen::RowVector2d c = this->Plane.Position(begin), d = this->Plane.Position(end);
  const Eigen::RowVector2d along = b - a, across = d - c, gap = c - a;
  const double share =
    (gap(0) * across(1) - gap(1) * across(0)) / (along(0) * across(1) - along(1) * across(0));
  const Eigen::RowVector2d position = a + std::clamp(share, 0.0, 1.0) * along;
  if (!this->AddsCrossings)
  {
    const int one = this->Groups[mark.Group].front(),
              other = this->Groups[piece.Mark.Group].front();
    std::ostringstream words;
    words << "segments " << std::min(one, other) << " and " << std::max(one, other) << " cross at ("
          << position(0) << ", " << position(1) << "); split them there";
    throw InvalidInput(words.str());
  }
  if (this->Plane.Points() > this->MaximumPointCount)
  {
    throw SolveFailure("rounding the crossings of segments causes new crossings without end; scale "
                       "the points up, or separate those that nearly coincide");
  }
  // The crossed edge is released. Its halves, and those of the piece, are recovered through the new
  // point.
  this->Plane.SetMark(side, {});
  this->Plane.MakeDelaunay({ side });
  const int added = this->Plane.AddPosition(position.allFinite() ? position : a);
  const int point = this->Plane.Insert(added);
  if (point != added)
  {
    this->Plane.RemoveLastPosition();
  }
  this->Pieces.insert(this->Pieces.end(),
    { { point, piece.End, piece.Mark }, { from, point, piece.Mark }, { begin, point, mark },
      { point, end, mark } });
}

} // namespace shape
