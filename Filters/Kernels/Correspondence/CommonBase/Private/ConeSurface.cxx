#include "Correspondence/CommonBase/Private/ConeSurface.h"

#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace shape
{
namespace
{

const std::array<Eigen::RowVector2d, 3> PatchCorners{ Eigen::RowVector2d(0.0, 0.0),
  Eigen::RowVector2d(1.0, 0.0), Eigen::RowVector2d(0.0, 1.0) };

/// The motion from the patch of a side, its number there `k`, to the patch of the opposite side,
/// number `l`. The side from corner k to corner k + 1 comes to that from corner l + 1 to corner l.
LatticeMotion GluingOf(int k, int l)
{
  // Side k has the direction of 120 k degrees.
  LatticeMotion motion{ (3 + 2 * (l - k) + 12) % 6, Eigen::RowVector2d::Zero() };
  motion.Shift = PatchCorners[(l + 1) % 3] - motion.Rotate(PatchCorners[k]);
  return motion;
}

} // namespace

Eigen::RowVector2d LatticeMotion::Rotate(Eigen::RowVector2d position) const
{
  for (int turn = 0; turn < this->Turns; ++turn)
  {
    position = { -position(1), position(0) + position(1) };
  }
  return position;
}

LatticeMotion LatticeMotion::Inverse() const
{
  LatticeMotion inverse{ (6 - this->Turns) % 6, Eigen::RowVector2d::Zero() };
  inverse.Shift = -inverse.Rotate(this->Shift);
  return inverse;
}

LatticeMotion Compose(const LatticeMotion& outer, const LatticeMotion& inner)
{
  return { (outer.Turns + inner.Turns) % 6, outer(inner.Shift) };
}

ConeSurface::ConeSurface(
  const BaseDomain& domain, const PatchedSurface& surface, const BaseEmbedding& embedding)
  : Twins(FindTwins(surface.Surface.Triangles, surface.Surface.Points.rows()))
  , Out(surface.Surface.Points.rows(), -1)
  , Cones(surface.Surface.Points.rows(), false)
  , Positions(surface.Surface.Points.rows(), Eigen::RowVector2d::Zero())
  , Givens(surface.GivenTriangles)
  , Barycentrics(surface.GivenBarycentrics)
{
  const auto sides = static_cast<int>(this->Twins.size());
  for (int side = 0; side < sides; ++side)
  {
    this->Corners.push_back(surface.Surface.Triangles(side / 3, side % 3));
    this->Out[this->Corners.back()] = side;
  }
  std::map<std::pair<int, int>, int> pathSides; // of the half-edge between two points
  for (std::size_t path = 0; path < surface.Paths.size(); ++path)
  {
    const std::vector<int>& points = surface.Paths[path];
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      pathSides[{ points[i - 1], points[i] }] = 2 * static_cast<int>(path);
      pathSides[{ points[i], points[i - 1] }] = 2 * static_cast<int>(path) + 1;
    }
    this->Cones[points.front()] = this->Cones[points.back()] = true;
  }
  std::vector<int> numbers(2 * surface.Paths.size()); // of each side in its patch
  for (const std::array<int, 3>& patch : domain.Patches)
  {
    for (int k = 0; k < 3; ++k)
    {
      numbers[patch[k]] = k;
    }
  }
  this->Gluings.resize(sides);
  for (int side = 0; side < sides; ++side)
  {
    const auto found = pathSides.find({ this->Corners[side], this->Corners[NextHalfEdge(side)] });
    if (found != pathSides.end())
    {
      this->Gluings[side] = GluingOf(numbers[found->second], numbers[found->second ^ 1]);
    }
  }
  const auto given = [&](int side) -> Eigen::RowVector2d
  {
    return embedding.Patches[surface.Patches(side / 3)].Points.row(embedding.RowOf(side)).head<2>();
  };
  this->Charts.resize(sides);
  for (int point = 0; point < this->PointCount(); ++point)
  {
    const std::vector<int> corners = this->CornersAt(point);
    // A point has the coordinates of the triangle of its first corner.
    this->Positions[point] = this->Cones[point] ? Eigen::RowVector2d(0.0, 0.0) : given(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (this->Cones[point])
      {
        this->Charts[corners[i]].Shift = given(corners[i]);
      }
      else if (i > 0)
      {
        this->Charts[corners[i]] =
          Compose(this->Across(PreviousHalfEdge(corners[i - 1])), this->Charts[corners[i - 1]]);
      }
    }
  }
}

std::vector<int> ConeSurface::CornersAt(int point) const
{
  std::vector<int> corners;
  int side = this->Out[point];
  do
  {
    corners.push_back(side);
    side = this->Twins[PreviousHalfEdge(side)];
  } while (side != this->Out[point]);
  return corners;
}

bool ConeSurface::IsCounterClockwise(int triangle) const
{
  return EvaluateOrientation(this->PositionAt(3 * triangle), this->PositionAt(3 * triangle + 1),
           this->PositionAt(3 * triangle + 2)) > 0;
}

Eigen::RowVector3d ConeSurface::BarycentricOf(
  int triangle, const Eigen::RowVector2d& position) const
{
  const Eigen::RowVector2d a = this->PositionAt(3 * triangle);
  const Eigen::RowVector2d b = this->PositionAt(3 * triangle + 1) - a,
                           c = this->PositionAt(3 * triangle + 2) - a, p = position - a;
  const double area = b(0) * c(1) - b(1) * c(0);
  const double v = (p(0) * c(1) - p(1) * c(0)) / area, w = (b(0) * p(1) - b(1) * p(0)) / area;
  return { 1.0 - v - w, v, w };
}

std::optional<ConePlace> ConeSurface::Walk(
  const ConePlace& place, const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) const
{
  ConePlace here = place;
  constexpr int maximum = 10000; // triangles
  int entered = -1;
  for (int step = 0; step < maximum; ++step)
  {
    const Eigen::RowVector2d p = here.Motion(from), q = here.Motion(to);
    int exit = -1;
    bool isInside = true;
    for (int side = 3 * here.Triangle; side < 3 * here.Triangle + 3; ++side)
    {
      const Eigen::RowVector2d u = this->PositionAt(side), w = this->PositionAt(NextHalfEdge(side));
      if (EvaluateOrientation(u, w, q) >= 0)
      {
        continue;
      }
      isInside = false;
      if (side != entered && EvaluateOrientation(p, q, u) <= 0 && EvaluateOrientation(p, q, w) >= 0)
      {
        exit = side;
      }
    }
    if (isInside)
    {
      return here;
    }
    if (exit < 0)
    {
      return std::nullopt;
    }
    entered = this->Twins[exit];
    here = { entered / 3, Compose(this->Across(exit), here.Motion) };
  }
  return std::nullopt;
}

std::optional<ConePlace> ConeSurface::WalkFrom(int point, const Eigen::RowVector2d& to) const
{
  for (const int side : this->CornersAt(point))
  {
    const Eigen::RowVector2d p = this->PositionAt(side), q = this->Charts[side](to);
    if (EvaluateOrientation(p, this->PositionAt(NextHalfEdge(side)), q) >= 0 &&
      EvaluateOrientation(this->PositionAt(PreviousHalfEdge(side)), p, q) >= 0)
    {
      return this->Walk({ side / 3, this->Charts[side] }, this->Positions[point], to);
    }
  }
  return std::nullopt;
}

// The triangles p m r, m q r, q m s and m p s become p q r and q p s. The former keep the numbers
// and coordinates of p m r and q m s.
bool ConeSurface::Remove(int point, const std::array<int, 2>& ends)
{
  const std::vector<int> around = this->CornersAt(point);
  const auto isTo = [&](int end)
  { return [this, end](int side) { return this->Corners[NextHalfEdge(side)] == end; }; };
  const auto toQ = std::find_if(around.begin(), around.end(), isTo(ends[1]));
  if (around.size() != 4 || toQ == around.end())
  {
    return false;
  }
  // Around m, counter-clockwise: m q, m r, m p, m s. Each begins the triangle to the next one.
  std::array<int, 4> sides;
  for (int i = 0; i < 4; ++i)
  {
    sides[i] = around[(toQ - around.begin() + i) % 4];
  }
  if (this->Corners[NextHalfEdge(sides[2])] != ends[0])
  {
    return false;
  }
  struct Merge
  {
    int Kept, Gone;       ///< the triangles, as their half-edges from m
    LatticeMotion Chart;  ///< of the moved corner
    LatticeMotion Gluing; ///< of the half-edge that moves to the kept triangle
    int Twin;
  };
  // r: kept is (m r p), gone is (m q r). s: kept is (m s q), gone is (m p s).
  std::array<Merge, 2> merges;
  for (int i = 0; i < 2; ++i)
  {
    const int gone = sides[2 * i], kept = sides[2 * i + 1];
    // From the gone triangle to the kept one, across m r or m s.
    const LatticeMotion over = this->Across(PreviousHalfEdge(gone));
    const int moved = NextHalfEdge(gone); // q r or p s
    merges[i] = { kept, gone, Compose(over, this->Charts[moved]),
      Compose(this->Across(moved), over.Inverse()), this->Twins[moved] };
    const Eigen::RowVector2d corner = merges[i].Chart(this->Positions[this->Corners[moved]]);
    if (EvaluateOrientation(corner, this->PositionAt(NextHalfEdge(kept)),
          this->PositionAt(PreviousHalfEdge(kept))) <= 0)
    {
      return false;
    }
  }
  // The edge p q: from the triangle of r to that of s, over m p.
  const LatticeMotion across = Compose(
    this->Across(PreviousHalfEdge(merges[1].Gone)), this->Across(PreviousHalfEdge(merges[0].Kept)));
  const std::array<int, 2> moved{ ends[1], ends[0] };
  for (int i = 0; i < 2; ++i)
  {
    // The corner of m becomes q in (q r p), and p in (p s q).
    const int side = merges[i].Kept;
    this->Corners[side] = moved[i];
    // The merged triangles are parts of one given triangle.
    this->Barycentrics[side / 3].row(side % 3) =
      this->Barycentrics[merges[i].Gone / 3].row(NextHalfEdge(merges[i].Gone) % 3);
    this->Charts[side] = merges[i].Chart;
    this->Gluings[side] = merges[i].Gluing;
    this->Gluings[merges[i].Twin] = merges[i].Gluing.Inverse();
    this->Twins[side] = merges[i].Twin;
    this->Twins[merges[i].Twin] = side;
  }
  const int pq = PreviousHalfEdge(merges[0].Kept), qp = PreviousHalfEdge(merges[1].Kept);
  this->Twins[pq] = qp;
  this->Twins[qp] = pq;
  this->Gluings[pq] = across;
  this->Gluings[qp] = across.Inverse();
  for (const Merge& merge : merges)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int side = merge.Kept - merge.Kept % 3 + k;
      this->Out[this->Corners[side]] = side;
      this->Corners[merge.Gone - merge.Gone % 3 + k] = -1;
    }
  }
  this->Out[point] = -1;
  return true;
}

} // namespace shape
