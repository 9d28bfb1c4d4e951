#include "Base/Errors.h"
#include "Harmonic/Private/RegistrationEnergy.h"
#include "Harmonic/VolumeRegistration.h"
#include "Support/TestShapes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{

/// A ball whose sphere is scaled along the axes.
shape::Mesh Ellipsoid(int level, const Eigen::RowVector3d& axes)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  mesh.Points *= axes.asDiagonal();
  return mesh;
}

/// A ball with a dent at its top.
shape::Mesh DentedBall(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (auto p : mesh.Points.rowwise())
  {
    const double far = (p - Eigen::RowVector3d(0.0, 0.0, 1.0)).squaredNorm();
    p *= 1.0 - 0.3 * std::exp(-far / 0.3);
  }
  return mesh;
}

/// Returns the smallest determinant of the Jacobian at random positions of the unit ball.
double SmallestDeterminant(const shape::ChargeSet& map, double radius)
{
  std::srand(5);
  Eigen::MatrixXd points = Eigen::MatrixXd::Random(20000, 3);
  for (auto p : points.rowwise())
  {
    p *= radius * p.cwiseAbs().maxCoeff() / p.norm(); // from the cube to the ball
  }
  const Eigen::MatrixXd rows = shape::EvaluateJacobians(map, points);
  double smallest = 1e300;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    const Eigen::Matrix<double, 9, 1> row = rows.row(i);
    smallest = std::min(smallest, row.reshaped<Eigen::RowMajor>(3, 3).eval().determinant());
  }
  return smallest;
}

} // namespace

TEST(VolumeRegistration, GradientAgreesWithFiniteDifferences)
{
  std::srand(3);
  const shape::Mesh ball = shapetest::Icosphere(2);
  shape::LinearVolumeMapOptions accurate;
  accurate.Tolerance = 1e-12;
  accurate.GradientTolerance = 1e-10;
  const shape::RegistrationEnergy energy(ball, Ellipsoid(2, { 1.3, 1.0, 0.8 }), 1.1, accurate);
  const Eigen::MatrixXd images =
    1.1 * ball.Points + 0.03 * (3.0 * ball.Points.rowwise().reverse().array()).sin().matrix();
  for (const double weight : { 1e-6, 1.0 })
  {
    const Eigen::MatrixXd gradient = energy.Gradient(energy.Evaluate(images), weight);
    for (int trial = 0; trial < 3; ++trial)
    {
      // Random directions; their differences cross the edges of closest points.
      const Eigen::MatrixXd direction = Eigen::MatrixXd::Random(images.rows(), 3);
      constexpr double h = 1e-5;
      const auto value = [&](double step)
      { return energy.Evaluate(images + step * direction).Value(weight); };
      const double slope =
        (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
      EXPECT_NEAR(
        gradient.cwiseProduct(direction).sum(), slope, 1e-6 * gradient.norm() * direction.norm());
    }
  }
}

TEST(VolumeRegistration, FindsAnAffineDeformationOfAnEllipsoid)
{
  const shape::Mesh solid = Ellipsoid(3, { 1.5, 1.0, 0.7 });
  // Stretched along its axes, turned and moved.
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3d linear = turn * Eigen::Vector3d(1.2, 1.0, 0.9).asDiagonal();
  const auto affine = [&](const Eigen::MatrixXd& points) {
    return Eigen::MatrixXd((points * linear.transpose()).rowwise() + Eigen::RowVector3d(3, 2, 1));
  };
  const shape::Mesh target{ affine(solid.Points), solid.Triangles };
  const shape::VolumeRegistrationResult result = shape::RegisterVolume(solid, target);
  const double size = shape::ComputeLongestBoxEdge(target.Points);
  EXPECT_GT(result.Before.MeanDistance, 0.01);
  EXPECT_LT(result.After.MeanDistance, 0.01);
  // An ellipsoid is the same after half a turn about an axis, so the map is that up to half turns.
  double least = 1e300;
  for (const Eigen::Vector3d& signs : { Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
         Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1) })
  {
    const Eigen::MatrixXd points = 0.6 * solid.Points;
    const Eigen::MatrixXd errors =
      shape::Evaluate(result.Map, points) - affine(points * signs.asDiagonal());
    least = std::min(least, errors.rowwise().norm().maxCoeff());
  }
  EXPECT_LT(least, 0.01 * size);
}

TEST(VolumeRegistration, MapsABallOntoADentedBallWithoutFolds)
{
  const shape::Mesh ball = shapetest::Icosphere(3), target = DentedBall(3);
  shape::VolumeRegistrationOptions options;
  options.Align = false;
  const shape::VolumeRegistrationResult result = shape::RegisterVolume(ball, target, options);
  EXPECT_GT(result.Before.MeanDistance, 0.02);
  EXPECT_LT(result.After.MeanDistance, 0.01);
  EXPECT_GT(SmallestDeterminant(result.Map, 0.95), 0.0);
  // Map is the harmonic map of Targets.
  const Eigen::MatrixXd errors = shape::Evaluate(result.Map, ball.Points) - result.Targets;
  EXPECT_LT(errors.rowwise().norm().maxCoeff(), 0.05 * shape::ComputeLongestBoxEdge(target.Points));
}

TEST(VolumeRegistration, KeepsASimilarSolidAsItIs)
{
  const shape::Mesh ball = DentedBall(2);
  shape::VolumeRegistrationOptions options;
  options.MaximumIterations = 5;
  const shape::Mesh target{ 2.0 * ball.Points, ball.Triangles };
  const shape::VolumeRegistrationResult result = shape::RegisterVolume(ball, target, options);
  EXPECT_NEAR(result.After.Distortion, 6.0, 1e-2);
  EXPECT_LT(result.After.MeanDistance, 2e-3);
}

TEST(VolumeRegistration, RefusesWhatItCannotUse)
{
  const shape::Mesh ball = shapetest::Icosphere(1);
  shape::VolumeRegistrationOptions options;
  options.DistortionWeight = 0.0;
  EXPECT_THROW(shape::RegisterVolume(ball, ball, options), shape::InvalidInput);
  options.DistortionWeight = 1e-5;
  options.MaximumIterations = 0;
  EXPECT_THROW(shape::RegisterVolume(ball, ball, options), shape::InvalidInput);
  const shape::Mesh flat{ Eigen::MatrixXd::Zero(3, 3), Eigen::RowVector3i(0, 1, 2) };
  EXPECT_THROW(shape::RegisterVolume(ball, flat), shape::InvalidInput);
  EXPECT_THROW(shape::RegisterVolume(shapetest::FlatDisk(3), ball), shape::InvalidInput);
}

TEST(VolumeRegistration, CanBeAborted)
{
  int reports = 0;
  const shape::Progress progress([&](double) { return ++reports < 20; });
  EXPECT_THROW(
    shape::RegisterVolume(shapetest::Icosphere(2), DentedBall(2), {}, progress), shape::Aborted);
}
