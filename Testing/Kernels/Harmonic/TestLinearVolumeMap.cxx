#include "Base/Errors.h"
#include "Harmonic/LinearVolumeMap.h"
#include "Support/TestShapes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{

/// A number that depends on a map, with its derivatives by images and Jacobians.
struct MapFunction
{
  std::function<double(const Eigen::MatrixXd& images, const Eigen::MatrixXd& jacobians)> Value;
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& images)> ByImages;
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& jacobians)> ByJacobians;
};

Eigen::Matrix3d Matrix(const Eigen::MatrixXd& jacobians, Eigen::Index i)
{
  const Eigen::Matrix<double, 9, 1> row = jacobians.row(i);
  return row.reshaped<Eigen::RowMajor>(3, 3);
}

/// A sum of sines, the squared distance from a shape, and a sum of squared determinants.
std::vector<MapFunction> Functions(const Eigen::MatrixXd& goal)
{
  const Eigen::Index n = goal.rows();
  const auto noSlope = [n](const Eigen::MatrixXd&)
  { return Eigen::MatrixXd(Eigen::MatrixXd::Zero(n, 9)); };
  const auto noPull = [n](const Eigen::MatrixXd&)
  { return Eigen::MatrixXd(Eigen::MatrixXd::Zero(n, 3)); };
  const MapFunction sines{ [](const Eigen::MatrixXd& y, const Eigen::MatrixXd&)
    { return (2.0 * y.array()).sin().sum(); },
    [](const Eigen::MatrixXd& y) { return Eigen::MatrixXd(2.0 * (2.0 * y.array()).cos()); },
    noSlope };
  const MapFunction distance{ [goal](const Eigen::MatrixXd& y, const Eigen::MatrixXd&)
    { return (y - goal).squaredNorm(); },
    [goal](const Eigen::MatrixXd& y) { return Eigen::MatrixXd(2.0 * (y - goal)); }, noSlope };
  const MapFunction volume{ [](const Eigen::MatrixXd& y, const Eigen::MatrixXd& j)
    {
      double sum = 0.0;
      for (Eigen::Index i = 0; i < y.rows(); ++i)
      {
        sum += 0.5 * std::pow(Matrix(j, i).determinant(), 2);
      }
      return sum;
    },
    noPull,
    [](const Eigen::MatrixXd& j)
    {
      Eigen::MatrixXd slopes(j.rows(), 9);
      for (Eigen::Index i = 0; i < j.rows(); ++i)
      {
        const Eigen::Matrix3d jacobian = Matrix(j, i);
        const Eigen::Matrix3d slope =
          std::pow(jacobian.determinant(), 2) * jacobian.inverse().transpose();
        slopes.row(i) = slope.reshaped<Eigen::RowMajor>().transpose();
      }
      return slopes;
    } };
  return { sines, distance, volume };
}

/// The slope of g at 0, by differences of fourth order.
double Slope(const std::function<double(double)>& g)
{
  constexpr double h = 0.01;
  return (8.0 * (g(h) - g(-h)) - (g(2.0 * h) - g(-2.0 * h))) / (12.0 * h);
}

/// A ball with bumps that has a void, whose surface faces out of the solid.
shape::Mesh HollowBall()
{
  shape::Mesh outer = shapetest::Icosphere(3);
  const shape::Mesh inner = shapetest::Icosphere(2);
  const Eigen::Index n = outer.Points.rows(), m = outer.Triangles.rows();
  for (auto p : outer.Points.rowwise())
  {
    p *= 1.0 + 0.1 * std::sin(3.0 * p(0)) * std::cos(2.0 * p(1));
  }
  outer.Points.conservativeResize(n + inner.Points.rows(), 3);
  outer.Points.bottomRows(inner.Points.rows()) = 0.4 * inner.Points;
  outer.Triangles.conservativeResize(m + inner.Triangles.rows(), 3);
  outer.Triangles.bottomRows(inner.Triangles.rows()) =
    inner.Triangles.rowwise().reverse().array() + static_cast<int>(n);
  return outer;
}

Eigen::MatrixXd InnerPoints(double radius)
{
  return radius * shapetest::Icosphere(1).Points;
}

shape::LinearVolumeMapOptions Accurate()
{
  shape::LinearVolumeMapOptions options;
  options.Tolerance = 1e-12;
  options.GradientTolerance = 1e-10;
  return options;
}

/// Images with a smooth part and noise, near the boundary itself.
Eigen::MatrixXd Images(const Eigen::MatrixXd& points)
{
  return points + 0.1 * (2.0 * points.rowwise().reverse().array()).sin().matrix() +
    0.01 * Eigen::MatrixXd::Random(points.rows(), 3);
}

} // namespace

TEST(LinearVolumeMap, GradientsByImagesAgreeWithFiniteDifferences)
{
  std::srand(7);
  for (const shape::Mesh& boundary : { shapetest::Icosphere(3), HollowBall() })
  {
    const shape::LinearVolumeMap solver(boundary, Accurate());
    const Eigen::MatrixXd images = Images(boundary.Points), points = InnerPoints(0.7);
    const shape::ChargeSet map = solver.Fit(images);
    for (const MapFunction& f : Functions(points.rowwise().reverse()))
    {
      const Eigen::MatrixXd gradient =
        solver.Gradient(points, f.ByImages(shape::Evaluate(map, points)),
          f.ByJacobians(shape::EvaluateJacobians(map, points)));
      for (int trial = 0; trial < 3; ++trial)
      {
        const Eigen::MatrixXd direction = Eigen::MatrixXd::Random(images.rows(), 3);
        const double slope = Slope(
          [&](double step)
          {
            const shape::ChargeSet moved = solver.Fit(images + step * direction);
            return f.Value(shape::Evaluate(moved, points), shape::EvaluateJacobians(moved, points));
          });
        EXPECT_NEAR(gradient.cwiseProduct(direction).sum(), slope,
          1e-6 * gradient.norm() * direction.norm() /
            std::sqrt(static_cast<double>(direction.size())));
      }
    }
  }
}

TEST(LinearVolumeMap, GradientsByChargesAgreeWithFiniteDifferences)
{
  std::srand(11);
  const Eigen::MatrixXd points = InnerPoints(0.5);
  shape::ChargeSet map{ 1.5 * shapetest::Icosphere(1).Points, Eigen::MatrixXd::Random(42, 3) };
  for (const MapFunction& f : Functions(points.rowwise().reverse()))
  {
    const shape::ChargeGradient gradient =
      shape::ComputeChargeGradient(map, points, f.ByImages(shape::Evaluate(map, points)),
        f.ByJacobians(shape::EvaluateJacobians(map, points)));
    const shape::ChargeSet direction{ map.Points, Eigen::MatrixXd::Random(42, 3),
      Eigen::Matrix<double, 3, 4>::Random() };
    const double slope = Slope(
      [&](double step)
      {
        shape::ChargeSet moved = map;
        moved.Charges += step * direction.Charges;
        moved.Affine += step * direction.Affine;
        return f.Value(shape::Evaluate(moved, points), shape::EvaluateJacobians(moved, points));
      });
    const double product = gradient.Charges.cwiseProduct(direction.Charges).sum() +
      gradient.Affine.cwiseProduct(direction.Affine).sum();
    EXPECT_NEAR(product, slope, 1e-6 * std::abs(slope));
  }
}

TEST(LinearVolumeMap, GradientIsTheTransposedFitWithFastSumsToo)
{
  // 30,722 rows and 10,242 charges are summed by the multipole method.
  std::srand(13);
  const shape::Mesh boundary = shapetest::Icosphere(5);
  const shape::LinearVolumeMap solver(boundary);
  const Eigen::MatrixXd images = Images(boundary.Points), points = InnerPoints(0.8);
  const Eigen::MatrixXd weights = Eigen::MatrixXd::Random(points.rows(), 3);
  const double value = weights.cwiseProduct(shape::Evaluate(solver.Fit(images), points)).sum();
  const double product = solver.Gradient(points, weights).cwiseProduct(images).sum();
  EXPECT_NEAR(product, value, 1e-6 * std::abs(value));
}

TEST(LinearVolumeMap, AffineImagesGiveTheAffineMap)
{
  const shape::Mesh boundary = HollowBall();
  Eigen::Matrix3d linear;
  linear << 1.2, 0.3, 0.0, -0.1, 0.8, 0.2, 0.0, 0.1, 1.1;
  const auto affine = [&](const Eigen::MatrixXd& points) {
    return Eigen::MatrixXd((points * linear.transpose()).rowwise() + Eigen::RowVector3d(5, 6, 7));
  };
  const Eigen::MatrixXd points = InnerPoints(0.7);
  const shape::ChargeSet map = shape::LinearVolumeMap(boundary).Fit(affine(boundary.Points));
  EXPECT_LT((shape::Evaluate(map, points) - affine(points)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(LinearVolumeMap, GradientOfAnImageIsTheHarmonicMeasure)
{
  // Around the centre of a ball, the harmonic measure is the area of the sphere. It sums to 1, and
  // its moment is the position, anywhere: affine maps are exact.
  const shape::Mesh ball = shapetest::Icosphere(3);
  const shape::LinearVolumeMap solver(ball);
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(1, 3);
  const Eigen::VectorXd measure = solver.Gradient(Eigen::MatrixXd::Zero(1, 3), unit).col(0);
  const Eigen::VectorXd areas = shape::ComputePointAreas(ball);
  EXPECT_LT((measure - areas / areas.sum()).cwiseAbs().maxCoeff(), 0.02 * measure.maxCoeff());
  const Eigen::RowVector3d point(0.3, -0.5, 0.4);
  const Eigen::VectorXd other = solver.Gradient(point, unit).col(0);
  EXPECT_NEAR(other.sum(), 1.0, 1e-9);
  EXPECT_LT((other.transpose() * ball.Points - point).norm(), 1e-9);
}

TEST(LinearVolumeMap, ConvergesToTheHarmonicMap)
{
  // The error for x^2 - y^2, which is harmonic, decreases with the square of the spacing.
  const Eigen::MatrixXd points = InnerPoints(0.6);
  double last = 1.0;
  for (const int level : { 2, 3, 4 })
  {
    const shape::Mesh ball = shapetest::Icosphere(level);
    const auto saddle = [](const Eigen::MatrixXd& p)
    {
      Eigen::MatrixXd values = p;
      values.col(2) = p.col(0).cwiseAbs2() - p.col(1).cwiseAbs2();
      return values;
    };
    const shape::ChargeSet map = shape::LinearVolumeMap(ball).Fit(saddle(ball.Points));
    const double error = (shape::Evaluate(map, points) - saddle(points)).cwiseAbs().maxCoeff();
    EXPECT_LT(error, level == 2 ? 0.05 : 0.35 * last);
    last = error;
  }
}

TEST(LinearVolumeMap, RefusesWrongNumbersOfRows)
{
  const shape::LinearVolumeMap solver(shapetest::Icosphere(1));
  EXPECT_THROW(solver.Fit(Eigen::MatrixXd::Zero(3, 3)), shape::InvalidInput);
  EXPECT_THROW(
    solver.Gradient(Eigen::MatrixXd::Zero(2, 3), Eigen::MatrixXd::Zero(3, 3)), shape::InvalidInput);
}
