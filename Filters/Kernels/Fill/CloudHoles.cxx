#include "Fill/CloudHoles.h"

#include "Fill/LoopChoice.h"
#include "Geometry/TangentFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

using Edge = std::pair<int, int>; ///< directed, with its triangles to the left

/// The local triangles without the large ones at the boundary.
class PeeledTriangles
{
public:
  explicit PeeledTriangles(const SampledSurface& samples)
    : Samples(samples)
    , OnRim(samples.OnRim)
    , IsRemoved(samples.Surface.Triangles.rows(), 0)
  {
    for (int t = 0; t < static_cast<int>(this->IsRemoved.size()); ++t)
    {
      for (const Edge& edge : this->EdgesOf(t))
      {
        this->TrianglesAt[edge].push_back(t);
      }
    }
    this->Peel(ComputeSpacing(samples));
  }

  std::vector<Edge> BoundaryEdges() const
  {
    std::vector<Edge> edges;
    for (const auto& [edge, triangles] : this->TrianglesAt)
    {
      if (this->IsBoundary(edge))
      {
        edges.push_back(edge);
      }
    }
    return edges;
  }

private:
  std::array<Edge, 3> EdgesOf(int triangle) const
  {
    const Eigen::RowVector3i corners = this->Samples.Surface.Triangles.row(triangle);
    return { { { corners(0), corners(1) }, { corners(1), corners(2) },
      { corners(2), corners(0) } } };
  }

  bool HasTriangle(const Edge& edge) const
  {
    const auto there = this->TrianglesAt.find(edge);
    return there != this->TrianglesAt.end() &&
      std::any_of(there->second.begin(), there->second.end(),
        [&](int triangle) { return this->IsRemoved[triangle] == 0; });
  }

  bool IsBoundary(const Edge& edge) const
  {
    return this->OnRim[edge.first] != 0 && this->OnRim[edge.second] != 0 &&
      this->HasTriangle(edge) && !this->HasTriangle({ edge.second, edge.first });
  }

  double Circumradius(int triangle) const
  {
    const Eigen::Matrix3d corners = GetCorners(this->Samples.Surface, triangle);
    const RowVector3d a = corners.row(1) - corners.row(0), b = corners.row(2) - corners.row(0);
    return a.norm() * b.norm() * (a - b).norm() / (2.0 * a.cross(b).norm());
  }

  void Peel(double radius)
  {
    std::vector<Edge> left = this->BoundaryEdges();
    while (!left.empty())
    {
      const Edge edge = left.back();
      left.pop_back();
      if (!this->IsBoundary(edge))
      {
        continue;
      }
      for (const int triangle : this->TrianglesAt.at(edge))
      {
        if (this->IsRemoved[triangle] == 0 && this->Circumradius(triangle) > radius)
        {
          this->IsRemoved[triangle] = 1;
          for (const auto& [from, to] : this->EdgesOf(triangle))
          {
            this->OnRim[from] = 1;
            left.emplace_back(to, from);
          }
        }
      }
    }
  }

  const SampledSurface& Samples;
  std::vector<char> OnRim, IsRemoved;
  std::map<Edge, std::vector<int>> TrianglesAt;
};

/// Links boundary edges to loops.
class BoundaryWalk
{
public:
  explicit BoundaryWalk(const SampledSurface& samples)
    : Samples(samples)
  {
    const std::vector<Edge> edges = PeeledTriangles(samples).BoundaryEdges();
    this->Next.insert(edges.begin(), edges.end());
  }

  /// Returns the loops; edges that lead nowhere are left out.
  std::vector<std::vector<int>> FindLoops(const Progress& progress)
  {
    const auto count = static_cast<double>(std::max<std::size_t>(this->Next.size(), 1));
    std::vector<std::vector<int>> loops;
    while (!this->Next.empty())
    {
      this->Follow(loops);
      progress(1.0 - static_cast<double>(this->Next.size()) / count);
    }
    return loops;
  }

private:
  /// Takes edges from the first one on, and cuts off a loop wherever the walk returns to a point.
  void Follow(std::vector<std::vector<int>>& loops)
  {
    std::vector<int> walk{ this->Next.begin()->first };
    while (true)
    {
      const auto next = this->EdgeAfter(walk);
      if (next == this->Next.end())
      {
        return;
      }
      const int point = next->second;
      this->Next.erase(next);
      const auto before = std::find(walk.begin(), walk.end(), point);
      if (before != walk.end())
      {
        loops.emplace_back(before, walk.end());
        walk.erase(before, walk.end());
      }
      walk.push_back(point);
    }
  }

  /// The first edge counter-clockwise from where the walk came from: the hole lies between.
  std::multimap<int, int>::iterator EdgeAfter(const std::vector<int>& walk)
  {
    const int here = walk.back();
    const auto [begin, end] = this->Next.equal_range(here);
    if (begin == end)
    {
      return this->Next.end();
    }
    if (walk.size() < 2)
    {
      return begin;
    }
    const Eigen::MatrixXd& points = this->Samples.Surface.Points;
    const TangentFrame frame = BuildTangentFrame(points.row(here), this->Samples.Normals.row(here));
    const auto angleOf = [&](int point)
    {
      const RowVector3d away = points.row(point) - points.row(here);
      return std::atan2(away.dot(frame.YAxis), away.dot(frame.XAxis));
    };
    const double back = angleOf(walk[walk.size() - 2]);
    const auto turnTo = [&](int point)
    {
      const double turn = angleOf(point) - back;
      return turn > 0.0 ? turn : turn + 2.0 * M_PI;
    };
    return std::min_element(begin, end,
      [&](const auto& a, const auto& b) { return turnTo(a.second) < turnTo(b.second); });
  }

  const SampledSurface& Samples;
  std::multimap<int, int> Next;
};

/// Whether a loop with the surface to its left is counter-clockwise seen along its mean normal.
bool IsAroundSurface(const SampledSurface& samples, const std::vector<int>& loop)
{
  const Eigen::MatrixXd& points = samples.Surface.Points;
  const RowVector3d first = points.row(loop.front());
  RowVector3d area = RowVector3d::Zero(), normal = RowVector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const RowVector3d here = points.row(loop[i]), next = points.row(loop[(i + 1) % loop.size()]);
    area += (here - first).cross(next - first);
    normal += samples.Normals.row(loop[i]);
  }
  return area.dot(normal) > 0.0;
}

void SortByLength(const Eigen::MatrixXd& points, std::vector<std::vector<int>>& loops)
{
  std::stable_sort(loops.begin(), loops.end(),
    [&](const auto& a, const auto& b)
    { return ComputeLoopLength(points, a) > ComputeLoopLength(points, b); });
}

} // namespace

CloudBoundary FindCloudBoundary(const SampledSurface& samples, const Progress& progress)
{
  constexpr std::size_t fewest = 4; // three points and an empty circle around them are a triangle
  CloudBoundary boundary;
  for (std::vector<int>& loop : BoundaryWalk(samples).FindLoops(progress))
  {
    if (loop.size() < fewest)
    {
      continue;
    }
    if (IsAroundSurface(samples, loop))
    {
      boundary.Outer.push_back(std::move(loop));
    }
    else
    {
      std::reverse(loop.begin(), loop.end());
      boundary.Holes.push_back(std::move(loop));
    }
  }
  SortByLength(samples.Surface.Points, boundary.Holes);
  SortByLength(samples.Surface.Points, boundary.Outer);
  progress(1.0);
  return boundary;
}

} // namespace shape
