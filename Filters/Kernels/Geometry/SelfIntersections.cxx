#include "Geometry/SelfIntersections.h"

#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Search/TriangleBoxes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// A triangle by its corners.
using Triangle = std::array<RowVector3d, 3>;

Triangle TriangleOf(const Mesh& mesh, int number)
{
  const Eigen::Matrix3d corners = GetCorners(mesh, number);
  return { corners.row(0), corners.row(1), corners.row(2) };
}

/// A point without its coordinate `axis`.
RowVector2d Without(int axis, const RowVector3d& p)
{
  return { p((axis + 1) % 3), p((axis + 2) % 3) };
}

/// An axis along which the triangle can be projected without becoming flat, or -1.
int ProjectionAxis(const Triangle& t)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (EvaluateOrientation(Without(axis, t[0]), Without(axis, t[1]), Without(axis, t[2])) != 0)
    {
      return axis;
    }
  }
  return -1;
}

/// Whether a point of the triangle's plane, projected like it, lies in it or on its border.
bool Contains(const std::array<RowVector2d, 3>& t, const RowVector2d& p)
{
  // The three edges have p on the same side, or on their lines.
  int signs[3];
  for (int k = 0; k < 3; ++k)
  {
    signs[k] = EvaluateOrientation(t[k], t[(k + 1) % 3], p);
  }
  const auto [low, high] = std::minmax({ signs[0], signs[1], signs[2] });
  return low >= 0 || high <= 0;
}

/// Whether the segment p q crosses the line a b between a and b. If p q meets a triangle and both
/// ends are outside, it crosses at least one of the triangle's edges in this way.
bool Cross(const RowVector2d& p, const RowVector2d& q, const RowVector2d& a, const RowVector2d& b)
{
  return EvaluateOrientation(p, q, a) * EvaluateOrientation(p, q, b) <= 0 &&
    EvaluateOrientation(a, b, p) * EvaluateOrientation(a, b, q) < 0;
}

/// Whether a segment meets a triangle in whose plane it lies.
bool MeetInPlane(const RowVector3d& p, const RowVector3d& q, const Triangle& t)
{
  const int axis = ProjectionAxis(t);
  const std::array<RowVector2d, 3> corners = { Without(axis, t[0]), Without(axis, t[1]),
    Without(axis, t[2]) };
  const RowVector2d from = Without(axis, p), to = Without(axis, q);
  if (Contains(corners, from) || Contains(corners, to))
  {
    return true;
  }
  // Both ends lie outside: the segment meets the triangle only where it passes through a side.
  for (int k = 0; k < 3; ++k)
  {
    if (Cross(from, to, corners[k], corners[(k + 1) % 3]))
    {
      return true;
    }
  }
  return false;
}

/// Whether a segment meets a triangle, ends and border included.
bool Meet(const RowVector3d& p, const RowVector3d& q, const Triangle& t)
{
  const int sideP = EvaluateOrientation(t[0], t[1], t[2], p);
  const int sideQ = EvaluateOrientation(t[0], t[1], t[2], q);
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return MeetInPlane(p, q, t);
  }
  // The signed volumes of the segment and the three edges: the line passes through the triangle if
  // none has another sign.
  int signs[3];
  for (int k = 0; k < 3; ++k)
  {
    signs[k] = EvaluateOrientation(p, q, t[k], t[(k + 1) % 3]);
  }
  const auto [low, high] = std::minmax({ signs[0], signs[1], signs[2] });
  return low >= 0 || high <= 0;
}

/// Whether all corners of u lie strictly on one side of the plane of t.
bool Apart(const Triangle& t, const Triangle& u)
{
  const int side = EvaluateOrientation(t[0], t[1], t[2], u[0]);
  return side != 0 && EvaluateOrientation(t[0], t[1], t[2], u[1]) == side &&
    EvaluateOrientation(t[0], t[1], t[2], u[2]) == side;
}

Eigen::AlignedBox3d BoxOf(const Mesh& mesh, int triangle)
{
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k)
  {
    box.extend(mesh.Points.row(mesh.Triangles(triangle, k)).transpose());
  }
  return box;
}

/// What Eigen's search calls for each box and triangle: collects the crossings of one triangle with
/// later ones, and with those before `From`.
struct Search
{
  const Mesh& Surface;
  const std::vector<Eigen::AlignedBox3d>& Boxes;
  int Number, From;
  std::vector<Crossing>& Found;

  // Eigen calls these two by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Eigen::AlignedBox3d& box) const
  {
    return box.intersects(this->Boxes[this->Number]);
  }
  bool intersectObject(int other) const
  {
    const Eigen::AlignedBox3d &mine = this->Boxes[this->Number], &its = this->Boxes[other];
    if ((other > this->Number || other < this->From) && mine.intersects(its) &&
      DoTrianglesIntersect(this->Surface, this->Number, other))
    {
      this->Found.push_back({ std::min(this->Number, other), std::max(this->Number, other),
        mine.intersection(its).center().transpose() });
    }
    return false; // continue the search
  }
  // NOLINTEND(readability-identifier-naming)
};

} // namespace

bool DoTrianglesIntersect(const Mesh& mesh, int first, int second)
{
  const Triangle t = TriangleOf(mesh, first), u = TriangleOf(mesh, second);
  int shared = 0, ownOfT = -1, ownOfU = -1, sharedOfT = -1, sharedOfU = -1;
  for (int i = 0; i < 3; ++i)
  {
    bool inU = false, inT = false;
    for (int j = 0; j < 3; ++j)
    {
      inU = inU || mesh.Triangles(first, i) == mesh.Triangles(second, j);
      inT = inT || mesh.Triangles(second, i) == mesh.Triangles(first, j);
    }
    shared += inU;
    (inU ? sharedOfT : ownOfT) = i;
    (inT ? sharedOfU : ownOfU) = i;
  }
  // The triangles coincide.
  if (shared == 3)
  {
    return true;
  }
  if (shared == 2)
  {
    // They overlap where they lie in one plane on the same side of the common edge.
    const RowVector3d &own = t[ownOfT], &other = u[ownOfU];
    const RowVector3d &a = t[(ownOfT + 1) % 3], &b = t[(ownOfT + 2) % 3];
    if (EvaluateOrientation(a, b, own, other) != 0)
    {
      return false;
    }
    const int axis = ProjectionAxis(t);
    return EvaluateOrientation(Without(axis, a), Without(axis, b), Without(axis, own)) ==
      EvaluateOrientation(Without(axis, a), Without(axis, b), Without(axis, other));
  }
  if (shared == 1)
  {
    // From the common corner, what they share reaches the opposite side of one of them.
    return Meet(t[(sharedOfT + 1) % 3], t[(sharedOfT + 2) % 3], u) ||
      Meet(u[(sharedOfU + 1) % 3], u[(sharedOfU + 2) % 3], t);
  }
  // Most candidates are rejected by the planes alone.
  if (Apart(t, u) || Apart(u, t))
  {
    return false;
  }
  // Two triangles that share no corner intersect if and only if an edge of one meets the other.
  const bool flatT = ProjectionAxis(t) == -1, flatU = ProjectionAxis(u) == -1;
  for (int k = 0; k < 3; ++k)
  {
    if ((!flatU && Meet(t[k], t[(k + 1) % 3], u)) || (!flatT && Meet(u[k], u[(k + 1) % 3], t)))
    {
      return true;
    }
  }
  return false;
}

std::vector<int> FindDegenerateTriangles(const Mesh& mesh)
{
  std::vector<int> flat;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (ProjectionAxis(TriangleOf(mesh, t)) == -1)
    {
      flat.push_back(t);
    }
  }
  return flat;
}

std::vector<Crossing> FindSelfIntersections(const Surface& surface, const Progress& progress)
{
  return FindSelfIntersectionsFrom(surface, 0, std::numeric_limits<int>::max(), progress);
}

std::vector<Crossing> FindSelfIntersectionsFrom(
  const Surface& surface, int first, int maximum, const Progress& progress)
{
  const Mesh& mesh = surface;
  const int count = static_cast<int>(mesh.Triangles.rows());
  if (first >= count)
  {
    return {};
  }
  std::vector<Eigen::AlignedBox3d> boxes(count);
  for (int t = 0; t < count; ++t)
  {
    boxes[t] = BoxOf(mesh, t);
  }
  const std::shared_ptr<const BoxTree> tree = GetTriangleBoxes(surface);

  // In batches, so that the search ends soon after the maximum is reached.
  constexpr int grain = 256, batch = 64 * grain;
  std::vector<Crossing> crossings;
  for (int from = first; from < count && static_cast<int>(crossings.size()) < maximum;
       from += batch)
  {
    const int size = std::min(batch, count - from);
    std::vector<std::vector<Crossing>> found((size + grain - 1) / grain);
    ParallelFor(
      size, grain,
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          Search search{ mesh, boxes, from + t, first, found[begin / grain] };
          Eigen::BVIntersect(*tree, search);
        }
      },
      progress.Part(static_cast<double>(from - first) / (count - first),
        static_cast<double>(from - first + size) / (count - first)));
    for (const std::vector<Crossing>& some : found)
    {
      crossings.insert(crossings.end(), some.begin(), some.end());
    }
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const Crossing& a, const Crossing& b)
    { return a.First != b.First ? a.First < b.First : a.Second < b.Second; });
  return crossings;
}

} // namespace shape
