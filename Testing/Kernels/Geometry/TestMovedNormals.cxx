#include "Geometry/MovedNormals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace
{

Eigen::MatrixXd RandomNormals(Eigen::Index count)
{
  std::mt19937 random(7);
  std::normal_distribution<double> of;
  Eigen::MatrixXd normals(count, 3);
  for (auto normal : normals.rowwise())
  {
    normal << of(random), of(random), of(random);
  }
  return normals.rowwise().normalized();
}

} // namespace

TEST(MovedNormals, RotateWithSimilarities)
{
  shape::Mesh torus = shapetest::Torus(1.0, 0.4, 30, 20);
  const Eigen::Index count = torus.Points.rows();
  torus.Points.conservativeResize(count + 1, 3);
  torus.Points.row(count) = torus.Points.row(0); // a copy, without triangles
  const Eigen::MatrixXd normals = RandomNormals(count + 1);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, -2, 0.4).normalized()).toRotationMatrix();
  for (const double scale : { 1.0, 0.01, 30.0 })
  {
    const Eigen::MatrixXd moved = scale * torus.Points * turn.transpose();
    const Eigen::MatrixXd carried =
      shape::MoveNormals(torus, moved, normals, { static_cast<std::size_t>(count) + 1, turn });
    EXPECT_LT((carried - normals * turn.transpose()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(MovedNormals, StayPerpendicularUnderStretching)
{
  // The normals of a sphere become those of an ellipsoid, by the inverse transpose of the stretch.
  // Its largest curvature is 2 / 0.7^2, so a normal changes by less than this times the length of
  // an edge of the ellipsoid, which is at most 2 edges of the sphere.
  const Eigen::Vector3d stretch(2.0, 1.0, 0.7);
  double last = 1.0;
  for (const int level : { 3, 4, 5 })
  {
    const shape::Mesh sphere = shapetest::Icosphere(level);
    const Eigen::MatrixXd moved = sphere.Points * stretch.asDiagonal();
    const Eigen::MatrixXd exact =
      (sphere.Points * stretch.cwiseInverse().asDiagonal()).rowwise().normalized();
    const Eigen::MatrixXd carried = shape::MoveNormals(sphere, moved, sphere.Points,
      { static_cast<std::size_t>(sphere.Points.rows()), Eigen::Matrix3d::Identity() });
    const double error = (carried - exact).rowwise().norm().maxCoeff();
    const double edge = 1.2 / (1 << level);
    EXPECT_LT(error, 2.0 / 0.49 * 2.0 * edge);
    EXPECT_LT(error, 0.6 * last); // at least of first order
    last = error;
  }
}
