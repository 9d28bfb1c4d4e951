// Facts checked: what has grown is a disk, and no triangle could be added to it; a surface that is
// a disk is found whole, row by row; it is the one that trying out all rows each time gives.

#include "Mesh/DiskGrowth.h"

#include "Mesh/Topology.h"
#include "Support/HoleShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace
{

bool IsDisk(const shape::Mesh& surface, std::vector<int> rows)
{
  const shape::Topology found =
    shape::ComputeTopology({ surface.Points, surface.Triangles(rows, Eigen::all) });
  return found.EulerNumber == 1 && found.BoundaryLoops == 1 && found.Components == 1 &&
    found.NonManifoldEdges + found.NonManifoldPoints == 0;
}

TEST(DiskGrowth, ADiskIsFoundWhole)
{
  const shape::Mesh disk = shapetest::FlatDisk(8);
  const std::vector<int> rows = shape::GrowDisk(disk.Triangles, disk.Points.rows());
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(disk.Triangles.rows()));
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_TRUE(shape::GrowDisk(Eigen::MatrixXi(0, 3), 5).empty());
}

TEST(DiskGrowth, OthersAreCoveredAsFarAsADiskGoes)
{
  shape::Mesh tube = shapetest::FlatSquare(24, 0.2);
  // Rolled up around x: the points of two sides are one.
  for (int& corner : tube.Triangles.reshaped())
  {
    corner = corner % 25 + (corner / 25 % 24) * 25;
  }
  for (const shape::Mesh& surface :
    { shapetest::Icosphere(3), shapetest::Torus(1.0, 0.4, 30, 16), tube })
  {
    const std::vector<int> rows = shape::GrowDisk(surface.Triangles, surface.Points.rows());
    ASSERT_TRUE(IsDisk(surface, rows));
    EXPECT_EQ(rows.front(), 0);
    std::vector<bool> isIn(surface.Triangles.rows(), false);
    for (const int row : rows)
    {
      isIn[row] = true;
    }
    int missing = 0;
    for (int row = 0; row < static_cast<int>(isIn.size()); ++row)
    {
      if (!isIn[row])
      {
        ++missing;
        std::vector<int> more = rows;
        more.push_back(row);
        EXPECT_FALSE(IsDisk(surface, more)) << row;
      }
    }
    EXPECT_GT(missing, 0);
  }
}

/// The same by trying out every row anew after each that was added.
std::vector<int> GrownByTrial(const shape::Mesh& surface)
{
  std::vector<int> rows = { 0 };
  const auto joins = [&](int row)
  {
    std::vector<int> more = rows;
    more.push_back(row);
    return std::find(rows.begin(), rows.end(), row) == rows.end() && IsDisk(surface, more);
  };
  const auto count = static_cast<int>(surface.Triangles.rows());
  for (int row = 0; row < count; ++row)
  {
    if (joins(row))
    {
      rows.push_back(row);
      row = 0;
    }
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(DiskGrowth, EachTimeTheFirstThatJoins)
{
  const shape::Mesh sphere = shapetest::Icosphere(1), torus = shapetest::Torus(1.0, 0.4, 9, 6);
  const shape::Mesh ring = shapetest::Without(shapetest::FlatSquare(9, 0.0),
    [](const Eigen::RowVector3d& position) { return position.cwiseAbs().maxCoeff() < 0.4; });
  std::mt19937 random(6);
  for (shape::Mesh surface : { sphere, torus, ring })
  {
    std::vector<int> order(surface.Triangles.rows());
    std::iota(order.begin(), order.end(), 0);
    for (int round = 0; round < 3; ++round)
    {
      const std::vector<int> rows = shape::GrowDisk(surface.Triangles, surface.Points.rows());
      EXPECT_TRUE(IsDisk(surface, rows));
      EXPECT_EQ(rows, GrownByTrial(surface)) << round;
      std::shuffle(order.begin(), order.end(), random);
      surface.Triangles = Eigen::MatrixXi(surface.Triangles(order, Eigen::all));
    }
  }
}

} // namespace
