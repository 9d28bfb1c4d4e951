#include "Fill/Private/OuterChords.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

bool IsCounterClockwise(const RowVector2d& a, const RowVector2d& b, const RowVector2d& c)
{
  return (b - a).x() * (c - a).y() > (b - a).y() * (c - a).x();
}

/// Triangles by their edges between two corners of the outline, as they run.
std::map<std::array<int, 2>, int> TrianglesAtChords(const FlatDisk& disk, int corners)
{
  std::map<std::array<int, 2>, int> triangles;
  for (int t = 0; t < static_cast<int>(disk.Triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = disk.Triangles(t, k), b = disk.Triangles(t, (k + 1) % 3);
      if (a < corners && b < corners)
      {
        triangles[{ a, b }] = t;
      }
    }
  }
  return triangles;
}

} // namespace

std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop)
{
  return [loop](int a, int b)
  {
    constexpr int maximum = 8; // sides
    constexpr double flat = 0.01, opposite = -0.3;
    const auto corners = static_cast<int>(loop.Points.rows());
    const int sides = (b - a + corners) % corners;
    if (sides > corners - sides)
    {
      std::swap(a, b);
    }
    const int between = std::min(sides, corners - sides);
    if (between < 2 || between > maximum)
    {
      return false;
    }
    const RowVector3d first = loop.Points.row(a);
    RowVector3d area = RowVector3d::Zero(), normal = loop.Normals.row(a);
    for (int step = 1; step <= between; ++step)
    {
      const int here = (a + step - 1) % corners, next = (a + step) % corners;
      const RowVector3d from = loop.Points.row(here) - first, to = loop.Points.row(next) - first;
      area += 0.5 * from.cross(to);
      normal += loop.Normals.row(next);
    }
    return area.norm() < flat * (loop.Points.row(b) - first).squaredNorm() ||
      area.dot(normal.stableNormalized()) < opposite * area.norm();
  };
}

void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken)
{
  const std::map<std::array<int, 2>, int> triangles = TrianglesAtChords(disk, corners);
  std::vector<bool> isChanged(disk.Triangles.rows(), false);
  for (int tip = 0; tip < corners; ++tip)
  {
    const int last = (tip + corners - 1) % corners, next = (tip + 1) % corners;
    const auto inner = triangles.find({ next, last }), outer = triangles.find({ last, next });
    if (inner == triangles.end() || outer == triangles.end() || isChanged[inner->second] ||
      isChanged[outer->second] || !isOutside(last, next))
    {
      continue;
    }
    const int far = disk.Triangles.row(outer->second).sum() - last - next;
    const RowVector2d from = disk.Points.row(tip), to = disk.Points.row(far);
    if ((far < corners && isTaken && isTaken(tip, far)) ||
      !IsCounterClockwise(from, to, disk.Points.row(last)) ||
      !IsCounterClockwise(to, from, disk.Points.row(next)))
    {
      continue;
    }
    disk.Triangles.row(inner->second) << last, tip, far;
    disk.Triangles.row(outer->second) << tip, next, far;
    isChanged[inner->second] = isChanged[outer->second] = true;
  }
}

} // namespace shape
