// Facts checked: a loop parts a surface into the triangles within it and the others, loops inside
// each other bound rings, two around a tube the part between; left and right, and less and more
// area, are each other's complement; how points and triangles are numbered, where a loop begins and
// sheets elsewhere do not count; what does not part the surface is refused.

#include "CutPaste/LoopSides.h"

#include "Base/Errors.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using shape::LoopSide;
using Sides = std::vector<char>;

/// Ring number `ring` of FlatDisk, counter-clockwise.
std::vector<int> RingOfDisk(int ring)
{
  std::vector<int> loop(6 * ring);
  std::iota(loop.begin(), loop.end(), 1 + 3 * ring * (ring - 1));
  return loop;
}

/// The triangles of FlatDisk(rings) between two of its rings: they are in the order of the rings.
Sides BetweenRings(int rings, int inner, int outer)
{
  Sides sides(6 * rings * rings, 0);
  std::fill(sides.begin() + 6 * inner * inner, sides.begin() + 6 * outer * outer, 1);
  return sides;
}

Sides Opposite(Sides sides)
{
  for (char& side : sides)
  {
    side = static_cast<char>(1 - side);
  }
  return sides;
}

Sides FirstTriangles(const shape::Mesh& surface, int count)
{
  Sides sides(surface.Triangles.rows(), 0);
  std::fill_n(sides.begin(), count, 1);
  return sides;
}

/// What a loop parts in each of the four ways: left, right, less, more.
void ExpectParts(const shape::Mesh& surface, const std::vector<std::vector<int>>& loops,
  const Sides& left, const Sides& smaller)
{
  EXPECT_EQ(shape::MarkTrianglesOnSide(surface, loops, LoopSide::Left), left);
  EXPECT_EQ(shape::MarkTrianglesOnSide(surface, loops, LoopSide::Right), Opposite(left));
  EXPECT_EQ(shape::MarkTrianglesOnSide(surface, loops, LoopSide::Smaller), smaller);
  EXPECT_EQ(shape::MarkTrianglesOnSide(surface, loops, LoopSide::Larger), Opposite(smaller));
}

/// The loop of a torus around its tube at column i, from below to above outside.
std::vector<int> AroundTube(int i, int across)
{
  std::vector<int> loop(across);
  std::iota(loop.begin(), loop.end(), i * across);
  return loop;
}

TEST(LoopSides, LoopsInsideEachOtherBoundRings)
{
  shape::Mesh disk = shapetest::FlatDisk(6);
  const Sides within = BetweenRings(6, 0, 3), ring = BetweenRings(6, 2, 4);
  ExpectParts(disk, { RingOfDisk(3) }, within, within);
  ExpectParts(disk, { RingOfDisk(5) }, BetweenRings(6, 0, 5), BetweenRings(6, 5, 6));
  // Of several the first tells left: the other one may run either way.
  std::vector<int> inner = RingOfDisk(2);
  ExpectParts(disk, { RingOfDisk(4), inner }, ring, ring);
  std::reverse(inner.begin(), inner.end());
  ExpectParts(disk, { RingOfDisk(4), inner }, ring, ring);
  // What two loops have in common parts nothing.
  ExpectParts(disk, { { 0, 1, 2 }, { 0, 2, 3 } }, FirstTriangles(disk, 2), FirstTriangles(disk, 2));
  // Areas count, not numbers of triangles.
  disk.Points.topRows(61) *= 1.2;
  ExpectParts(disk, { RingOfDisk(4) }, BetweenRings(6, 0, 4), BetweenRings(6, 4, 6));
}

TEST(LoopSides, WhereALoopBeginsAndHowThingsAreNumberedDoesNotCount)
{
  const shape::Mesh disk = shapetest::FlatDisk(6);
  const Sides within = BetweenRings(6, 0, 3);
  std::vector<int> loop = RingOfDisk(3);
  std::rotate(loop.begin(), loop.begin() + 7, loop.end());
  ExpectParts(disk, { loop }, within, within);
  std::reverse(loop.begin(), loop.end());
  ExpectParts(disk, { loop }, Opposite(within), within);

  std::vector<int> position(disk.Points.rows()), row(disk.Triangles.rows());
  std::iota(position.begin(), position.end(), 0);
  std::iota(row.begin(), row.end(), 0);
  std::mt19937 random(4);
  std::shuffle(position.begin(), position.end(), random);
  std::shuffle(row.begin(), row.end(), random);
  shape::Mesh other = disk;
  other.Points(position, Eigen::all) = disk.Points;
  Sides wanted(row.size());
  for (std::size_t t = 0; t < row.size(); ++t)
  {
    for (int k = 0; k < 3; ++k) // the corners in another order, too, of the same sense
    {
      other.Triangles(row[t], k) =
        position[disk.Triangles(static_cast<Eigen::Index>(t), (k + row[t]) % 3)];
    }
    wanted[row[t]] = within[t];
  }
  for (int& point : loop)
  {
    point = position[point];
  }
  ExpectParts(other, { loop }, Opposite(wanted), wanted);
}

TEST(LoopSides, TwoAroundATubeBoundThePartBetween)
{
  constexpr int across = 12;
  const shape::Mesh torus = shapetest::Torus(3.0, 1.0, 30, across);
  Sides between(torus.Triangles.rows(), 0);
  std::fill(between.begin() + 2 * 3 * across, between.begin() + 2 * 10 * across, 1);
  // Outside the loop goes up, the tube is followed to the left seen from above: left is behind.
  ExpectParts(torus, { AroundTube(3, across), AroundTube(10, across) }, Opposite(between), between);
}

TEST(LoopSides, OtherComponentsAreOnNeitherSideAndSheetsFollowTheirEdge)
{
  // Beside the disk another one with a loop of its own, a third one without, and a fin on an edge
  // within the first loop.
  const shape::Mesh disk = shapetest::FlatDisk(4);
  const auto points = static_cast<int>(disk.Points.rows());
  const Eigen::Index rows = disk.Triangles.rows();
  shape::Mesh all{ Eigen::MatrixXd(3 * points + 1, 3), Eigen::MatrixXi(3 * rows + 1, 3) };
  all.Points << disk.Points, disk.Points, disk.Points, Eigen::RowVector3d(0, 0, 0.1);
  all.Triangles << disk.Triangles, disk.Triangles.array() + points,
    disk.Triangles.array() + 2 * points, Eigen::RowVector3i(0, 1, 3 * points);
  std::vector<int> second = RingOfDisk(1);
  for (int& point : second)
  {
    point += points;
  }
  std::reverse(second.begin(), second.end());
  const Sides one = BetweenRings(4, 0, 2), other = BetweenRings(4, 0, 1);
  Sides inside = one;
  inside.insert(inside.end(), other.begin(), other.end());
  inside.resize(3 * rows, 0);
  inside.push_back(1);
  EXPECT_EQ(shape::MarkTrianglesOnSide(all, { RingOfDisk(2), second }, LoopSide::Smaller), inside);
  // Each component has its own left.
  const Sides outside = Opposite(other);
  std::copy(outside.begin(), outside.end(), inside.begin() + rows);
  EXPECT_EQ(shape::MarkTrianglesOnSide(all, { RingOfDisk(2), second }, LoopSide::Left), inside);
}

TEST(LoopSides, WhatPartsNothingIsRefusedWithTheReason)
{
  const shape::Mesh disk = shapetest::FlatDisk(4);
  constexpr int across = 12;
  const shape::Mesh torus = shapetest::Torus(3.0, 1.0, 30, across);
  const std::vector<int> one = AroundTube(3, across), other = AroundTube(10, across);
  const shape::Mesh both = shapetest::Joined({ torus, disk });
  std::vector<int> onDisk = RingOfDisk(2);
  for (int& point : onDisk)
  {
    point += static_cast<int>(torus.Points.rows());
  }
  for (const LoopSide side :
    { LoopSide::Smaller, LoopSide::Larger, LoopSide::Left, LoopSide::Right })
  {
    for (const std::vector<std::vector<int>>& loops : std::vector<std::vector<std::vector<int>>>{
           { one }, { onDisk, one }, // which parts the disk only
           { one, other, AroundTube(20, across) } })
    {
      EXPECT_REFUSED(shape::MarkTrianglesOnSide(both, loops, side), "around a handle");
    }
    EXPECT_NO_THROW(shape::MarkTrianglesOnSide(both, { onDisk, one, other }, side));
    EXPECT_REFUSED(shape::MarkTrianglesOnSide(disk, { RingOfDisk(4) }, side), "boundary");
    EXPECT_NO_THROW(shape::MarkTrianglesOnSide(disk, { RingOfDisk(4), RingOfDisk(2) }, side));
  }
}

} // namespace
