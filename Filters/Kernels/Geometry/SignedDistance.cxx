#include "Geometry/SignedDistance.h"

#include "Core/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace shape
{

namespace
{

/// Twice the area over the longest edge squared, up to which a triangle's normal is rounding error.
constexpr double Flat = 1e-10;

} // namespace

SignedDistance::SignedDistance(const Mesh& surface)
  : Surface(surface)
  , TriangleNormals(AreaVectors(surface).rowwise().normalized())
  , EdgeNormals(3 * surface.Triangles.rows(), 3)
  , PointNormals(Eigen::MatrixXd::Zero(surface.Points.rows(), 3))
{
  std::vector<std::array<int, 3>> edges; // lower point, higher point, row of EdgeNormals
  edges.reserve(3 * surface.Triangles.rows());
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = Corners(surface, t);
    const Eigen::RowVector3d u = corners.row(1) - corners.row(0);
    const Eigen::RowVector3d v = corners.row(2) - corners.row(0);
    const double longest2 = std::max({ u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm() });
    if (!(u.cross(v).norm() > Flat * longest2))
    {
      this->TriangleNormals.row(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    for (int k = 0; k < 3; ++k)
    {
      const int here = surface.Triangles(t, k);
      const int next = surface.Triangles(t, (k + 1) % 3);
      const int last = surface.Triangles(t, (k + 2) % 3);
      const Eigen::RowVector3d a = surface.Points.row(next) - surface.Points.row(here);
      const Eigen::RowVector3d b = surface.Points.row(last) - surface.Points.row(here);
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      this->PointNormals.row(here) += angle * this->TriangleNormals.row(t);
      edges.push_back({ std::min(next, last), std::max(next, last), 3 * t + k });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t last = first;
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (; last < edges.size() && edges[last][0] == edges[first][0] &&
         edges[last][1] == edges[first][1];
         ++last)
    {
      sum += this->TriangleNormals.row(edges[last][2] / 3);
    }
    for (; first < last; ++first)
    {
      this->EdgeNormals.row(edges[first][2]) = sum;
    }
  }
}

SignedDistance::Result SignedDistance::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  Result result{ {}, this->Surface.Find(points, progress.Part(0.0, 0.9)) };
  result.Distances = result.Closest.Distances;
  const Mesh& surface = this->Surface.Surface();
  const Eigen::MatrixXi& triangles = surface.Triangles;
  std::vector<int> unsure;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const int t = result.Closest.Triangles(i);
    int zeros = 0, zero = 0, other = 0;
    for (int k = 0; k < 3; ++k)
    {
      const bool isZero = result.Closest.Barycentrics(i, k) == 0.0;
      zeros += isZero;
      (isZero ? zero : other) = k;
    }
    const Eigen::RowVector3d normal = zeros == 0 ? this->TriangleNormals.row(t)
      : zeros == 1                               ? this->EdgeNormals.row(3 * t + zero)
                                                 : this->PointNormals.row(triangles(t, other));
    const double side = (points.row(i) - result.Closest.Positions.row(i)).dot(normal);
    if (side < 0.0)
    {
      result.Distances(i) = -result.Distances(i);
    }
    else if (std::isnan(side) && result.Distances(i) > 0.0)
    {
      unsure.push_back(static_cast<int>(i));
    }
  }
  ParallelFor(
    static_cast<int>(unsure.size()), 1,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        const int i = unsure[k];
        if (WindingNumber(surface.Points, triangles, points.row(i)) > 0.5)
        {
          result.Distances(i) = -result.Distances(i);
        }
      }
    },
    progress.Part(0.9, 1.0));
  progress(1.0);
  return result;
}

} // namespace shape
