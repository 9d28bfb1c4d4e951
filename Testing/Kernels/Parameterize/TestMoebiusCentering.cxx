#include "Base/Errors.h"
#include "Parameterize/Private/MoebiusCentering.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace
{

Eigen::MatrixXd Inverted(Eigen::MatrixXd points, const Eigen::RowVector3d& center)
{
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d sum = points.row(i) + center;
    points.row(i) = (1.0 - center.squaredNorm()) / sum.squaredNorm() * sum + center;
  }
  return points;
}

} // namespace

TEST(MoebiusCentering, RecoversAShiftedSphereUpToRotation)
{
  const Eigen::MatrixXd points = shapetest::Icosphere(3).Points;
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.rows());
  const Eigen::MatrixXd shifted = Inverted(
    Inverted(points, Eigen::RowVector3d(0.5, 0.2, -0.3)), Eigen::RowVector3d(0.1, 0.9, 0.2));
  ASSERT_GT((weights.transpose() * shifted).norm() / points.rows(), 0.8);
  const shape::MoebiusCenteringResult result = shape::CenterOnSphere(shifted, weights);
  EXPECT_LT(result.MeanLength, 1e-12);
  // Up to rotation: all angles between points are those before.
  EXPECT_LT(
    (result.Points * result.Points.transpose() - points * points.transpose()).cwiseAbs().maxCoeff(),
    1e-10);
}

TEST(MoebiusCentering, IsAMoebiusTransformItKeepsCrossRatios)
{
  const Eigen::MatrixXd points = shapetest::Icosphere(2).Points;
  const Eigen::VectorXd weights =
    (points.col(0).array() + 1.3).square() + (points.col(1).array() > 0.5).cast<double>();
  const shape::MoebiusCenteringResult result = shape::CenterOnSphere(points, weights);
  EXPECT_LT((weights.transpose() * result.Points).norm() / weights.sum(), 1e-12);
  const auto crossRatio = [](const Eigen::MatrixXd& p, int i)
  {
    return (p.row(i) - p.row(i + 1)).norm() * (p.row(i + 2) - p.row(i + 3)).norm() /
      ((p.row(i) - p.row(i + 2)).norm() * (p.row(i + 1) - p.row(i + 3)).norm());
  };
  for (int i = 0; i + 3 < points.rows(); ++i)
  {
    EXPECT_NEAR(crossRatio(result.Points, i) / crossRatio(points, i), 1.0, 1e-11);
  }
  // Orientation is kept: a triangle of the sphere still faces outwards.
  const Eigen::MatrixXi triangles = shapetest::Icosphere(2).Triangles;
  const Eigen::RowVector3d a = result.Points.row(triangles(7, 0));
  EXPECT_GT(a.dot(Eigen::RowVector3d(result.Points.row(triangles(7, 1)))
                    .cross(Eigen::RowVector3d(result.Points.row(triangles(7, 2))))),
    0.0);
}

TEST(MoebiusCentering, RefusesWhatCannotBeCentred)
{
  const Eigen::MatrixXd points = shapetest::Icosphere(0).Points;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(12);
  weights(3) = 11.0;
  EXPECT_THROW(shape::CenterOnSphere(points, weights), shape::InvalidInput);
  weights(3) = 10.9;
  EXPECT_LT(shape::CenterOnSphere(points, weights).MeanLength, 1e-10);
  weights(3) = -1.0;
  EXPECT_THROW(shape::CenterOnSphere(points, weights), shape::InvalidInput);
  EXPECT_THROW(shape::CenterOnSphere(points, Eigen::VectorXd::Ones(11)), shape::InvalidInput);
  Eigen::MatrixXd origin = points;
  origin.row(5).setZero();
  EXPECT_THROW(shape::CenterOnSphere(origin, Eigen::VectorXd::Ones(12)), shape::InvalidInput);
}
