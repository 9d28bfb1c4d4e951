#include "Distance/SignedDistance.h"

#include "Base/Parallel.h"
#include "Mesh/Extent.h"

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

/// Pseudonormals; NaN if a triangle, or one adjacent to the edge or the point, is degenerate.
struct SignedDistance::Pseudonormals
{
  Eigen::MatrixXd OfTriangles; ///< m x 3
  Eigen::MatrixXd OfEdges;     ///< 3m x 3: row 3 t + k is the edge opposite corner k of t
  Eigen::MatrixXd OfPoints;    ///< n x 3, angle-weighted

  explicit Pseudonormals(const Surface& surface);
};

SignedDistance::Pseudonormals::Pseudonormals(const Surface& surface)
  : OfTriangles(surface.AreaVectors().rowwise().normalized())
  , OfEdges(3 * surface.Triangles().rows(), 3)
  , OfPoints(Eigen::MatrixXd::Zero(surface.Points().rows(), 3))
{
  for (int t = 0; t < surface.Triangles().rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(surface, t);
    const RowVector3d u = corners.row(1) - corners.row(0);
    const RowVector3d v = corners.row(2) - corners.row(0);
    const double longest2 = std::max({ u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm() });
    if (!(u.cross(v).norm() > Flat * longest2))
    {
      this->OfTriangles.row(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    for (int k = 0; k < 3; ++k)
    {
      const RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
      const RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
      // The pseudonormal of a point weights each triangle by its angle there.
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      this->OfPoints.row(surface.Triangles()(t, k)) += angle * this->OfTriangles.row(t);
    }
  }
  const std::vector<HalfEdge>& halfEdges = surface.HalfEdges();
  for (auto first = halfEdges.begin(); first != halfEdges.end();)
  {
    // The pseudonormal of an edge is the sum of its triangles' normals.
    RowVector3d sum = RowVector3d::Zero();
    auto last = first;
    for (; last != halfEdges.end() && last->Low() == first->Low() && last->High() == first->High();
         ++last)
    {
      sum += this->OfTriangles.row(last->Triangle);
    }
    for (; first != last; ++first)
    {
      this->OfEdges.row(3 * first->Triangle + (first->Corner + 2) % 3) = sum;
    }
  }
}

SignedDistance::SignedDistance(const Surface& surface)
  : Nearest(surface)
  , Normals(surface.Cached<Pseudonormals>([&]() { return Pseudonormals(surface); }))
{
}

SignedDistance::Result SignedDistance::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  Result result{ {}, this->Nearest.Find(points, progress.Part(0.0, 0.9)) };
  result.Distances = result.Closest.Distances;
  const Eigen::MatrixXi& triangles = this->GetSurface().Triangles();
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
    // The pseudonormal of the feature that the closest point lies on (Baerentzen and Aanaes 2005):
    // a triangle, an edge or a point.
    const RowVector3d normal = zeros == 0 ? this->Normals->OfTriangles.row(t)
      : zeros == 1                        ? this->Normals->OfEdges.row(3 * t + zero)
                                          : this->Normals->OfPoints.row(triangles(t, other));
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
        if (ComputeWindingNumber(this->GetSurface().Points(), triangles, points.row(i)) > 0.5)
        {
          result.Distances(i) = -result.Distances(i);
        }
      }
    },
    progress.Part(0.9, 1.0));
  progress(1.0);
  return result;
}

Eigen::VectorXd ComputeDomainTolerances(
  const Surface& surface, const ClosestPoints& closest, double farthest)
{
  const double minimum = 1e-6 * ComputeLongestBoxEdge(surface);
  Eigen::VectorXd tolerances(closest.Triangles.size());
  for (Eigen::Index i = 0; i < tolerances.size(); ++i)
  {
    const int t = closest.Triangles(i);
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest,
        (surface.Points().row(surface.Triangles()(t, k)) -
          surface.Points().row(surface.Triangles()(t, (k + 1) % 3)))
          .norm());
    }
    tolerances(i) = std::max(minimum, std::min(farthest, 0.25 * longest));
  }
  return tolerances;
}

Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress)
{
  const SignedDistance::Result at = boundary.Evaluate(points, progress);
  const Eigen::VectorXd tolerances =
    ComputeDomainTolerances(boundary.GetSurface(), at.Closest, farthest);
  return (at.Distances.array() > tolerances.array()).cast<int>();
}

} // namespace shape
