#include "Untangle/Private/SlidingBoundary.h"

#include "Geometry/FeatureAngle.h"
#include "Geometry/SegmentProjection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace shape
{
namespace
{

Mesh SurfaceOf(const Eigen::MatrixXd& points, const std::vector<std::array<int, 3>>& triangles)
{
  Mesh mesh{ points, Eigen::MatrixXi(triangles.size(), 3) };
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.Triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
      triangles[t][2];
  }
  return mesh;
}

} // namespace

SlidingBoundary::SlidingBoundary(
  const Eigen::MatrixXd& points, const std::vector<std::array<int, 3>>& triangles)
  : Locator(SurfaceOf(points, triangles))
  , Normals(Eigen::MatrixXd::Zero(points.rows(), 3))
  , Freedoms(points.rows(), 3)
  , CreaseOf(points.rows(), -1)
{
  const Eigen::MatrixXd areas = ComputeAreaVectors(this->Locator.GetSurface());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const int point : triangles[t])
    {
      this->Normals.row(point) += areas.row(static_cast<Eigen::Index>(t));
      this->Freedoms[point] = 2;
    }
  }
  // Weighted by area; interpolated on triangles, these normals vary continuously.
  this->Normals.rowwise().normalize();
  this->FindCreases(triangles);
}

void SlidingBoundary::FindCreases(const std::vector<std::array<int, 3>>& triangles)
{
  // Absolute values: a fold in a smooth part is no crease.
  const double flattest = std::cos(DefaultFeatureAngle * M_PI / 180.0);
  const Eigen::MatrixXd areas = ComputeAreaVectors(this->Locator.GetSurface());
  std::map<std::array<int, 2>, std::vector<int>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      edges[{ std::min(a, b), std::max(a, b) }].push_back(static_cast<int>(t));
    }
  }
  std::map<int, std::vector<int>> along;
  for (const auto& [edge, sides] : edges)
  {
    const bool smooth = sides.size() == 2 &&
      std::abs(areas.row(sides[0]).dot(areas.row(sides[1]))) >=
        flattest * areas.row(sides[0]).norm() * areas.row(sides[1]).norm();
    if (!smooth)
    {
      along[edge[0]].push_back(edge[1]);
      along[edge[1]].push_back(edge[0]);
    }
  }
  const Eigen::MatrixXd& points = this->Locator.GetSurface().Points();
  for (const auto& [point, others] : along)
  {
    // A crease continues at a point with two crease edges that do not turn sharply.
    bool straight = others.size() == 2;
    if (straight)
    {
      const Eigen::RowVector3d in = points.row(point) - points.row(others[0]);
      const Eigen::RowVector3d out = points.row(others[1]) - points.row(point);
      straight = std::abs(in.dot(out)) >= flattest * in.norm() * out.norm();
    }
    this->Freedoms[point] = straight ? 1 : 0;
  }
  for (const auto& [start, others] : along)
  {
    if (this->Freedoms[start] != 1 || this->CreaseOf[start] >= 0)
    {
      continue;
    }
    std::vector<int> front = { start };
    // A crease consists of connected points and the edges at them, those to its ends included.
    std::vector<std::array<int, 2>> crease;
    this->CreaseOf[start] = static_cast<int>(this->Creases.size());
    for (std::size_t i = 0; i < front.size(); ++i)
    {
      for (const int next : along[front[i]])
      {
        crease.push_back({ std::min(front[i], next), std::max(front[i], next) });
        if (this->Freedoms[next] == 1 && this->CreaseOf[next] < 0)
        {
          this->CreaseOf[next] = this->CreaseOf[start];
          front.push_back(next);
        }
      }
    }
    std::sort(crease.begin(), crease.end());
    crease.erase(std::unique(crease.begin(), crease.end()), crease.end());
    this->Creases.push_back(std::move(crease));
  }
}

int SlidingBoundary::Freedom(int point) const
{
  return point < static_cast<int>(this->Freedoms.size()) ? this->Freedoms[point] : 3;
}

std::pair<Eigen::RowVector3d, Eigen::RowVector3d> SlidingBoundary::OnCrease(
  int point, const Eigen::RowVector3d& position) const
{
  const Eigen::MatrixXd& points = this->Locator.GetSurface().Points();
  double minimum = std::numeric_limits<double>::max();
  std::pair<Eigen::RowVector3d, Eigen::RowVector3d> best;
  for (const auto& [a, b] : this->Creases[this->CreaseOf[point]])
  {
    const Eigen::RowVector3d edge = points.row(b) - points.row(a);
    const Eigen::RowVector3d nearest =
      points.row(a) + ProjectOntoSegment(position, points.row(a), points.row(b)) * edge;
    if ((nearest - position).squaredNorm() < minimum)
    {
      minimum = (nearest - position).squaredNorm();
      best = { nearest, edge.normalized() };
    }
  }
  return best;
}

PointDirections SlidingBoundary::Directions(int point, const Eigen::RowVector3d& position) const
{
  switch (this->Freedom(point))
  {
    case 0:
      return PointDirections(3, 0);
    case 1:
      return this->OnCrease(point, position).second.transpose();
    case 2:
      break;
    default:
      return Eigen::Matrix3d::Identity();
  }
  const ClosestPoints closest = this->Locator.Find(position);
  Eigen::Vector3d normal =
    PullBack(closest, this->Locator.GetSurface().Triangles(), this->Normals).row(0).transpose();
  // Where the surface is folded, normals cancel out.
  if (normal.norm() < 0.1)
  {
    const Eigen::Matrix3d corners = GetCorners(this->Locator.GetSurface(), closest.Triangles(0));
    normal = (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).transpose();
  }
  PointDirections directions(3, 2);
  directions.col(0) = normal.unitOrthogonal();
  directions.col(1) = normal.normalized().cross(directions.col(0));
  return directions;
}

Eigen::RowVector3d SlidingBoundary::Nearest(int point, const Eigen::RowVector3d& position) const
{
  switch (this->Freedom(point))
  {
    case 1:
      return this->OnCrease(point, position).first;
    case 2:
      return this->Locator.Find(position).Positions.row(0);
    default:
      return position;
  }
}

} // namespace shape
