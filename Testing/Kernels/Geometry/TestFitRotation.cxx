// Facts checked: the nearest rotation is the polar factor or, if that mirrors, the rotation nearest
// in the Frobenius norm, by the decomposition and by the iteration; with an estimate it is the same
// for a matrix of full rank, takes the one direction of a matrix of rank one where that does with
// the least turn from the estimate, and is the estimate for none.

#include "Geometry/FitRotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d RandomRotation()
{
  return Eigen::Quaterniond::UnitRandom().toRotationMatrix();
}

void ExpectNearest(const std::function<Matrix3d(const Matrix3d&)>& fit)
{
  for (int i = 0; i < 100; ++i)
  {
    const Matrix3d rotation = RandomRotation(), axes = RandomRotation();
    EXPECT_LT((fit(rotation) - rotation).norm(), 1e-14);
    // A stretch along any axes after it, little or much, does not turn.
    const Vector3d stretches(std::pow(10.0, -0.05 * i), 1.0, 1.5);
    const Matrix3d stretched = axes * stretches.asDiagonal() * axes.transpose() * rotation;
    EXPECT_LT((fit(stretched) - rotation).norm(), 1e-9);

    const Matrix3d any = Matrix3d::Random(); // half of them mirror
    const Matrix3d nearest = fit(any);
    EXPECT_LT((nearest * nearest.transpose() - Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_GT(nearest.determinant(), 0.0);
    EXPECT_LT((fit(axes * any * rotation) - axes * nearest * rotation).norm(),
      1e-6); // ill-conditioned where two singular values cancel
    for (int other = 0; other < 100; ++other)
    {
      const Matrix3d near =
        Eigen::AngleAxisd(0.03 * other, Vector3d::Random().normalized()) * nearest;
      EXPECT_GE((any - near).norm(), (any - nearest).norm() - 1e-14);
    }
  }
}

TEST(FitRotation, OfAMatrixIsTheNearest)
{
  ExpectNearest([](const Matrix3d& matrix) { return shape::FitRotation(matrix); });
}

TEST(FitRotation, OfABlendIsTheNearest)
{
  ExpectNearest(shape::FitBlendedRotation);
}

TEST(FitRotation, AnEstimateDecidesWhatTheMatrixDoesNot)
{
  for (int i = 0; i < 100; ++i)
  {
    const Matrix3d estimate = RandomRotation(), any = Matrix3d::Random();
    EXPECT_EQ(shape::FitRotation(any, estimate), shape::FitRotation(any));
    EXPECT_EQ(shape::FitRotation(Matrix3d::Zero(), estimate), estimate);
    const Vector3d from = Vector3d::Random().normalized(), to = Vector3d::Random().normalized();
    const Matrix3d found = shape::FitRotation(2.0 * to * from.transpose(), estimate);
    EXPECT_LT((found * from - to).norm(), 1e-12);
    const Eigen::AngleAxisd turn(found * estimate.transpose());
    const double least = std::acos(std::min(1.0, std::max(-1.0, to.dot(estimate * from))));
    EXPECT_NEAR(turn.angle(), least, 1e-7);
  }
}

} // namespace
