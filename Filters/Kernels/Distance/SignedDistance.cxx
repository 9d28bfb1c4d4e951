#include "Distance/SignedDistance.h"

#include "Base/Parallel.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shape
{

namespace
{

using Eigen::RowVector3d;

/// Twice the area over the longest edge squared, up to which a triangle's normal is rounding error.
constexpr double Flat = 1e-10;

} // namespace

SignedDistance::SignedDistance(const Mesh& surface)
  : Surface(surface)
  , TriangleNormals(ComputeAreaVectors(surface).rowwise().normalized())
  , EdgeNormals(3 * surface.Triangles.rows(), 3)
  , PointNormals(Eigen::MatrixXd::Zero(surface.Points.rows(), 3))
{
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(surface, t);
    const RowVector3d u = corners.row(1) - corners.row(0);
    const RowVector3d v = corners.row(2) - corners.row(0);
    const double longest2 = std::max({ u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm() });
    if (!(u.cross(v).norm() > Flat * longest2))
    {
      this->TriangleNormals.row(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    for (int k = 0; k < 3; ++k)
    {
      const RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
      const RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      this->PointNormals.row(surface.Triangles(t, k)) += angle * this->TriangleNormals.row(t);
    }
  }
  const std::vector<HalfEdge> sides = SortHalfEdges(surface.Triangles, surface.Points.rows());
  for (auto first = sides.begin(); first != sides.end();)
  {
    RowVector3d sum = RowVector3d::Zero();
    auto last = first;
    for (; last != sides.end() && last->Low() == first->Low() && last->High() == first->High();
         ++last)
    {
      sum += this->TriangleNormals.row(last->Triangle);
    }
    for (; first != last; ++first)
    {
      this->EdgeNormals.row(3 * first->Triangle + (first->Corner + 2) % 3) = sum;
    }
  }
}

SignedDistance::Result SignedDistance::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  Result result{ {}, this->Surface.Find(points, progress.Part(0.0, 0.9)) };
  result.Distances = result.Closest.Distances;
  const Mesh& surface = this->Surface.GetSurface();
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
    const RowVector3d normal = zeros == 0 ? this->TriangleNormals.row(t)
      : zeros == 1                        ? this->EdgeNormals.row(3 * t + zero)
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
        if (ComputeWindingNumber(surface.Points, triangles, points.row(i)) > 0.5)
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
