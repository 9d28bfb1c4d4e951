// Facts checked: a chord is outside where the corner that it cuts off turns away from what is
// filled, or lies on one line with it, seen along the normals, however the rim is moved, scaled and
// numbered, and never past eight sides; a flipped tip leaves a triangulation of the same outline
// without that chord, and stays where the other diagonal would not be inside or is taken.

#include "Fill/LoopCorners.h"
#include "Fill/Private/HoleDisk.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace
{

using Edge = std::array<int, 2>;

/// An edge, the lower number first.
Edge Between(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

shape::BoundaryLoop FlatLoop(const std::vector<Eigen::RowVector2d>& corners, double up = 1.0)
{
  shape::BoundaryLoop loop;
  loop.Points.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (Eigen::Index i = 0; i < loop.Points.rows(); ++i)
  {
    loop.Points.row(i) << corners[i], 0.0;
  }
  loop.Normals = Eigen::RowVector3d(0, 0, up).replicate(loop.Points.rows(), 1);
  return loop;
}

std::vector<Eigen::RowVector2d> RegularPolygon(int corners)
{
  std::vector<Eigen::RowVector2d> polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    polygon.emplace_back(std::cos(angle), std::sin(angle));
  }
  return polygon;
}

/// An L: corner 3 is reflex, corner 8 lies within a straight side.
std::vector<Eigen::RowVector2d> LShape()
{
  return { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0.5, 3.2 }, { 0, 3 }, { 0, 2 },
    { 0, 1 } };
}

/// All pairs that are outside, the lower number first.
std::set<Edge> Outside(const shape::BoundaryLoop& loop)
{
  const auto isOutside = shape::FindOuterChords(loop);
  const auto corners = static_cast<int>(loop.Points.rows());
  std::set<Edge> outside;
  for (int a = 0; a < corners; ++a)
  {
    for (int b = a + 1; b < corners; ++b)
    {
      EXPECT_EQ(isOutside(a, b), isOutside(b, a) || 2 * (b - a) == corners) << a << ' ' << b;
      if (isOutside(a, b))
      {
        outside.insert({ a, b });
      }
    }
  }
  return outside;
}

TEST(RimChords, OfAConvexRimNoChordIsOutsideUntilItsNormalsTurnOver)
{
  constexpr int corners = 23;
  EXPECT_TRUE(Outside(FlatLoop(RegularPolygon(corners))).empty());
  std::set<Edge> few; // with two to eight sides between
  for (int a = 0; a < corners; ++a)
  {
    for (int sides = 2; sides <= 8; ++sides)
    {
      few.insert(Between(a, (a + sides) % corners));
    }
  }
  EXPECT_EQ(Outside(FlatLoop(RegularPolygon(corners), -1.0)), few);
}

TEST(RimChords, AcrossAReflexCornerAndAlongALineTheyAreOutside)
{
  const shape::BoundaryLoop loop = FlatLoop(LShape());
  const std::set<Edge> outside = Outside(loop);
  for (const Edge& chord : { Edge{ 2, 4 }, { 0, 7 }, { 6, 8 } })
  {
    EXPECT_EQ(outside.count(chord), 1U) << chord[0] << ' ' << chord[1];
  }
  // Corners that are cut off inside, and sides.
  for (const Edge& chord : { Edge{ 0, 2 }, { 1, 3 }, { 4, 6 }, { 3, 8 }, { 3, 4 }, { 0, 1 } })
  {
    EXPECT_EQ(outside.count(chord), 0U) << chord[0] << ' ' << chord[1];
  }
  // However it lies in space, and whichever corner is the first.
  shape::BoundaryLoop moved{ shapetest::Moved(
                               loop.Points, shapetest::SomeRotation(), 1e-6, { 3e-6, -7e-6, 2e-6 }),
    loop.Normals * shapetest::SomeRotation().transpose() };
  EXPECT_EQ(Outside(moved), outside);
  const auto corners = static_cast<int>(loop.Points.rows());
  constexpr int first = 4;
  std::vector<Eigen::RowVector2d> turned = LShape();
  std::rotate(turned.begin(), turned.begin() + first, turned.end());
  std::set<Edge> renumbered;
  for (const auto& [a, b] : Outside(FlatLoop(turned)))
  {
    renumbered.insert(Between((a + first) % corners, (b + first) % corners));
  }
  EXPECT_EQ(renumbered, outside);
}

/// Which chords a triangulation has, each once.
std::set<Edge> EdgesOf(const Eigen::MatrixXi& triangles)
{
  std::set<Edge> edges;
  for (const auto row : triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(Between(row(k), row((k + 1) % 3)));
    }
  }
  return edges;
}

Eigen::VectorXd Areas(const shape::FlatDisk& disk)
{
  shape::Mesh mesh{ Eigen::MatrixXd::Zero(disk.Points.rows(), 3), disk.Triangles };
  mesh.Points.leftCols(2) = disk.Points;
  return 0.5 * shape::ComputeAreaVectors(mesh).col(2);
}

/// What flipping makes of a disk: it covers the same, counter-clockwise.
std::set<Edge> Flipped(shape::FlatDisk disk, int corners,
  const std::function<bool(int, int)>& isOutside, const std::function<bool(int, int)>& isTaken)
{
  const double area = Areas(disk).sum();
  shape::FlipTips(disk, corners, isOutside, isTaken);
  EXPECT_GT(Areas(disk).minCoeff(), 0.0);
  EXPECT_NEAR(Areas(disk).sum(), area, 1e-15);
  return EdgesOf(disk.Triangles);
}

std::set<Edge> Without(std::set<Edge> edges, const Edge& gone, const Edge& added)
{
  edges.erase(gone);
  edges.insert(added);
  return edges;
}

bool Always(int, int)
{
  return true;
}

/// A hexagon with the tip 0 cut off, the rest around a point inside.
shape::FlatDisk CutHexagon(const Eigen::RowVector2d& inside)
{
  shape::FlatDisk disk{ Eigen::MatrixXd(7, 2), Eigen::MatrixXi(6, 3) };
  const std::vector<Eigen::RowVector2d> corners = RegularPolygon(6);
  for (int i = 0; i < 6; ++i)
  {
    disk.Points.row(i) = corners[i];
  }
  disk.Points.row(6) = inside;
  disk.Triangles << 5, 0, 1, 5, 1, 6, 1, 2, 6, 2, 3, 6, 3, 4, 6, 4, 5, 6;
  return disk;
}

TEST(RimChords, ATipIsJoinedToThePointAcross)
{
  const shape::FlatDisk disk = CutHexagon({ 0.0, 0.0 });
  const std::set<Edge> before = EdgesOf(disk.Triangles);
  std::vector<Edge> asked;
  const auto isOutside = [&](int a, int b)
  {
    asked.push_back({ a, b });
    return true;
  };
  const auto isTaken = [](int, int) { return true; }; // between corners only
  EXPECT_EQ(Flipped(disk, 6, isOutside, isTaken), Without(before, { 1, 5 }, { 0, 6 }));
  EXPECT_EQ(asked, std::vector<Edge>({ { 5, 1 } }));
  EXPECT_EQ(Flipped(disk, 6, [](int, int) { return false; }, {}), before);
  // The point so near to the chord's other side that the diagonal would leave the hexagon: not so.
  EXPECT_EQ(Flipped(CutHexagon({ 0.45, 0.0 }), 6, Always, {}), Without(before, { 1, 5 }, { 0, 6 }));
}

TEST(RimChords, ATipStaysWhereTheOtherDiagonalIsTakenOrOutside)
{
  // A square and its diagonal: the other one joins corners, too.
  shape::FlatDisk square{ Eigen::MatrixXd(4, 2), Eigen::MatrixXi(2, 3) };
  square.Points << 0, 0, 1, 0, 1, 1, 0, 1;
  square.Triangles << 0, 1, 2, 0, 2, 3;
  const std::set<Edge> before = EdgesOf(square.Triangles);
  EXPECT_EQ(Flipped(square, 4, Always, {}), Without(before, { 0, 2 }, { 1, 3 }));
  const auto isTaken = [](int a, int b) { return Between(a, b) == Between(1, 3); };
  EXPECT_EQ(Flipped(square, 4, Always, isTaken), before);
  // A kite whose corner 0 is reflex, and one where it lies on the other diagonal.
  for (const double x : { 0.7, 0.5 })
  {
    square.Points.row(0) << x, x;
    EXPECT_EQ(Flipped(square, 4, Always, {}), before);
  }
}

TEST(RimChords, TrianglesThatTwoTipsShareAreFlippedOnce)
{
  shape::FlatDisk hexagon{ CutHexagon({ 0.0, 0.0 }).Points.topRows(6), Eigen::MatrixXi(4, 3) };
  hexagon.Triangles << 0, 1, 2, 2, 3, 4, 4, 5, 0, 0, 2, 4;
  const std::set<Edge> before = EdgesOf(hexagon.Triangles);
  const std::set<Edge> flipped = Flipped(hexagon, 6, Always, {});
  EXPECT_EQ(flipped.size(), before.size());
  EXPECT_EQ(flipped, Without(before, { 0, 2 }, { 1, 4 }));
}

} // namespace
