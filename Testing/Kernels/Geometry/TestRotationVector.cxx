#include "Geometry/RotationVector.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(RotationVector, KeepsItsAxisAndTurnsByItsLength)
{
  const Vector3d axis = Vector3d(1.0, -2.0, 2.0) / 3.0, across = axis.unitOrthogonal();
  for (const double angle : { 1e-9, 0.3, 2.0, 3.0, 4.0 })
  {
    const Matrix3d rotation = shape::ToRotation(angle * axis);
    EXPECT_LT((rotation.transpose() * rotation - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((rotation * axis - axis).norm(), 1e-14);
    const Vector3d turned = std::cos(angle) * across + std::sin(angle) * axis.cross(across);
    EXPECT_LT((rotation * across - turned).norm(), 1e-14);
  }
}

TEST(RotationVector, OfNoLengthIsTheIdentity)
{
  EXPECT_EQ(shape::ToRotation(Vector3d::Zero()), Matrix3d::Identity());
}

} // namespace
