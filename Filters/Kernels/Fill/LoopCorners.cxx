#include "Fill/LoopCorners.h"

#include "Mesh/CoincidentPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace shape
{

LoopCorners FindLoopCorners(const std::vector<int>& loop, const Eigen::MatrixXd& points)
{
  const std::size_t count = loop.size();
  const auto isSame = [&](int a, int b) { return points.row(a) == points.row(b); };
  const auto point = [&](std::size_t i) { return loop[i % count]; };
  std::size_t first = 0;
  while (first + 1 < count && isSame(point(first), point(first + count - 1)))
  {
    ++first;
  }
  LoopCorners corners;
  std::vector<Eigen::RowVector3i> slivers;
  const bool isOnePosition =
    std::all_of(loop.begin(), loop.end(), [&](int point) { return isSame(point, loop.front()); });
  if (isOnePosition)
  {
    // A hole without extent: triangles without area close it.
    corners.Points = { loop.front() };
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
      slivers.emplace_back(point(0), point(i), point(i + 1));
    }
  }
  for (std::size_t i = first; !isOnePosition && i < first + count; ++i)
  {
    if (i == first || !isSame(point(i), point(i - 1)))
    {
      corners.Points.push_back(point(i));
      continue;
    }
    // The fill's edge to the next position begins at the first of the duplicate points.
    std::size_t next = i + 1;
    while (isSame(point(next), point(i)) && next < i + count)
    {
      ++next;
    }
    slivers.emplace_back(point(i - 1), point(i), point(next));
  }
  corners.Slivers.resize(static_cast<Eigen::Index>(slivers.size()), 3);
  for (std::size_t i = 0; i < slivers.size(); ++i)
  {
    corners.Slivers.row(static_cast<Eigen::Index>(i)) = slivers[i];
  }
  return corners;
}

UsedEdges::UsedEdges(const Surface& surface, const std::vector<std::vector<int>>& loops)
  : Position(FindCoincidentPoints(surface.Points()))
  , LoopsOf(surface.Points().rows())
  , Joined(surface.Points().rows())
{
  for (int loop = 0; loop < static_cast<int>(loops.size()); ++loop)
  {
    for (const int point : loops[loop])
    {
      std::vector<int>& there = this->LoopsOf[this->Position[point]];
      if (there.empty() || there.back() != loop)
      {
        there.push_back(loop);
      }
    }
  }
  for (const auto& triangle : surface.Triangles().rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = this->Position[triangle(k)], b = this->Position[triangle((k + 1) % 3)];
      if (!this->LoopsOf[a].empty() && !this->LoopsOf[b].empty())
      {
        this->Joined[a].push_back(b);
        this->Joined[b].push_back(a);
      }
    }
  }
  for (std::vector<int>& others : this->Joined)
  {
    std::sort(others.begin(), others.end());
  }
}

/// An edge with three triangles would make the surface non-manifold.
std::function<bool(int, int)> UsedEdges::Of(int loop, const std::vector<int>& corners) const
{
  const auto isOnBoth = [this, loop](int a, int b)
  {
    return std::any_of(this->LoopsOf[a].begin(), this->LoopsOf[a].end(),
      [&](int other)
      {
        return other != loop &&
          std::binary_search(this->LoopsOf[b].begin(), this->LoopsOf[b].end(), other);
      });
  };
  std::vector<int> positions;
  for (const int corner : corners)
  {
    positions.push_back(this->Position[corner]);
  }
  return [this, isOnBoth, positions](int i, int j)
  {
    const std::vector<int>& others = this->Joined[positions[i]];
    return std::binary_search(others.begin(), others.end(), positions[j]) ||
      isOnBoth(positions[i], positions[j]);
  };
}

std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop)
{
  return [loop](int a, int b)
  {
    constexpr int maximum = 8; // sides
    // Area over the squared chord, and the cosine between area and normal: beyond these the case is
    // certain.
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
    const Eigen::RowVector3d first = loop.Points.row(a);
    Eigen::RowVector3d area = Eigen::RowVector3d::Zero(), normal = loop.Normals.row(a);
    for (int step = 1; step <= between; ++step)
    {
      const int here = (a + step - 1) % corners, next = (a + step) % corners;
      const Eigen::RowVector3d from = loop.Points.row(here) - first,
                               to = loop.Points.row(next) - first;
      area += 0.5 * from.cross(to);
      normal += loop.Normals.row(next);
    }
    return area.norm() < flat * (loop.Points.row(b) - first).squaredNorm() ||
      area.dot(normal.stableNormalized()) < opposite * area.norm();
  };
}

} // namespace shape
