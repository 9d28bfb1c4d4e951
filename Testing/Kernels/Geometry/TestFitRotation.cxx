#include "Geometry/FitRotation.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace
{

Eigen::Matrix3d Rotation()
{
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

} // namespace

TEST(FitRotation, IsTheRotationOfAPolarDecomposition)
{
  const Eigen::Vector3d stretches(3.0, 1.5, 0.2);
  const Eigen::Matrix3d axes =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, 0.4, -1.0).normalized()).toRotationMatrix();
  const Eigen::Matrix3d stretch = axes * stretches.asDiagonal() * axes.transpose();
  EXPECT_LT((shape::FitRotation(Rotation() * stretch) - Rotation()).norm(), 1e-14);
}

TEST(FitRotation, ReflectsNothing)
{
  // Of the matrix with singular values 3, 2 and 1 that also reflects, it gives up the third.
  const Eigen::Matrix3d matrix = Rotation() * Eigen::Vector3d(3.0, 2.0, -1.0).asDiagonal();
  const Eigen::Matrix3d rotation = shape::FitRotation(matrix);
  EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
  EXPECT_LT((rotation - Rotation()).norm(), 1e-14);
}

TEST(FitRotation, RelatesVectorsThatWereRotated)
{
  const Eigen::MatrixXd from = Eigen::MatrixXd::Random(20, 3);
  const Eigen::MatrixXd to = from * Rotation().transpose();
  EXPECT_LT((shape::FitRotation(to.transpose() * from) - Rotation()).norm(), 1e-13);
}
