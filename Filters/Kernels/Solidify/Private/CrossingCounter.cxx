#include "Solidify/Private/CrossingCounter.h"

#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// What Eigen's search calls for each box and triangle: counts those that a ray crosses.
struct RayCount
{
  const Mesh& Crossed;
  const Eigen::VectorXi& Components; ///< of the points
  RowVector3d Origin, Direction;
  int Component, Skipped;
  int Found = 0;

  // Eigen calls these two by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Eigen::AlignedBox3d& box) const
  {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const double low = (box.min()(k) - this->Origin(k)) / this->Direction(k);
      const double high = (box.max()(k) - this->Origin(k)) / this->Direction(k);
      enter = std::max(enter, std::min(low, high));
      leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
  }
  bool intersectObject(int triangle)
  {
    if (triangle == this->Skipped ||
      this->Components(this->Crossed.Triangles(triangle, 0)) != this->Component)
    {
      return false;
    }
    // Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
    const Eigen::Matrix3d corners = GetCorners(this->Crossed, triangle);
    const RowVector3d u = corners.row(1) - corners.row(0), v = corners.row(2) - corners.row(0);
    const RowVector3d p = this->Direction.cross(v), from = this->Origin - corners.row(0);
    const double determinant = u.dot(p);
    const RowVector3d q = from.cross(u);
    const double a = from.dot(p) / determinant, b = this->Direction.dot(q) / determinant;
    this->Found +=
      determinant != 0.0 && a >= 0.0 && b >= 0.0 && a + b <= 1.0 && v.dot(q) / determinant > 0.0;
    return false; // continue the search
  }
  // NOLINTEND(readability-identifier-naming)
};

/// Random unit vectors, none of which is parallel to an axis plane.
class RandomDirections
{
public:
  RowVector3d Next()
  {
    std::normal_distribution<double> normal;
    RowVector3d direction = RowVector3d::Zero();
    while (direction.cwiseAbs().minCoeff() < 1e-6)
    {
      for (int k = 0; k < 3; ++k)
      {
        direction(k) = normal(this->Random);
      }
    }
    return direction.normalized();
  }
  double Share() { return std::uniform_real_distribution<double>()(this->Random); }

private:
  std::mt19937 Random{ 1 };
};

} // namespace

CrossingCounter::CrossingCounter(Surface surface)
  : Crossed(std::move(surface))
  , Boxes(GetTriangleBoxes(this->Crossed))
{
}

int CrossingCounter::Count(
  const RowVector3d& origin, const RowVector3d& direction, int component, int skipped) const
{
  const Eigen::VectorXi& components = this->Crossed.Topology().ComponentId;
  RayCount count{ this->Crossed, components, origin, direction, component, skipped };
  Eigen::BVIntersect(*this->Boxes, count);
  return count.Found;
}

bool CrossingCounter::IsInside(const RowVector3d& position, int point, int rays) const
{
  const int component = this->Crossed.Topology().ComponentId(point);
  RandomDirections random;
  int odd = 0;
  for (int i = 0; i < rays; ++i)
  {
    odd += this->Count(position, random.Next(), component, -1) % 2;
  }
  return 2 * odd > rays;
}

double CrossingCounter::ComputeRedundancy(const std::vector<int>& triangles, int rays) const
{
  RandomDirections random;
  const Mesh& mesh = this->Crossed;
  std::vector<double> areas;
  for (const int t : triangles)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    areas.push_back(
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).norm());
  }
  const int component = this->Crossed.Topology().ComponentId(mesh.Triangles(triangles[0], 0));
  std::mt19937 choices(2);
  std::discrete_distribution<int> choose(areas.begin(), areas.end());
  int same = 0;
  for (int i = 0; i < rays; ++i)
  {
    const int t = triangles[choose(choices)];
    const double root = std::sqrt(random.Share()), along = random.Share();
    const RowVector3d position =
      RowVector3d(1.0 - root, root * (1.0 - along), root * along) * GetCorners(mesh, t);
    const RowVector3d direction = random.Next();
    const int crossings = this->Count(position, direction, component, t) +
      this->Count(position, -direction, component, t);
    same += crossings % 2 == 0;
  }
  return static_cast<double>(same) / rays;
}

} // namespace shape
