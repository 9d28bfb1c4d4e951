#include "Remesh/Coarsening.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Remesh/EditableSurface.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr double MinimumTurnCosine = 0.5; // cosine of the largest rotation of a triangle
constexpr double Slim = 0.02;             // twice a triangle's area over its longest edge squared
constexpr std::size_t MaximumAround = 64; // triangles at a point that is merged, or merged into
constexpr double Steepness = 30.0;        // cost of distance from the planes, relative to length

using Triangle = EditableSurface::Triangle;

/// Merges points by priority: construct, ShrinkTo, then take the Result.
class Shrinking
{
public:
  Shrinking(const Mesh& mesh, const std::vector<int>& kept)
    : Surface(mesh)
    , IsKept(mesh.Points.rows(), 0)
    , OnBoundary(mesh.Points.rows(), 0)
    , Tried(mesh.Points.rows(), 0)
    , Carried(mesh.Triangles.rows())
    , Positions{ Eigen::VectorXi::Constant(mesh.Points.rows(), -1),
      Eigen::MatrixXd::Zero(mesh.Points.rows(), 3) }
    , Left(static_cast<int>(mesh.Points.rows()))
  {
    for (const int point : kept)
    {
      this->IsKept[point] = 1;
    }
    for (int i = 0; i < this->Left; ++i)
    {
      this->Surface.FindNeighbours(i, this->Ring);
      this->OnBoundary[i] = this->Ring.size() > this->Surface.Around(i).size() ? 1 : 0;
    }
  }

  void ShrinkTo(int points, const Progress& progress)
  {
    constexpr int often = 1024;
    const Progress fill = progress.Part(0.0, 0.3), merge = progress.Part(0.3, 1.0);
    const int all = this->Left;
    for (int i = 0; i < all; ++i)
    {
      this->Queue(i);
      if (i % often == 0)
      {
        fill(static_cast<double>(i) / all);
      }
    }
    while (this->Left > points && !this->Waiting.empty())
    {
      // Entries of points that were queued again since are void: they are skipped, not removed.
      const Merge next = this->Waiting.top();
      this->Waiting.pop();
      if (next.Try != this->Tried[next.Point])
      {
        continue;
      }
      this->Apply(next.Point, next.Into);
      if (this->Left % often == 0)
      {
        merge(static_cast<double>(all - this->Left) / (all - points));
      }
    }
  }

  CoarseSurface Result()
  {
    EditableSurface::Compacted left = this->Surface.Compact();
    CoarseSurface coarse{ std::move(left.Surface), std::move(left.Points),
      std::move(this->Positions) };
    for (int i = 0; i < this->Surface.PointCount(); ++i)
    {
      if (!this->Surface.Contains(i))
      {
        coarse.Positions.Triangles(i) = left.Rows[coarse.Positions.Triangles(i)];
        continue;
      }
      const int t = this->Surface.Around(i).front();
      coarse.Positions.Triangles(i) = left.Rows[t];
      coarse.Positions.Barycentrics.row(i).setZero();
      coarse.Positions.Barycentrics(i, EditableSurface::CornerOf(this->Surface.Corners(t), i)) =
        1.0;
    }
    return coarse;
  }

private:
  /// Point is to be merged into its neighbour Into.
  struct Merge
  {
    double Cost;
    int Point, Into, Try;
    bool operator>(const Merge& other) const
    {
      return std::pair(this->Cost, this->Point) > std::pair(other.Cost, other.Point);
    }
  };

  bool ShareATriangle(int point, int second, int third) const
  {
    const std::vector<int>& around = this->Surface.Around(point);
    return std::any_of(around.begin(), around.end(),
      [&](int t)
      {
        const Triangle& corners = this->Surface.Corners(t);
        return EditableSurface::Has(corners, second) && EditableSurface::Has(corners, third);
      });
  }

  /// Finds the area vectors of the triangles around a point, and their areas.
  void FindPlanes(int point)
  {
    this->Planes.clear();
    for (const int t : this->Surface.Around(point))
    {
      const Eigen::Vector3d normal = this->Surface.AreaVector(this->Surface.Corners(t));
      this->Planes.emplace_back(normal, normal.norm());
    }
  }

  /// The mean squared distance of a point's neighbour from the Planes of the triangles around the
  /// point, weighted by their areas (Garland and Heckbert's quadric): tips and ridges stay longer.
  double Steep(int point, int neighbour) const
  {
    const Eigen::Vector3d way = this->Surface.Position(neighbour) - this->Surface.Position(point);
    double sum = 0.0, areas = 0.0;
    for (const auto& [normal, area] : this->Planes)
    {
      const double off = normal.dot(way);
      if (area > 0.0)
      {
        sum += off * off / area;
        areas += area;
      }
    }
    return areas > 0.0 ? sum / areas : 0.0;
  }

  /// Finds the neighbour that a point is merged into, if any, and queues the merge.
  void Queue(int point)
  {
    ++this->Tried[point];
    // The centre of a large fan waits until its ring has fewer points.
    if (this->IsKept[point] != 0 || this->Surface.Around(point).size() > MaximumAround)
    {
      return;
    }
    std::vector<int>& ring = this->Ring;
    this->Surface.FindNeighbours(point, ring);
    this->FindPlanes(point);
    std::vector<std::pair<double, int>> choices;
    for (const int into : ring)
    {
      if (this->Surface.Around(into).size() > MaximumAround)
      {
        continue;
      }
      double longest = 0.0;
      for (const int other : ring)
      {
        const double squared = this->Surface.SquaredLength(into, other);
        if (squared > longest && !this->ShareATriangle(point, into, other))
        {
          longest = squared;
        }
      }
      // The longest edge that the merge would create, and the distance from the planes.
      choices.emplace_back(longest + Steepness * this->Steep(point, into), into);
    }
    std::sort(choices.begin(), choices.end());
    for (const auto& [cost, into] : choices)
    {
      if (this->MayMerge(point, into, ring))
      {
        this->Waiting.push({ cost, point, into, this->Tried[point] });
        return;
      }
    }
  }

  bool MayMerge(int point, int into, const std::vector<int>& ring)
  {
    int shared = 0;
    const std::vector<int>& around = this->Surface.Around(point);
    for (const int t : around)
    {
      if (!EditableSurface::Has(this->Surface.Corners(t), into))
      {
        continue;
      }
      ++shared;
      const int opposite = this->Surface.Opposite(t, point, into);
      // The third corner loses a triangle: it must keep a fan of at least three, or one at a
      // boundary.
      if (this->Surface.Around(opposite).size() <= (this->OnBoundary[opposite] != 0 ? 1U : 3U))
      {
        return false;
      }
    }
    this->Surface.FindNeighbours(into, this->Others);
    // The link condition: no common neighbours except those of the edge's triangles.
    const auto common = std::count_if(ring.begin(), ring.end(),
      [&](int i) { return std::binary_search(this->Others.begin(), this->Others.end(), i); });
    // A boundary point only moves along the boundary, and at least one triangle must remain.
    if (common != shared || (this->OnBoundary[point] != 0 && shared == 2) ||
      around.size() == static_cast<std::size_t>(shared))
    {
      return false;
    }
    return std::none_of(around.begin(), around.end(),
      [&](int t) { return this->Spoils(this->Surface.Corners(t), point, into); });
  }

  /// Whether moving one corner rotates a triangle too far or makes it a sliver.
  bool Spoils(const Triangle& corners, int point, int into) const
  {
    if (EditableSurface::Has(corners, into))
    {
      return false;
    }
    Triangle moved = corners;
    moved[EditableSurface::CornerOf(corners, point)] = into;
    const Eigen::Vector3d before = this->Surface.AreaVector(corners),
                          after = this->Surface.AreaVector(moved);
    const auto longest = [&](const Triangle& t)
    {
      return std::max({ this->Surface.SquaredLength(t[0], t[1]),
        this->Surface.SquaredLength(t[1], t[2]), this->Surface.SquaredLength(t[2], t[0]) });
    };
    const double sizeBefore = longest(corners), sizeAfter = longest(moved);
    // The normal of a sliver is meaningless.
    const bool turns = before.norm() > Slim * sizeBefore &&
      before.dot(after) < MinimumTurnCosine * before.norm() * after.norm();
    return turns ||
      (after.norm() < Slim * sizeAfter && after.norm() * sizeBefore < before.norm() * sizeAfter);
  }

  void Apply(int point, int into)
  {
    // The points on the triangles around the removed one are located again, as in MAPS (Lee et al.
    // 1998).
    std::vector<int> moved{ point };
    for (const int t : this->Surface.Around(point))
    {
      moved.insert(moved.end(), this->Carried[t].begin(), this->Carried[t].end());
      this->Carried[t].clear();
    }
    const std::vector<int> left = this->Surface.Collapse(point, into);
    ++this->Tried[point];
    --this->Left;
    for (const int i : moved)
    {
      this->Carry(i, left);
    }
    // The costs of the neighbours depend on the triangles that changed.
    std::vector<int> changed;
    this->Surface.FindNeighbours(into, changed);
    changed.push_back(into);
    for (const int i : changed)
    {
      this->Queue(i);
    }
  }

  /// Locates a point on the closest of a few triangles.
  void Carry(int point, const std::vector<int>& triangles)
  {
    double minimum = std::numeric_limits<double>::infinity();
    int best = -1;
    const Eigen::RowVector3d position = this->Surface.Position(point).transpose();
    for (const int t : triangles)
    {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k)
      {
        corners.row(k) = this->Surface.Position(this->Surface.Corners(t)[k]).transpose();
      }
      const Eigen::RowVector3d closest = FindClosestPointInTriangle(corners, position);
      const double squared = (closest * corners - position).squaredNorm();
      if (squared < minimum)
      {
        minimum = squared;
        best = t;
        this->Positions.Barycentrics.row(point) = closest;
      }
    }
    this->Positions.Triangles(point) = best;
    this->Carried[best].push_back(point);
  }

  EditableSurface Surface;
  std::vector<char> IsKept, OnBoundary;
  std::vector<int> Tried; ///< how often a point was queued: an older entry is void
  std::priority_queue<Merge, std::vector<Merge>, std::greater<>> Waiting;
  std::vector<std::vector<int>> Carried; ///< merged points on each triangle
  SurfacePoints Positions;
  int Left;
  ///@{
  /// Buffers, kept to avoid allocations.
  std::vector<int> Ring, Others;
  std::vector<std::pair<Eigen::Vector3d, double>> Planes;
  ///@}
};

} // namespace

CoarseSurface CoarsenSurface(
  const Surface& surface, int points, const std::vector<int>& kept, const Progress& progress)
{
  RequireOption(points >= 4, "the number of points", points, "at least 4");
  const Topology topology = RequireManifold(surface, "the surface");
  const auto loose = (topology.ComponentId.array() < 0).count();
  if (loose > 0)
  {
    throw InvalidInput("the surface has " + std::to_string(loose) +
      " points that no triangle uses; remove them first");
  }
  for (const int point : kept)
  {
    RequireOption(point >= 0 && point < surface.Points().rows(), "a point to keep", point,
      "one of the surface's points");
  }
  Shrinking shrinking(surface, kept);
  shrinking.ShrinkTo(points, progress);
  progress(1.0);
  return shrinking.Result();
}

SurfacePoints LocateOnFinerSurface(const CoarseSurface& coarse, const Mesh& finer,
  const SurfacePoints& positions, const Progress& progress)
{
  const Eigen::MatrixXi& triangles = coarse.Surface.Triangles();
  std::vector<std::vector<int>> near(triangles.rows());
  for (int i = 0; i < static_cast<int>(coarse.Positions.Triangles.size()); ++i)
  {
    near[coarse.Positions.Triangles(i)].push_back(i);
  }
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      near[t].push_back(coarse.Points[triangles(t, k)]);
    }
  }
  const Eigen::MatrixXd towards = PullBack(positions, triangles, coarse.Surface.Points());
  // The start of each walk: the nearest of the finer points that lie on the same coarse triangle.
  const auto nearest = [&](int i)
  {
    const auto distance = [&](int point)
    { return (finer.Points.row(point) - towards.row(i)).squaredNorm(); };
    const std::vector<int>& choices = near[positions.Triangles(i)];
    return *std::min_element(choices.begin(), choices.end(),
      [&](int one, int other) { return distance(one) < distance(other); });
  };
  return WalkToPositions(towards, finer.Triangles, finer.Points,
    TriangleFans(finer.Triangles, finer.Points.rows()), nearest, progress);
}

} // namespace shape
