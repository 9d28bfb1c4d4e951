#include "Mesh/BoundaryLoops.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

shape::Mesh Without(shape::Mesh mesh, const std::vector<int>& triangles)
{
  int kept = 0;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (std::find(triangles.begin(), triangles.end(), t) == triangles.end())
    {
      mesh.Triangles.row(kept++) = mesh.Triangles.row(t);
    }
  }
  mesh.Triangles.conservativeResize(kept, 3);
  return mesh;
}

/// A strip of squares along x, from z = 0 to 1, with the points of each square its own.
shape::Mesh SeparateSquares(int count)
{
  shape::Mesh mesh{ Eigen::MatrixXd(4 * count, 3), Eigen::MatrixXi(2 * count, 3) };
  for (int i = 0; i < count; ++i)
  {
    mesh.Points.middleRows(4 * i, 4) << i, 0, 0, i + 1, 0, 0, i + 1, 0, 1, i, 0, 1;
    mesh.Triangles.middleRows(2 * i, 2) << 4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3;
  }
  return mesh;
}

} // namespace

TEST(BorderLoops, OfAManifoldAreItsOpenLoops)
{
  shape::Mesh sphere = Without(shapetest::Icosphere(3), { 5, 6, 7, 300, 900 });
  const shape::BoundaryLoops boundary = shape::FindBoundaryLoops(sphere);
  EXPECT_EQ(boundary.Loops, shape::FindManifoldBoundaryLoops(sphere));
  EXPECT_EQ(boundary.UnclosedSides, 0);
  EXPECT_TRUE(shape::FindBoundaryLoops(shapetest::Icosphere(1)).Loops.empty());
}

TEST(BorderLoops, ThatTouchAtAPointAreSplit)
{
  // Two opposite triangles of the fan around a point are missing.
  const shape::Mesh disk = shapetest::FlatDisk(2);
  std::vector<int> fan;
  for (int t = 0; t < disk.Triangles.rows(); ++t)
  {
    if ((disk.Triangles.row(t).array() == 0).any())
    {
      fan.push_back(t);
    }
  }
  ASSERT_EQ(fan.size(), 6u);
  // In the order around the point.
  std::sort(fan.begin(), fan.end(),
    [&](int a, int b)
    {
      const Eigen::RowVector3d p = shape::GetCorners(disk, a).colwise().mean();
      const Eigen::RowVector3d q = shape::GetCorners(disk, b).colwise().mean();
      return std::atan2(p.y(), p.x()) < std::atan2(q.y(), q.x());
    });
  const shape::Mesh open = Without(disk, { fan[0], fan[3] });
  ASSERT_EQ(shape::ComputeTopology(open).NonManifoldPoints, 1);
  const shape::BoundaryLoops boundary = shape::FindBoundaryLoops(open);
  ASSERT_EQ(boundary.Loops.size(), 3u);
  EXPECT_EQ(boundary.Loops[0].size(), 12u);
  for (const int hole : { 1, 2 })
  {
    std::vector<int> corners = boundary.Loops[hole];
    ASSERT_EQ(corners.size(), 3u);
    // The loop runs against the triangle that is missing.
    const Eigen::RowVector3i missing = disk.Triangles.row(fan[hole == 1 ? 0 : 3]);
    const Eigen::RowVector3i other = disk.Triangles.row(fan[hole == 1 ? 3 : 0]);
    std::vector<int> wanted(missing.begin(), missing.end()), otherwise(other.begin(), other.end());
    for (std::vector<int>* list : { &corners, &wanted, &otherwise })
    {
      std::sort(list->begin(), list->end());
    }
    EXPECT_TRUE(corners == wanted || corners == otherwise);
  }
  EXPECT_EQ(boundary.UnclosedSides, 0);
}

TEST(BorderLoops, ASeamOfDoubledPointsIsNoBorder)
{
  const shape::BoundaryLoops boundary = shape::FindBoundaryLoops(SeparateSquares(3));
  ASSERT_EQ(boundary.Loops.size(), 1u);
  // Eight corners of the strip, of which those at the two seams have two points each.
  EXPECT_EQ(boundary.Loops.front().size(), 12u);
  EXPECT_EQ(boundary.UnclosedSides, 0);
}

TEST(BorderLoops, AnEdgeOfThreeTrianglesIsNone)
{
  shape::Mesh mesh{ Eigen::MatrixXd(5, 3), Eigen::MatrixXi(3, 3) };
  mesh.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
  mesh.Triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  const shape::BoundaryLoops boundary = shape::FindBoundaryLoops(mesh);
  // The six free sides: what of them closes, and what does not, is all there.
  std::size_t sides = boundary.UnclosedSides;
  for (const std::vector<int>& loop : boundary.Loops)
  {
    EXPECT_GE(loop.size(), 3u);
    sides += loop.size();
  }
  EXPECT_EQ(sides, 6u);
}

TEST(BorderLoops, NamesWhatIsWrong)
{
  shape::Mesh mesh = shapetest::Icosphere(0);
  mesh.Triangles(3, 1) = 12;
  EXPECT_THROW(shape::FindBoundaryLoops(mesh), shape::InvalidInput);
}
