#include "Parameterize/Private/PlanarElements.h"

#include "Base/Parallel.h"
#include "Laplacian/CotangentWeights.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shape
{
namespace
{

constexpr int Grain = 2048; // triangles

/// Returns the edges from corner 0 to the other two corners, one per column.
Eigen::Matrix2d EdgesOf(
  const Eigen::MatrixXi& triangles, Eigen::Index t, const Eigen::MatrixXd& points)
{
  Eigen::Matrix2d edges;
  edges.col(0) = points.row(triangles(t, 1)) - points.row(triangles(t, 0));
  edges.col(1) = points.row(triangles(t, 2)) - points.row(triangles(t, 0));
  return edges;
}

Eigen::Matrix2d Rotation(double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// Returns the smallest t > 0 with c + b t + a t^2 = 0, for c > 0.
double SmallestRoot(double a, double b, double c)
{
  const double discriminant = b * b - 4.0 * a * c;
  // Of 2 c / (-b + root) and 2 c / (-b - root), the one with the larger positive denominator.
  const double denominator = discriminant >= 0.0 ? std::sqrt(discriminant) - b : 0.0;
  return denominator > 0.0 ? 2.0 * c / denominator : std::numeric_limits<double>::infinity();
}

} // namespace

PlanarDecomposition DecomposePlanar(const Eigen::Matrix2d& matrix)
{
  // The matrix is the sum of a similarity e + i h and an anti-similarity f + i g.
  const double e = 0.5 * (matrix(0, 0) + matrix(1, 1)), h = 0.5 * (matrix(1, 0) - matrix(0, 1));
  const double f = 0.5 * (matrix(0, 0) - matrix(1, 1)), g = 0.5 * (matrix(1, 0) + matrix(0, 1));
  const double first = std::hypot(e, h) + std::hypot(f, g);
  const double turn = std::atan2(h, e), stretch = std::atan2(g, f);
  // Computing the smaller value as a difference would lose digits.
  return { Rotation(0.5 * (turn + stretch)), Rotation(0.5 * (stretch - turn)),
    { first, matrix.determinant() / first } };
}

PlanarElements::PlanarElements(const Mesh& surface, double scale)
  : Corners(surface.Triangles)
  , InverseEdges(surface.Triangles.rows())
{
  const TriangleAngles angles = ComputeTriangleAngles(surface);
  this->OwnAreas = scale * scale * angles.Areas;
  constexpr double minimum = 1e-12; // relative to the mean
  this->OwnAreas = this->OwnAreas.cwiseMax(minimum * this->OwnAreas.mean());
  for (Eigen::Index t = 0; t < this->OwnAreas.size(); ++t)
  {
    // Corner 0 at the origin, corner 1 on the x axis. The height h divides that edge into h cot_0
    // and h cot_1, so the area is h^2 (cot_0 + cot_1) / 2.
    const double area = this->OwnAreas(t);
    const double side = std::sqrt(2.0 * area * (angles.Cotangents(t, 0) + angles.Cotangents(t, 1)));
    const double height = 2.0 * area / side;
    const double foot = height * angles.Cotangents(t, 0);
    this->InverseEdges[t] << 1.0 / side, -foot / (side * height), 0.0, 1.0 / height;
  }
}

Eigen::Matrix<double, 3, 2> PlanarElements::Gradients(Eigen::Index triangle) const
{
  Eigen::Matrix<double, 3, 2> gradients;
  gradients.bottomRows(2) = this->InverseEdges[triangle];
  gradients.row(0) = -this->InverseEdges[triangle].colwise().sum();
  return gradients;
}

Eigen::Matrix2d PlanarElements::Jacobian(Eigen::Index triangle, const Eigen::MatrixXd& points) const
{
  return EdgesOf(this->Corners, triangle, points) * this->InverseEdges[triangle];
}

double PlanarElements::Energy(const Eigen::MatrixXd& points, Distortion distortion, double exponent,
  const Progress& progress) const
{
  Eigen::VectorXd values(this->OwnAreas.size());
  ParallelFor(
    static_cast<int>(values.size()), Grain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const Eigen::Matrix2d jacobian = this->Jacobian(t, points);
        values(t) = jacobian.determinant() > 0.0
          ? EvaluateDistortion(distortion, exponent, DecomposePlanar(jacobian).Singular).Value
          : std::numeric_limits<double>::infinity();
      }
    },
    progress);
  const double energy = this->OwnAreas.dot(values) / this->OwnAreas.sum();
  return std::isfinite(energy) ? energy : std::numeric_limits<double>::infinity();
}

double PlanarElements::LargestStep(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const
{
  Eigen::VectorXd largest(this->OwnAreas.size());
  ParallelFor(static_cast<int>(largest.size()), Grain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const Eigen::Matrix2d at = EdgesOf(this->Corners, t, points);
        const Eigen::Matrix2d by = EdgesOf(this->Corners, t, steps);
        // det(at + t by) is a quadratic polynomial in t; its first positive root is the first flip
        // (Smith and Schaefer 2015, section 3.2).
        const double mixed =
          at(0, 0) * by(1, 1) + by(0, 0) * at(1, 1) - at(0, 1) * by(1, 0) - by(0, 1) * at(1, 0);
        largest(t) = SmallestRoot(by.determinant(), mixed, at.determinant());
      }
    });
  return largest.minCoeff();
}

} // namespace shape
