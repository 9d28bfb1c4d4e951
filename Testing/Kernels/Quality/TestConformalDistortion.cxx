#include "Quality/ConformalDistortion.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

TEST(ConformalDistortion, IsOneForASimilarity)
{
  const shape::Mesh mesh = shapetest::Torus(1.0, 0.4, 30, 20);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Eigen::MatrixXd images = 3.0 * mesh.Points * turn.transpose();
  EXPECT_LT((shape::ComputeConformalDistortion(mesh, images).array() - 1.0).maxCoeff(), 1e-10);
}

TEST(ConformalDistortion, OfAStretchIsTheMeanOfItsRatioAndTheInverse)
{
  const shape::Mesh square{
    (Eigen::MatrixXd(4, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0).finished(),
    (Eigen::MatrixXi(2, 3) << 0, 1, 2, 0, 2, 3).finished()
  };
  Eigen::MatrixXd images = square.Points;
  images.col(0) *= 3.0;
  const Eigen::VectorXd distortion = shape::ComputeConformalDistortion(square, images);
  EXPECT_NEAR(distortion(0), (3.0 + 1.0 / 3.0) / 2.0, 1e-14);
  EXPECT_NEAR(distortion(1), (3.0 + 1.0 / 3.0) / 2.0, 1e-14);
}

TEST(ConformalDistortion, AFlattenedImageIsInfinitelyDistorted)
{
  const shape::Mesh mesh = shapetest::Icosphere(0);
  EXPECT_TRUE(
    std::isinf(shape::ComputeConformalDistortion(mesh, Eigen::MatrixXd::Zero(mesh.Points.rows(), 3))
                 .minCoeff()));
}
