#include "Quality/ScaledJacobian.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using Corners = Eigen::Matrix<double, 8, 3>;

Corners Box()
{
  Corners corners;
  corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  return corners;
}

} // namespace

TEST(ScaledJacobian, IsOneForBoxesAndTheSineOfTheAngleForShearedOnes)
{
  const Corners box = Box() * Eigen::Vector3d(2.0, 0.1, 30.0).asDiagonal();
  EXPECT_NEAR(shape::ComputeScaledJacobian(box), 1.0, 1e-15);
  for (const double angle : { 0.1, 1.0, 2.5 })
  {
    Corners sheared = Box();
    sheared.col(0) += sheared.col(2) * std::cos(angle);
    sheared.col(2) *= std::sin(angle);
    EXPECT_NEAR(shape::ComputeScaledJacobian(sheared), std::sin(angle), 1e-14);
    sheared.col(1) *= -1.0;
    EXPECT_NEAR(shape::ComputeScaledJacobian(sheared), -std::sin(angle), 1e-14);
  }
}

TEST(ScaledJacobian, IsThatOfTheWorstCornerAndKeptBySimilarities)
{
  Corners corners = Box();
  corners.row(6) << 0.4, 0.4, 1.0; // inside the triangle of its top's other corners
  const double value = shape::ComputeScaledJacobian(corners);
  const Eigen::RowVector3d p = corners.row(6);
  const Eigen::RowVector3d a = corners.row(5) - p, b = corners.row(7) - p, c = corners.row(2) - p;
  EXPECT_NEAR(value, a.dot(b.cross(c)) / (a.norm() * b.norm() * c.norm()), 1e-15);
  EXPECT_LT(value, 0.0);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Corners moved = (1e3 * corners * turn.transpose()).rowwise() + Eigen::RowVector3d(5, 6, 7);
  EXPECT_NEAR(shape::ComputeScaledJacobian(moved), value, 1e-11);
}

TEST(ScaledJacobian, CollapsedEdgesAreTheWorstThereIs)
{
  shape::HexMesh mesh{ Box(), Eigen::MatrixXi(2, 8) };
  mesh.Hexahedra << 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 1, 3, 4, 5, 6, 7;
  const Eigen::VectorXd values = shape::ComputeScaledJacobians(mesh);
  EXPECT_NEAR(values(0), 1.0, 1e-15);
  EXPECT_EQ(values(1), -1.0);
}

TEST(ScaledJacobian, TheLeastAwayFromPointsIsThatOfHexahedraWithoutThem)
{
  shape::HexMesh mesh{ Eigen::MatrixXd(16, 3), Eigen::MatrixXi(2, 8) };
  mesh.Points << Box(), Box();
  mesh.Points.row(14) << 0.4, 0.4, 1.0;
  mesh.Hexahedra << 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15;
  EXPECT_LT(shape::FindMinimumScaledJacobianAwayFrom({ 3 }, mesh), 0.0);
  EXPECT_NEAR(shape::FindMinimumScaledJacobianAwayFrom({ 8 }, mesh), 1.0, 1e-15);
  EXPECT_EQ(shape::FindMinimumScaledJacobianAwayFrom({ 0, 8 }, mesh), 1.0);
}

TEST(ScaledJacobian, PointsOfBadHexahedraAreMarkedWhereThereAreSuch)
{
  shape::HexMesh mesh{ Eigen::MatrixXd(16, 3), Eigen::MatrixXi(2, 8) };
  mesh.Points << Box(), Box();
  mesh.Hexahedra << 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15;
  EXPECT_TRUE(shape::MarkPointsOfBadHexahedra(mesh, 0.99).empty());
  mesh.Points.row(14) << 0.4, 0.4, 1.0;
  std::vector<char> wanted(16, 0);
  std::fill(wanted.begin() + 8, wanted.end(), 1);
  EXPECT_EQ(shape::MarkPointsOfBadHexahedra(mesh, 0.99), wanted);
}
