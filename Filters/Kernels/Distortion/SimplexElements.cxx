#include "Distortion/SimplexElements.h"

#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Laplacian/CotangentWeights.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shape
{
namespace
{

constexpr int Grain = 2048; // simplices
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Returns the edges from the first corner to the others, one per column.
template <int D>
Eigen::Matrix<double, D, D> EdgesFrom(
  const Eigen::MatrixXi& simplices, Eigen::Index t, const Eigen::MatrixXd& points)
{
  Eigen::Matrix<double, D, D> edges;
  for (int k = 0; k < D; ++k)
  {
    edges.col(k) = (points.row(simplices(t, k + 1)) - points.row(simplices(t, 0))).transpose();
  }
  return edges;
}

bool IsPositive(const Eigen::MatrixXi& simplices, Eigen::Index t, const Eigen::MatrixXd& x,
  const Eigen::Matrix2d&)
{
  return EvaluateOrientation(
           x.row(simplices(t, 0)), x.row(simplices(t, 1)), x.row(simplices(t, 2))) > 0;
}

bool IsPositive(const Eigen::MatrixXi& simplices, Eigen::Index t, const Eigen::MatrixXd& x,
  const Eigen::Matrix3d&)
{
  return EvaluateOrientation(x.row(simplices(t, 0)), x.row(simplices(t, 1)), x.row(simplices(t, 2)),
           x.row(simplices(t, 3))) > 0;
}

Eigen::Matrix2d Rotation(double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

///@{
/// The singular values of DecomposePositive, without its rotations.
Eigen::Vector2d SingularValues(const Eigen::Matrix2d& matrix)
{
  const double first = 0.5 *
    (std::hypot(matrix(0, 0) + matrix(1, 1), matrix(1, 0) - matrix(0, 1)) +
      std::hypot(matrix(0, 0) - matrix(1, 1), matrix(1, 0) + matrix(0, 1)));
  return { first, matrix.determinant() / first };
}

Eigen::Vector3d SingularValues(const Eigen::Matrix3d& matrix)
{
  return Eigen::JacobiSVD<Eigen::Matrix3d>(matrix).singularValues();
}
///@}

/// The first t > 0 at which the edges at + t by have no size. Their determinant is a polynomial in
/// t.
double FirstFlip(const Eigen::Matrix2d& at, const Eigen::Matrix2d& by)
{
  const double mixed =
    at(0, 0) * by(1, 1) + by(0, 0) * at(1, 1) - at(0, 1) * by(1, 0) - by(0, 1) * at(1, 0);
  return FindFirstRoot(at.determinant(), mixed, by.determinant(), 0.0);
}

double FirstFlip(const Eigen::Matrix3d& at, const Eigen::Matrix3d& by)
{
  const auto mixed = [](const Eigen::Matrix3d& two, const Eigen::Matrix3d& one)
  {
    return two.col(0).cross(two.col(1)).dot(one.col(2)) +
      two.col(1).cross(two.col(2)).dot(one.col(0)) + two.col(2).cross(two.col(0)).dot(one.col(1));
  };
  return FindFirstRoot(at.determinant(), mixed(at, by), mixed(by, at), by.determinant());
}

/// Returns the smallest t > 0 with a + b t + c t^2 = 0, for a > 0.
double FirstQuadraticRoot(double a, double b, double c)
{
  const double discriminant = b * b - 4.0 * a * c;
  // Of 2 a / (-b + root) and 2 a / (-b - root), the one with the larger positive denominator.
  const double denominator = discriminant >= 0.0 ? std::sqrt(discriminant) - b : 0.0;
  return denominator > 0.0 ? 2.0 * a / denominator : Infinity;
}

} // namespace

double FindFirstRoot(double a, double b, double c, double d)
{
  if (d == 0.0)
  {
    return FirstQuadraticRoot(a, b, c);
  }
  const auto value = [&](double t) { return a + t * (b + t * (c + t * d)); };
  // Between extrema the polynomial is monotonic, so the first extremum at or below 0 ends an
  // interval with the first root. Behind the extrema it falls to -infinity if d < 0.
  double from = 0.0, to = Infinity;
  const double discriminant = c * c - 3.0 * b * d;
  if (discriminant >= 0.0)
  {
    // The extrema t with b + 2 c t + 3 d t^2 = 0, without cancellation.
    const double sum = -(c + std::copysign(std::sqrt(discriminant), c));
    const double first = sum / (3.0 * d), second = sum != 0.0 ? b / sum : first;
    for (const double extremum : { std::min(first, second), std::max(first, second) })
    {
      if (extremum > from && std::isfinite(extremum))
      {
        if (value(extremum) <= 0.0)
        {
          to = extremum;
          break;
        }
        from = extremum;
      }
    }
  }
  if (std::isinf(to))
  {
    if (d > 0.0)
    {
      return Infinity;
    }
    for (to = std::max(2.0 * from, 1.0); value(to) > 0.0 && std::isfinite(to); to *= 2.0)
    {
    }
  }
  // Bisection ends when no double lies between the ends.
  for (double middle = 0.5 * (from + to); middle > from && middle < to; middle = 0.5 * (from + to))
  {
    (value(middle) > 0.0 ? from : to) = middle;
  }
  return to;
}

PositiveDecomposition<2> DecomposePositive(const Eigen::Matrix2d& matrix)
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

PositiveDecomposition<3> DecomposePositive(const Eigen::Matrix3d& matrix)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  PositiveDecomposition<3> parts{ svd.matrixU(), svd.matrixV(), svd.singularValues() };
  if (parts.U.determinant() < 0.0)
  {
    parts.U.col(2) *= -1.0;
    parts.V.col(2) *= -1.0;
  }
  return parts;
}

template <int Dimension>
SimplexElements<Dimension>::SimplexElements(
  Eigen::MatrixXi corners, const std::vector<Square>& edges, Eigen::VectorXd sizes)
  : OwnCorners(std::move(corners))
  , OwnSizes(std::move(sizes))
{
  this->InverseEdges.reserve(edges.size());
  for (const Square& one : edges)
  {
    this->InverseEdges.push_back(one.inverse());
  }
}

template <int Dimension>
typename SimplexElements<Dimension>::Gradient SimplexElements<Dimension>::HatGradients(
  Eigen::Index simplex) const
{
  Gradient gradients;
  gradients.template bottomRows<Dimension>() = this->InverseEdges[simplex];
  gradients.row(0) = -this->InverseEdges[simplex].colwise().sum();
  return gradients;
}

template <int Dimension>
typename SimplexElements<Dimension>::Square SimplexElements<Dimension>::Jacobian(
  Eigen::Index simplex, const Eigen::MatrixXd& points) const
{
  return EdgesFrom<Dimension>(this->OwnCorners, simplex, points) * this->InverseEdges[simplex];
}

template <int Dimension>
double SimplexElements<Dimension>::Energy(const Eigen::MatrixXd& points, Distortion distortion,
  double exponent, const Progress& progress) const
{
  Eigen::VectorXd values(this->Count());
  ParallelFor(
    static_cast<int>(values.size()), Grain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const Square jacobian = this->Jacobian(t, points);
        // The determinant of a nearly flat simplex may be rounded to either sign.
        values(t) =
          jacobian.determinant() > 0.0 && IsPositive(this->OwnCorners, t, points, jacobian)
          ? EvaluateDistortion<Dimension>(distortion, exponent, SingularValues(jacobian)).Value
          : Infinity;
      }
    },
    progress);
  const double energy = this->OwnSizes.dot(values) / this->OwnSizes.sum();
  return std::isfinite(energy) ? energy : Infinity;
}

template <int Dimension>
double SimplexElements<Dimension>::LargestStep(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const
{
  Eigen::VectorXd largest(this->Count());
  ParallelFor(static_cast<int>(largest.size()), Grain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        largest(t) = FirstFlip(EdgesFrom<Dimension>(this->OwnCorners, t, points),
          EdgesFrom<Dimension>(this->OwnCorners, t, steps));
      }
    });
  return largest.minCoeff();
}

template class SimplexElements<2>;
template class SimplexElements<3>;

SimplexElements<2> BuildTriangleElements(const Mesh& surface, double scale)
{
  const TriangleAngles angles = ComputeTriangleAngles(surface);
  Eigen::VectorXd areas = scale * scale * angles.Areas;
  constexpr double minimum = 1e-12; // relative to the mean
  areas = areas.cwiseMax(minimum * areas.mean());
  std::vector<Eigen::Matrix2d> edges(areas.size());
  for (Eigen::Index t = 0; t < areas.size(); ++t)
  {
    // Corner 0 at the origin, corner 1 on the x axis. The height h divides that edge into h cot_0
    // and h cot_1, so the area is h^2 (cot_0 + cot_1) / 2.
    const double area = areas(t);
    const double side = std::sqrt(2.0 * area * (angles.Cotangents(t, 0) + angles.Cotangents(t, 1)));
    const double height = 2.0 * area / side;
    edges[t] << side, height * angles.Cotangents(t, 0), 0.0, height;
  }
  return { surface.Triangles, edges, std::move(areas) };
}

} // namespace shape
