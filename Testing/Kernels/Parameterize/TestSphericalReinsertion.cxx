#include "Parameterize/Private/SphericalReinsertion.h"
#include "Parameterize/Private/VertexRings.h"
#include "Parameterize/SphericalRelaxation.h"
#include "Parameterize/SphericalTriangles.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

bool OneToOne(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  return shape::FindFlippedTriangles(triangles, points).empty() &&
    shape::ComputeCoveringDegree(triangles, points) == 1;
}

double LargestAngleError(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  double largest = 0.0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Eigen::RowVector3d a = points.row(triangles(t, corner));
      const Eigen::RowVector3d u = points.row(triangles(t, (corner + 1) % 3)) - a;
      const Eigen::RowVector3d v = points.row(triangles(t, (corner + 2) % 3)) - a;
      largest = std::max(largest, std::abs(std::acos(u.dot(v) / u.norm() / v.norm()) - M_PI / 3));
    }
  }
  return largest;
}

} // namespace

TEST(SphericalTriangles, OnlyCertainlyPositiveTrianglesFaceOutwards)
{
  const Eigen::RowVector3d x(1.0, 0.0, 0.0);
  const Eigen::RowVector3d y(0.0, 1.0, 0.0);
  const Eigen::RowVector3d between = (x + y).normalized();
  EXPECT_FALSE(shape::IsFacingOutwards(x, between, y));
  EXPECT_FALSE(shape::IsFacingOutwards(y, between, x));
  EXPECT_FALSE(shape::IsFacingOutwards(x, x, y));
  // Edges of 1e-12 are far above the rounding of their differences.
  const Eigen::RowVector3d a = Eigen::RowVector3d(0.3, 0.5, 0.8).normalized();
  const Eigen::RowVector3d b = a + 1e-12 * Eigen::RowVector3d(1.0, -0.6, 0.0);
  const Eigen::RowVector3d c = a + 1e-12 * Eigen::RowVector3d(0.0, 1.6, -1.0);
  EXPECT_NE(shape::IsFacingOutwards(a, b, c), shape::IsFacingOutwards(a, c, b));
}

TEST(SphericalTriangles, TheIcospheresSolidAnglesCoverTheSphereOnce)
{
  const shape::Mesh sphere = shapetest::Icosphere(0);
  const Eigen::VectorXd angles = shape::ComputeSolidAngles(sphere.Triangles, sphere.Points);
  EXPECT_LT((angles.array() - M_PI / 5.0).abs().maxCoeff(), 1e-14);
  EXPECT_EQ(shape::ComputeCoveringDegree(sphere.Triangles, sphere.Points), 1);
  EXPECT_EQ(shape::ComputeCoveringDegree(sphere.Triangles, -sphere.Points), -1);
}

TEST(VertexRings, RestoreUndoesMerge)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::VertexRings rings(sphere.Triangles, 162);
  const shape::VertexRings before = rings;
  std::vector<int> order;
  std::vector<std::vector<int>> kept;
  for (int point = 0; point < 162 && rings.Remaining() > 4; ++point)
  {
    for (const int into : rings.Around(point))
    {
      if (rings.CanMerge(point, into))
      {
        order.push_back(point);
        kept.push_back(rings.Merge(point, into));
        break;
      }
    }
    // Euler: the degrees of a triangulated sphere of n points add up to 6 n - 12.
    int degrees = 0;
    for (int i = 0; i < 162; ++i)
    {
      degrees += static_cast<int>(rings.Around(i).size());
    }
    ASSERT_EQ(degrees, 6 * rings.Remaining() - 12);
  }
  EXPECT_LT(rings.Remaining(), 20);
  for (std::size_t i = order.size(); i-- > 0;)
  {
    rings.Restore(order[i], kept[i]);
  }
  for (int i = 0; i < 162; ++i)
  {
    EXPECT_EQ(rings.RingFrom(i, before.Around(i)[0]), before.Around(i));
  }
}

TEST(SphericalReinsertion, EndsFlipsAndLeavesTheRestAlone)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  Eigen::MatrixXd tangled = sphere.Points;
  for (const int t : { 100, 101, 102, 103, 3000 })
  {
    tangled.row(sphere.Triangles(t, 0)).swap(tangled.row(sphere.Triangles(t, 1)));
  }
  ASSERT_GT(shape::FindFlippedTriangles(sphere.Triangles, tangled).size(), 5u);
  const shape::SphericalReinsertionResult result =
    shape::ReinsertFlipped(sphere.Triangles, tangled, 100);
  ASSERT_TRUE(result.Reached);
  EXPECT_TRUE(OneToOne(sphere.Triangles, result.Points));
  EXPECT_LT(result.Reinserted.size(), 60u);
  std::vector<char> moved(sphere.Points.rows(), 0);
  for (const int i : result.Reinserted)
  {
    moved[i] = 1;
  }
  for (Eigen::Index i = 0; i < tangled.rows(); ++i)
  {
    EXPECT_TRUE(moved[i] || result.Points.row(i) == tangled.row(i)) << i;
  }
}

TEST(SphericalReinsertion, SaysWhereItWouldReachTooFar)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  EXPECT_FALSE(shape::ReinsertFlipped(sphere.Triangles, -sphere.Points, 642).Reached);
  Eigen::MatrixXd tangled = sphere.Points;
  tangled.row(0).swap(tangled.row(1));
  EXPECT_FALSE(shape::ReinsertFlipped(sphere.Triangles, tangled, 2).Reached);
}

TEST(SphericalReinsertion, MapsAnyTriangulatedSphereFromNothing)
{
  for (const int level : { 0, 2, 4 })
  {
    const shape::Mesh sphere = shapetest::Icosphere(level);
    const int n = static_cast<int>(sphere.Points.rows());
    const shape::SphericalReinsertionResult result = shape::ReinsertAll(sphere.Triangles, n, 1.0);
    EXPECT_TRUE(OneToOne(sphere.Triangles, result.Points));
    EXPECT_EQ(static_cast<int>(result.Reinserted.size()), n - 4);
    EXPECT_LT((result.Points.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14);
  }
}

TEST(SphericalRelaxation, BringsTheIcosahedronBackWithoutAFlip)
{
  const shape::Mesh sphere = shapetest::Icosphere(0);
  Eigen::MatrixXd points = shape::ReinsertAll(sphere.Triangles, 12, 0.0).Points;
  // Pull one point almost onto the side of its ring.
  points.row(3) = (0.02 * points.row(3) + points.row(9) + points.row(4)).normalized();
  ASSERT_TRUE(OneToOne(sphere.Triangles, points));
  ASSERT_GT(LargestAngleError(sphere.Triangles, points), 0.5);
  std::vector<int> all(12);
  std::iota(all.begin(), all.end(), 0);
  const Eigen::MatrixXd cotangents = Eigen::MatrixXd::Constant(20, 3, 1.0 / std::sqrt(3.0));
  shape::RelaxOnSphere(points, sphere.Triangles, cotangents, all, 500);
  EXPECT_TRUE(OneToOne(sphere.Triangles, points));
  EXPECT_LT(LargestAngleError(sphere.Triangles, points), 0.02);
}
