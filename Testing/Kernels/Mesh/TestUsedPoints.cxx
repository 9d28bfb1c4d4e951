#include "Mesh/UsedPoints.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <numeric>

TEST(UsedPoints, AreThoseOfTheTrianglesAndNumberedInOrder)
{
  Eigen::MatrixXi triangles(2, 3);
  triangles << 7, 2, 5, 2, 7, 9;
  const std::vector<int> used = shape::FindUsedPoints(triangles, 12);
  EXPECT_EQ(used, (std::vector<int>{ 2, 5, 7, 9 }));
  EXPECT_EQ(shape::InvertIndices(used, 12)[9], 3);
  EXPECT_EQ(shape::InvertIndices(used, 12)[8], -1);
  Eigen::MatrixXi renumbered(2, 3);
  renumbered << 2, 0, 1, 0, 2, 3;
  EXPECT_EQ(shape::RenumberPoints(triangles, used, 12), renumbered);
}

TEST(UsedPoints, SplitAndJoinedAgainASurfaceEnclosesTheSame)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  std::vector<int> rows(ball.Triangles.rows());
  std::iota(rows.begin(), rows.end(), 0);
  const std::vector<int> first(rows.begin(), rows.begin() + 100),
    others(rows.begin() + 100, rows.end());
  const shape::Mesh part = shape::ExtractTriangles(ball, first);
  EXPECT_LT(part.Points.rows(), ball.Points.rows());
  const shape::Mesh both = shape::JoinMeshes({ part, shape::ExtractTriangles(ball, others) });
  EXPECT_NEAR(shape::ComputeEnclosedVolume(both), shape::ComputeEnclosedVolume(ball), 1e-13);
}
