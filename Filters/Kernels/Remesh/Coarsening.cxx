#include "Remesh/Coarsening.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

constexpr double MinimumTurnCosine = 0.5; // of what a triangle may turn by
constexpr double Slim = 0.02;             // twice a triangle's area over its longest side's square
constexpr std::size_t MaximumAround = 64; // triangles at a point that is merged, or merged into
constexpr double Steepness = 30.0;        // what being off the planes around costs against length

/// A surface that loses points.
class Shrinking
{
public:
  Shrinking(const Mesh& mesh, const std::vector<int>& kept)
    : Points(mesh.Points.transpose())
    , Triangles(mesh.Triangles.rows())
    , Around(mesh.Points.rows())
    , IsKept(mesh.Points.rows(), 0)
    , OnBoundary(mesh.Points.rows(), 0)
    , Tried(mesh.Points.rows(), 0)
    , Carried(mesh.Triangles.rows())
    , Positions{ Eigen::VectorXi::Constant(mesh.Points.rows(), -1),
      Eigen::MatrixXd::Zero(mesh.Points.rows(), 3) }
    , Left(static_cast<int>(mesh.Points.rows()))
  {
    for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Triangles[t][k] = mesh.Triangles(t, k);
        this->Around[mesh.Triangles(t, k)].push_back(t);
      }
    }
    for (const int point : kept)
    {
      this->IsKept[point] = 1;
    }
    for (int i = 0; i < this->Left; ++i)
    {
      this->FindNeighbours(i, this->Ring);
      this->OnBoundary[i] = this->Ring.size() > this->Around[i].size() ? 1 : 0;
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
    Mesh mesh;
    CoarseSurface coarse{ {}, {}, std::move(this->Positions) };
    std::vector<int> number(this->Around.size(), -1), row(this->Triangles.size(), -1);
    for (int i = 0; i < static_cast<int>(this->Around.size()); ++i)
    {
      if (!this->Around[i].empty())
      {
        number[i] = static_cast<int>(coarse.Points.size());
        coarse.Points.push_back(i);
      }
    }
    mesh.Points = this->Points(Eigen::all, coarse.Points).transpose();
    mesh.Triangles.resize(static_cast<Eigen::Index>(this->Triangles.size()), 3);
    int count = 0;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      const Triangle& corners = this->Triangles[t];
      if (corners[0] >= 0)
      {
        row[t] = count;
        mesh.Triangles.row(count++) << number[corners[0]], number[corners[1]], number[corners[2]];
      }
    }
    mesh.Triangles.conservativeResize(count, 3);
    coarse.Surface = std::move(mesh);
    for (int i = 0; i < static_cast<int>(this->Around.size()); ++i)
    {
      if (this->Around[i].empty())
      {
        coarse.Positions.Triangles(i) = row[coarse.Positions.Triangles(i)];
        continue;
      }
      const int t = this->Around[i].front();
      coarse.Positions.Triangles(i) = row[t];
      coarse.Positions.Barycentrics.row(i).setZero();
      coarse.Positions.Barycentrics(i, CornerOf(this->Triangles[t], i)) = 1.0;
    }
    return coarse;
  }

private:
  using Triangle = std::array<int, 3>; ///< the first corner is -1 where it is gone

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

  static bool Has(const Triangle& corners, int point)
  {
    return corners[0] == point || corners[1] == point || corners[2] == point;
  }

  static int CornerOf(const Triangle& corners, int point)
  {
    return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
  }

  /// The neighbours of a point, ascending; on a border they are one more than its triangles.
  void FindNeighbours(int point, std::vector<int>& found) const
  {
    found.clear();
    for (const int t : this->Around[point])
    {
      for (const int other : this->Triangles[t])
      {
        if (other != point)
        {
          found.push_back(other);
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  Eigen::Vector3d AreaVector(const Triangle& corners) const
  {
    const Eigen::Vector3d p = this->Points.col(corners[0]);
    return (this->Points.col(corners[1]) - p).cross(this->Points.col(corners[2]) - p);
  }

  double SquaredLength(int a, int b) const
  {
    return (this->Points.col(a) - this->Points.col(b)).squaredNorm();
  }

  bool ShareATriangle(int point, int second, int third) const
  {
    const std::vector<int>& around = this->Around[point];
    return std::any_of(around.begin(), around.end(),
      [&](int t) { return Has(this->Triangles[t], second) && Has(this->Triangles[t], third); });
  }

  /// The mean square of how far a point's neighbour is off the planes of the triangles around it,
  /// as their areas weigh (Garland and Heckbert's quadric): tips and ridges stay longer.
  double Steep(int point, int neighbour) const
  {
    const Eigen::Vector3d way = this->Points.col(neighbour) - this->Points.col(point);
    double sum = 0.0, areas = 0.0;
    for (const int t : this->Around[point])
    {
      const Eigen::Vector3d normal = this->AreaVector(this->Triangles[t]);
      const double area = normal.norm(), off = normal.dot(way);
      if (area > 0.0)
      {
        sum += off * off / area;
        areas += area;
      }
    }
    return areas > 0.0 ? sum / areas : 0.0;
  }

  /// Finds what a point is to be merged into, if anything, and puts that into the queue.
  void Queue(int point)
  {
    ++this->Tried[point];
    // The middle of a large fan waits until its rim has fewer points.
    if (this->IsKept[point] != 0 || this->Around[point].size() > MaximumAround)
    {
      return;
    }
    std::vector<int>& ring = this->Ring;
    this->FindNeighbours(point, ring);
    std::vector<std::pair<double, int>> choices;
    for (const int into : ring)
    {
      if (this->Around[into].size() > MaximumAround)
      {
        continue;
      }
      double longest = 0.0;
      for (const int other : ring)
      {
        if (!this->ShareATriangle(point, into, other))
        {
          longest = std::max(longest, this->SquaredLength(into, other));
        }
      }
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
    for (const int t : this->Around[point])
    {
      const Triangle& corners = this->Triangles[t];
      if (!Has(corners, into))
      {
        continue;
      }
      ++shared;
      const int opposite = corners[0] + corners[1] + corners[2] - point - into;
      if (this->Around[opposite].size() <= (this->OnBoundary[opposite] != 0 ? 1U : 3U))
      {
        return false;
      }
    }
    this->FindNeighbours(into, this->Others);
    // The link condition: no neighbours in common but those of the edge's triangles.
    const auto common = std::count_if(ring.begin(), ring.end(),
      [&](int i) { return std::binary_search(this->Others.begin(), this->Others.end(), i); });
    if (common != shared || (this->OnBoundary[point] != 0 && shared == 2) ||
      this->Around[point].size() == static_cast<std::size_t>(shared))
    {
      return false;
    }
    return std::none_of(this->Around[point].begin(), this->Around[point].end(),
      [&](int t) { return this->Spoils(this->Triangles[t], point, into); });
  }

  /// Whether a triangle turns too far or becomes slim with one corner elsewhere.
  bool Spoils(const Triangle& corners, int point, int into) const
  {
    if (Has(corners, into))
    {
      return false;
    }
    Triangle moved = corners;
    moved[CornerOf(corners, point)] = into;
    const Eigen::Vector3d before = this->AreaVector(corners), after = this->AreaVector(moved);
    const auto longest = [&](const Triangle& t)
    {
      return std::max({ this->SquaredLength(t[0], t[1]), this->SquaredLength(t[1], t[2]),
        this->SquaredLength(t[2], t[0]) });
    };
    const double sizeBefore = longest(corners), sizeAfter = longest(moved);
    // The side that a slim triangle faces says nothing.
    const bool turns = before.norm() > Slim * sizeBefore &&
      before.dot(after) < MinimumTurnCosine * before.norm() * after.norm();
    return turns ||
      (after.norm() < Slim * sizeAfter && after.norm() * sizeBefore < before.norm() * sizeAfter);
  }

  void Apply(int point, int into)
  {
    std::vector<int> moved{ point };
    std::vector<int> left;
    for (const int t : this->Around[point])
    {
      moved.insert(moved.end(), this->Carried[t].begin(), this->Carried[t].end());
      this->Carried[t].clear();
      Triangle& corners = this->Triangles[t];
      if (Has(corners, into))
      {
        for (const int corner : corners)
        {
          if (corner != point)
          {
            std::vector<int>& around = this->Around[corner];
            around.erase(std::find(around.begin(), around.end(), t));
          }
        }
        corners[0] = -1;
        continue;
      }
      corners[CornerOf(corners, point)] = into;
      left.push_back(t);
    }
    this->Around[into].insert(this->Around[into].end(), left.begin(), left.end());
    this->Around[point].clear();
    ++this->Tried[point];
    --this->Left;
    for (const int i : moved)
    {
      this->Carry(i, left);
    }
    std::vector<int> changed;
    this->FindNeighbours(into, changed);
    changed.push_back(into);
    for (const int i : changed)
    {
      this->Queue(i);
    }
  }

  /// Puts a point on the closest of a few triangles.
  void Carry(int point, const std::vector<int>& triangles)
  {
    double minimum = std::numeric_limits<double>::infinity();
    int best = -1;
    const Eigen::RowVector3d position = this->Points.col(point).transpose();
    for (const int t : triangles)
    {
      const Triangle& t3 = this->Triangles[t];
      Eigen::Matrix3d corners;
      corners << this->Points.col(t3[0]).transpose(), this->Points.col(t3[1]).transpose(),
        this->Points.col(t3[2]).transpose();
      const Eigen::RowVector3d place = FindClosestPointInTriangle(corners, position);
      const double squared = (place * corners - position).squaredNorm();
      if (squared < minimum)
      {
        minimum = squared;
        best = t;
        this->Positions.Barycentrics.row(point) = place;
      }
    }
    this->Positions.Triangles(point) = best;
    this->Carried[best].push_back(point);
  }

  const Eigen::Matrix3Xd Points;
  std::vector<Triangle> Triangles;
  std::vector<std::vector<int>> Around; ///< the triangles of each point; none: merged
  std::vector<char> IsKept, OnBoundary;
  std::vector<int> Tried; ///< how often a point was queued: an older entry is void
  std::priority_queue<Merge, std::vector<Merge>, std::greater<>> Waiting;
  std::vector<std::vector<int>> Carried; ///< merged points on each triangle
  SurfacePoints Positions;
  int Left;
  std::vector<int> Ring, Others; ///< kept to spare allocations
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
