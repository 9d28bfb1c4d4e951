#include "Untangle/EllipticEnergy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <random>

TEST(EllipticEnergy, IsLeastForRotations)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  EXPECT_NEAR(shape::EllipticEnergy(turn, 1e-12).Value(), 1.0, 1e-12);
  EXPECT_LT(shape::EllipticEnergy(turn, 1e-12).Gradient().norm(), 1e-12);
  EXPECT_GT(shape::EllipticEnergy(1.1 * turn, 1e-12).Value(), 1.0);
}

TEST(EllipticEnergy, GradientIsTheDerivative)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double epsilon : { 1.0, 0.1 })
  {
    Eigen::Matrix3d j, step;
    for (int k = 0; k < 9; ++k)
    {
      j(k) = normal(random);
      step(k) = normal(random);
    }
    constexpr double h = 1e-5;
    const double slope = (shape::EllipticEnergy(j + h * step, epsilon).Value() -
                           shape::EllipticEnergy(j - h * step, epsilon).Value()) /
      (2.0 * h);
    const double stated = shape::EllipticEnergy(j, epsilon).Gradient().cwiseProduct(step).sum();
    EXPECT_NEAR(slope, stated, 1e-6 * std::abs(stated) + 1e-6);
  }
}

TEST(EllipticEnergy, EpsilonGivesTheChiAskedFor)
{
  for (const double determinant : { -3.0, -1e-6, 0.0, 0.01 })
  {
    const double epsilon = shape::EllipticEnergy::EpsilonFor(determinant, 0.02, 1e-10);
    EXPECT_NEAR(shape::EllipticEnergy::Chi(determinant, epsilon), 0.02, 1e-12);
  }
}
