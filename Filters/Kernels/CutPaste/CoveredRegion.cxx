#include "CutPaste/CoveredRegion.h"

#include "Geometry/Orientation.h"
#include "Planar/PlanarOutline.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

using Triangle2 = Eigen::Matrix<double, 3, 2>;

Triangle2 ImageOf(const ExponentialPatch& patch, int triangle)
{
  Triangle2 image;
  for (int k = 0; k < 3; ++k)
  {
    image.row(k) = patch.Positions.row(patch.Corners(triangle, k));
  }
  return image;
}

/// Returns the loop with its points moved to nearby points of the patch, no two to the same one.
/// Points of the loop next to a point of the patch would make thin triangles in the band. Closest
/// pairs come first; index order makes ties unique.
Eigen::MatrixXd Snapped(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, double snap)
{
  struct Pull
  {
    double Distance;
    int Corner;
    int Point;
    bool operator<(const Pull& other) const
    {
      return std::tie(this->Distance, this->Corner, this->Point) <
        std::tie(other.Distance, other.Corner, other.Point);
    }
  };
  const PlanarOutline outline(loop);
  std::set<Pull> pulls;
  for (int point = 0; point < static_cast<int>(patch.Points.size()); ++point)
  {
    const Eigen::RowVector2d position = patch.Positions.row(point);
    const Eigen::RowVector2d margin = Eigen::RowVector2d::Constant(snap);
    outline.ForEachNear(position - margin, position + margin,
      [&](int side)
      {
        for (const int corner : { side, (side + 1) % outline.Size() })
        {
          const double distance = (outline.Corner(corner) - position).norm();
          if (distance < snap)
          {
            pulls.insert({ distance, corner, point });
          }
        }
        return true;
      });
  }
  Eigen::MatrixXd snapped = loop;
  std::set<int> corners, points;
  for (const Pull& pull : pulls)
  {
    if (corners.count(pull.Corner) + points.count(pull.Point) == 0)
    {
      snapped.row(pull.Corner) = patch.Positions.row(pull.Point);
      corners.insert(pull.Corner);
      points.insert(pull.Point);
    }
  }
  return snapped;
}

/// Finds the region that a loop covers on a patch. Find takes these steps:
///
/// 1. Look: finds the triangles that the loop covers, and the points of the loop in each.
/// 2. ClearPointsOnSides: removes the triangles around points inside an edge of the loop.
/// 3. MakeRing: removes triangles until the boundary of the removed ones passes no point twice, and
///    checks that it ends inside the patch; WalkRing checks that they are a disk.
class Cover
{
public:
  Cover(const ExponentialPatch& patch, const std::vector<int>& twins,
    const std::vector<int>& inPatch, const Eigen::MatrixXd& loop)
    : Patch(patch)
    , Twins(twins)
    , InPatch(inPatch)
    , Outline(loop)
    , Gone(patch.Triangles.size(), false)
  {
    this->Result.Loop = loop;
    this->Result.Positions.Triangles = Eigen::VectorXi::Constant(loop.rows(), -1);
    this->Result.Positions.Barycentrics = Eigen::MatrixXd::Zero(loop.rows(), 3);
    this->IsInside.assign(loop.rows(), false);
  }

  CoveredRegion Find()
  {
    const auto triangles = static_cast<int>(this->Patch.Triangles.size());
    for (int triangle = 0; triangle < triangles; ++triangle)
    {
      this->Look(triangle);
    }
    this->ClearPointsOnSides();
    if (this->Result.Fault == CoveredRegionFault::None)
    {
      this->MakeRing();
    }
    if (this->Result.Fault == CoveredRegionFault::None &&
      (this->Result.Positions.Triangles.array() < 0).any())
    {
      this->Result.Fault = CoveredRegionFault::BeyondPatch;
    }
    return std::move(this->Result);
  }

private:
  /// Whether a triangle is removed, and which of the loop's points lie in it.
  void Look(int triangle)
  {
    Triangle2 image = ImageOf(this->Patch, triangle);
    // All tests use exact orientation: a decision by rounding would leave a gap or an overlap in
    // the ring.
    const int turn = EvaluateOrientation(
      Eigen::RowVector2d(image.row(0)), Eigen::RowVector2d(image.row(1)), image.row(2));
    if (turn > 0)
    {
      this->PlaceLoop(triangle, image);
      this->Gone[triangle] = this->Gone[triangle] || this->Outline.Covers(image);
      return;
    }
    // A flipped or degenerate triangle: at the loop it is a fault, since the image is not one to
    // one there. Inside the loop it is removed anyway.
    bool isAtLoop = false;
    if (turn < 0)
    {
      image.row(1).swap(image.row(2));
      isAtLoop = this->Outline.Crosses(image);
    }
    if (isAtLoop)
    {
      this->Result.Fault = CoveredRegionFault::Flipped;
      ++this->Result.FlippedAtLoop;
    }
    if (isAtLoop || this->Outline.Side(image.colwise().mean()) > 0)
    {
      this->Gone[triangle] = true;
      ++this->Result.Flipped;
    }
  }

  void PlaceLoop(int triangle, const Triangle2& image)
  {
    this->Outline.ForEachNear(image.colwise().minCoeff(), image.colwise().maxCoeff(),
      [&](int side)
      {
        const Eigen::RowVector2d position = this->Outline.Corner(side);
        Eigen::RowVector3d areas;
        int zeros = 0;
        for (int k = 0; k < 3; ++k)
        {
          const Eigen::RowVector2d a = image.row((k + 1) % 3), b = image.row((k + 2) % 3);
          const int turn = EvaluateOrientation(a, b, position);
          if (turn < 0)
          {
            return true;
          }
          zeros += turn == 0;
          const Eigen::RowVector2d along = b - a, up = position - a;
          // The barycentric coordinate of corner k is the area opposite to it. The exact sign
          // decides; rounding must not make an area negative.
          areas(k) = turn == 0 ? 0.0 : std::max(along.x() * up.y() - along.y() * up.x(), 0.0);
        }
        // Inside two triangles: the patch covers the plane twice.
        if (zeros == 0 && this->IsInside[side] && this->Result.Fault == CoveredRegionFault::None)
        {
          this->Result.Fault = CoveredRegionFault::Overlaps;
        }
        this->IsInside[side] = this->IsInside[side] || zeros == 0;
        // A corner of the loop inside an edge would split it, and so the triangles beside it.
        this->Gone[triangle] = this->Gone[triangle] || zeros == 1;
        const double sum = areas.sum();
        if (this->Result.Positions.Triangles(side) < 0 && sum > 0.0)
        {
          this->Result.Positions.Triangles(side) = this->Patch.Triangles[triangle];
          this->Result.Positions.Barycentrics.row(side) = areas / sum;
        }
        return true;
      });
  }

  /// Removes the triangles around points inside an edge of the loop: they would split it.
  void ClearPointsOnSides()
  {
    const auto points = static_cast<int>(this->Patch.Points.size());
    std::vector<bool> split(points, false);
    for (int point = 0; point < points; ++point)
    {
      const Eigen::RowVector2d position = this->Patch.Positions.row(point);
      this->Outline.ForEachNear(position, position,
        [&](int side)
        {
          const Eigen::RowVector2d a = this->Outline.Corner(side),
                                   b = this->Outline.Corner(side + 1);
          split[point] = split[point] ||
            (position != a && position != b && EvaluateOrientation(a, b, position) == 0);
          return true;
        });
    }
    this->ClearAround(split);
  }

  /// Removes the triangles around these points; returns whether there were any.
  bool ClearAround(const std::vector<bool>& points)
  {
    bool some = false;
    for (std::size_t triangle = 0; triangle < this->Gone.size(); ++triangle)
    {
      for (int k = 0; k < 3 && !this->Gone[triangle]; ++k)
      {
        if (points[this->Patch.Corners(static_cast<int>(triangle), k)])
        {
          this->Gone[triangle] = some = true;
        }
      }
    }
    return some;
  }

  /// The triangle of the patch across edge k of another one; -1 beyond the patch, -2 at the
  /// boundary.
  int NextTo(int triangle, int k) const
  {
    const int twin = this->Twins[3 * this->Patch.Triangles[triangle] + k];
    return twin < 0 ? -2 : this->InPatch[twin / 3];
  }

  /// Whether the loop crosses an edge of the patch from p to q.
  bool CrossesLoop(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q) const
  {
    return this->Outline.Side(p) > 0 || this->Outline.Side(q) > 0 ||
      !this->Outline.ForEachNear(p.cwiseMin(q), p.cwiseMax(q),
        [&](int side)
        {
          const Eigen::RowVector2d a = this->Outline.Corner(side),
                                   b = this->Outline.Corner(side + 1);
          return EvaluateOrientation(p, q, a) * EvaluateOrientation(p, q, b) >= 0 ||
            EvaluateOrientation(a, b, p) * EvaluateOrientation(a, b, q) >= 0;
        });
  }

  void MakeRing()
  {
    const auto points = static_cast<int>(this->Patch.Points.size());
    std::vector<int> next;
    int sides = 0;
    std::vector<bool> pinched(points, false);
    do
    {
      next.assign(points, -1);
      pinched.assign(points, false);
      sides = 0;
      for (std::size_t t = 0; t < this->Gone.size(); ++t)
      {
        for (int k = 0; k < 3 && this->Gone[t]; ++k)
        {
          const auto triangle = static_cast<int>(t);
          const int beside = this->NextTo(triangle, k);
          if (beside < 0 || !this->Gone[beside])
          {
            const int begin = this->Patch.Corners(triangle, k);
            pinched[begin] = pinched[begin] || next[begin] >= 0;
            next[begin] = this->Patch.Corners(triangle, (k + 1) % 3);
            ++sides;
            this->CheckLimit(beside, begin, next[begin]);
          }
        }
      }
      // Removing the triangles around a pinched point may pinch another one, so the search is
      // repeated. It ends, since each round removes triangles.
    } while (this->Result.Fault == CoveredRegionFault::None && this->ClearAround(pinched));
    if (this->Result.Fault == CoveredRegionFault::None)
    {
      this->WalkRing(next, sides);
    }
  }

  /// The loop must not cross an edge of the ring where the patch ends.
  void CheckLimit(int beside, int begin, int end)
  {
    if (beside < 0 &&
      this->CrossesLoop(this->Patch.Positions.row(begin), this->Patch.Positions.row(end)))
    {
      this->Result.Fault =
        beside == -1 ? CoveredRegionFault::BeyondPatch : CoveredRegionFault::LeavesSurface;
    }
  }

  void WalkRing(const std::vector<int>& next, int sides)
  {
    std::vector<bool> used(this->Patch.Points.size(), false);
    int triangles = 0;
    for (std::size_t t = 0; t < this->Gone.size(); ++t)
    {
      if (this->Gone[t])
      {
        ++triangles;
        this->Result.Triangles.push_back(this->Patch.Triangles[t]);
        for (int k = 0; k < 3; ++k)
        {
          used[this->Patch.Corners(static_cast<int>(t), k)] = true;
        }
      }
    }
    const auto first =
      std::find_if(next.begin(), next.end(), [](int point) { return point >= 0; }) - next.begin();
    // A ring without edges: the removed triangles are a closed surface, or there are none.
    if (first == static_cast<std::ptrdiff_t>(next.size()))
    {
      this->Result.Fault = CoveredRegionFault::BeyondPatch;
      return;
    }
    std::vector<int> ring;
    auto at = static_cast<int>(first);
    do
    {
      ring.push_back(at);
      at = next[at];
    } while (at != first && at >= 0 && static_cast<int>(ring.size()) < sides);
    const auto points = static_cast<int>(std::count(used.begin(), used.end(), true));
    // A disk: one ring, and points - edges + triangles = 1.
    // Each triangle has three edges, and each inner edge two triangles, so the number of edges is
    // (3 triangles + sides) / 2.
    if (at != first || static_cast<int>(ring.size()) != sides ||
      points - (3 * triangles + sides) / 2 + triangles != 1)
    {
      this->Result.Fault = CoveredRegionFault::NotADisk;
      return;
    }
    this->Result.RingImage.resize(sides, 2);
    for (int i = 0; i < sides; ++i)
    {
      this->Result.Ring.push_back(this->Patch.Points[ring[i]]);
      this->Result.RingImage.row(i) = this->Patch.Positions.row(ring[i]);
    }
  }

  const ExponentialPatch& Patch;
  const std::vector<int>&Twins, &InPatch;
  PlanarOutline Outline;
  std::vector<bool> Gone;     ///< whether each triangle of the patch is removed
  std::vector<bool> IsInside; ///< whether each point of the loop is inside a triangle
  CoveredRegion Result;
};

} // namespace

CoveredRegionFinder::CoveredRegionFinder(const Surface& target)
  : Target(target)
  , InPatch(target.Triangles().rows(), -1)
{
}

CoveredRegion CoveredRegionFinder::Find(
  const ExponentialPatch& patch, const Eigen::MatrixXd& loop, double snap)
{
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    this->InPatch[patch.Triangles[t]] = static_cast<int>(t);
  }
  CoveredRegion footprint =
    Cover(patch, this->Target.Twins(), this->InPatch, Snapped(patch, loop, snap)).Find();
  // Only the entries that were set are reset: the time does not depend on the size of the target.
  for (const int triangle : patch.Triangles)
  {
    this->InPatch[triangle] = -1;
  }
  return footprint;
}

} // namespace shape
