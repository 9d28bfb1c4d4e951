#include "Correspondence/Averages/PhongProjection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

constexpr double SnappedWeight = 1e-9; // below, a barycentric coordinate is rounding

using Plane = PhongProjection::Plane;

/// Returns the two edges of a triangle at its first corner (d x 2).
Plane EdgesOf(const Eigen::MatrixXd& positions, const Eigen::RowVector3i& corners)
{
  Plane edges(positions.cols(), 2);
  edges.col(0) = positions.row(corners(1)) - positions.row(corners(0));
  edges.col(1) = positions.row(corners(2)) - positions.row(corners(0));
  return edges;
}

} // namespace

PhongProjection::PhongProjection(const Surface& surface, const Eigen::MatrixXd& positions)
  : Searched(surface)
  , Positions(positions)
  , Tree(this->Searched.Triangles(), this->Positions)
{
  const Eigen::Index d = positions.cols();
  std::vector<Eigen::MatrixXd> sums(positions.rows(), Eigen::MatrixXd::Zero(d, d));
  for (const auto& corners : this->Searched.Triangles().rowwise())
  {
    // Gram and Schmidt; a triangle without area has no plane.
    Plane basis = EdgesOf(positions, corners);
    const double base = basis.col(0).norm();
    basis.col(0) /= base > 0.0 ? base : 1.0;
    basis.col(1) -= basis.col(0).dot(basis.col(1)) * basis.col(0);
    const double height = basis.col(1).norm();
    basis.col(1) /= height > 0.0 ? height : 1.0;
    const Eigen::MatrixXd projection = 0.5 * base * height * basis * basis.transpose();
    for (const int corner : corners)
    {
      sums[corner] += projection;
    }
  }
  for (const Eigen::MatrixXd& sum : sums)
  {
    this->Tangents.emplace_back(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sum).eigenvectors().rightCols(2));
  }
}

/// If S has the bases of the corners' planes as columns, scaled by the roots of the weights, the
/// mean projection is S S'. It has the eigenvalues of S' S, and if y is an eigenvector of S' S,
/// then S y is one of S S'.
Plane PhongProjection::TangentIn(int triangle, const Eigen::RowVector3d& barycentric) const
{
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, MaximumDimension, 6> spanning(
    this->Positions.cols(), 6);
  for (int k = 0; k < 3; ++k)
  {
    spanning.middleCols<2>(2 * k) =
      std::sqrt(barycentric(k)) * this->Tangents[this->Searched.Triangles()(triangle, k)];
  }
  const Eigen::Matrix<double, 6, 6> gram = spanning.transpose().lazyProduct(spanning);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(gram);
  const Eigen::Matrix<double, 6, 2> leading = solver.eigenvectors().rightCols<2>();
  Plane plane = spanning.lazyProduct(leading);
  plane.col(0).normalize();
  plane.col(1).normalize();
  return plane;
}

/// Solves U' (x - p) = 0 in the plane of a triangle, where U is a basis of the tangent plane at p.
/// U is taken at the previous p, until p no longer changes.
Eigen::RowVector3d PhongProjection::Solve(
  int triangle, const Eigen::RowVectorXd& position, Eigen::RowVector3d barycentric) const
{
  const Eigen::RowVector3i corners = this->Searched.Triangles().row(triangle);
  const Plane edges = EdgesOf(this->Positions, corners);
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MaximumDimension, 1> from =
    (position - this->Positions.row(corners(0))).transpose();
  constexpr int maximum = 30;
  for (int i = 0; i < maximum; ++i)
  {
    Eigen::RowVector3d inside = barycentric.cwiseMax(0.0);
    inside /= inside.sum();
    const Plane tangent = this->TangentIn(triangle, inside);
    const Eigen::Matrix2d matrix = tangent.transpose().lazyProduct(edges);
    const Eigen::Vector2d right = tangent.transpose().lazyProduct(from);
    const Eigen::Vector2d solution = matrix.fullPivLu().solve(right);
    const Eigen::RowVector3d next(1.0 - solution.sum(), solution(0), solution(1));
    const double change = (next - barycentric).cwiseAbs().maxCoeff();
    barycentric = next;
    if (!(change > 0.1 * SnappedWeight) || barycentric.minCoeff() < -1.0)
    {
      break; // found, or far outside this triangle
    }
  }
  return barycentric;
}

SurfacePoint PhongProjection::Find(
  const Eigen::RowVectorXd& position, const SurfacePoint& start) const
{
  const std::vector<int>& twins = this->Searched.Twins();
  SurfacePoint point = start;
  std::vector<int> passed;
  while (std::find(passed.begin(), passed.end(), point.Triangle) == passed.end())
  {
    passed.push_back(point.Triangle);
    const Eigen::RowVector3d weights = this->Solve(point.Triangle, position, point.Barycentric);
    Eigen::Index corner = 0;
    if (weights.minCoeff(&corner) >= -SnappedWeight)
    {
      point.Barycentric = (weights.array() < SnappedWeight).select(0.0, weights);
      point.Barycentric /= point.Barycentric.sum();
      return point;
    }
    const int twin = twins[3 * point.Triangle + (static_cast<int>(corner) + 1) % 3];
    if (twin < 0 || !weights.allFinite())
    {
      break;
    }
    point.Triangle = twin / 3;
    point.Barycentric = Eigen::RowVector3d::Constant(1.0 / 3.0);
  }
  return this->Tree.Find(position, point.Triangle);
}

} // namespace shape
