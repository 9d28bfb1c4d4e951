// Facts checked: cut triangles cover what they are parts of, facing the same way, with no edge left
// that was to be cut; a fan's chords are found, and no side of its loop.

#include "Mesh/EdgeMidpoints.h"

#include "Mesh/Topology.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{

TEST(EdgeMidpoints, PartsCoverTheTriangles)
{
  const shape::Mesh disk = shapetest::FlatDisk(3);
  const auto points = static_cast<int>(disk.Points.rows());
  // All three edges of one triangle, and one of another.
  std::vector<std::array<int, 2>> edges;
  for (const auto [a, b] : { std::array<int, 2>{ 0, 1 }, { 1, 2 }, { 0, 2 }, { 4, 5 } })
  {
    edges.push_back({ a, b });
  }
  const shape::CutTriangles cut = shape::SplitEdges(disk.Triangles, edges, points);
  EXPECT_EQ(cut.Midpoints, edges);
  shape::Mesh parts{ Eigen::MatrixXd(points + 4, 3), cut.Triangles };
  parts.Points.topRows(points) = disk.Points;
  for (int i = 0; i < 4; ++i)
  {
    parts.Points.row(points + i) =
      0.5 * (disk.Points.row(edges[i][0]) + disk.Points.row(edges[i][1]));
  }
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(disk.Triangles.rows());
  const Eigen::VectorXd small = shape::ComputeAreaVectors(parts).col(2);
  EXPECT_GT(small.minCoeff(), 0.0);
  for (Eigen::Index t = 0; t < small.size(); ++t)
  {
    areas(cut.Original[t]) += small(t);
  }
  EXPECT_TRUE(std::is_sorted(cut.Original.begin(), cut.Original.end()));
  EXPECT_LT((areas - shape::ComputeAreaVectors(disk).col(2)).cwiseAbs().maxCoeff(), 1e-15);
  const shape::Topology topology = shape::ComputeTopology(parts);
  EXPECT_EQ(topology.EulerNumber, 1);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
}

TEST(EdgeMidpoints, ChordsOfALoop)
{
  // A fan around corner 0 of a hexagon: chords 0-2, 0-3, 0-4.
  Eigen::MatrixXi fan(4, 3);
  fan << 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5;
  std::vector<int> loop(6);
  std::iota(loop.begin(), loop.end(), 0);
  const std::vector<std::array<int, 2>> chords = { { 0, 2 }, { 0, 3 }, { 0, 4 } };
  EXPECT_EQ(shape::FindLoopChords(fan, loop), chords);
  const shape::CutTriangles cut = shape::SplitEdges(fan, chords, 6);
  EXPECT_TRUE(shape::FindLoopChords(cut.Triangles, loop).empty());
  EXPECT_EQ(cut.Triangles.rows(), 10);
  EXPECT_TRUE(shape::FindLoopChords(shapetest::FlatDisk(2).Triangles, { 0 }).empty());
}

} // namespace
