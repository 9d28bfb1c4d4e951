// Facts checked: the parts cover the triangle once, its outline gets no further point and chords
// run along edges; two chords cross where their ends alternate, at one point; the parts are
// Delaunay triangles of the triangle's own plane but for the chords, however it is moved, scaled
// and its corners are numbered, and there are as many where it has no area.

#include "Planar/TriangleSplit.h"

#include "Base/Errors.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Chords = std::vector<std::array<int, 2>>;
using Edge = std::pair<int, int>;

constexpr double Parts = 1 << 20; // coordinates are multiples of 1 / Parts: their sums are exact

/// So many points on each side, the corner before it among them, and so many inside.
Eigen::MatrixXd RandomPoints(int bySide, int inside, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<int>(1 + random() % (1 << 18)); };
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3 * bySide + inside, 3);
  for (int i = 0; i < 3 * bySide; ++i)
  {
    const int side = i / bySide, at = i % bySide;
    const double along = at == 0 ? 0.0 : (at - 0.5 + number() / Parts) / bySide;
    points(i, (side + 1) % 3) = std::round(along * Parts) / Parts;
    points(i, side) = 1.0 - points(i, (side + 1) % 3);
  }
  for (int i = 3 * bySide; i < points.rows(); ++i)
  {
    const double a = number() / Parts * 2.0, b = number() / Parts * 2.0;
    points.row(i) << 1.0 - a - b, a, b;
  }
  return points;
}

Eigen::MatrixXd Positions(const Eigen::MatrixXd& points, const shape::TriangleSplit& split)
{
  Eigen::MatrixXd positions(points.rows() + split.Added.rows(), 3);
  positions << points, split.Added;
  return positions;
}

/// Of each directed side the corner that it does not touch.
std::map<Edge, int> SidesOf(const Eigen::MatrixXi& triangles)
{
  std::map<Edge, int> sides;
  for (const auto& t : triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(sides.insert({ { t(k), t((k + 1) % 3) }, t((k + 2) % 3) }).second);
    }
  }
  return sides;
}

/// That the parts have the triangle's outline, and that chords are chains of their edges.
void ExpectChains(int outline, const Chords& chords, const shape::TriangleSplit& split)
{
  const std::map<Edge, int> sides = SidesOf(split.Triangles);
  int boundary = 0;
  for (const auto& [side, apex] : sides)
  {
    const bool isAlone = sides.count({ side.second, side.first }) == 0;
    EXPECT_EQ(isAlone, side.first < outline && side.second == (side.first + 1) % outline);
    boundary += isAlone ? 1 : 0;
  }
  EXPECT_EQ(boundary, outline);
  ASSERT_EQ(split.Chords.size(), chords.size());
  for (std::size_t i = 0; i < chords.size(); ++i)
  {
    const std::vector<int>& chain = split.Chords[i];
    EXPECT_EQ(chain.front(), chords[i][0]);
    EXPECT_EQ(chain.back(), chords[i][1]);
    for (std::size_t at = 0; at + 1 < chain.size(); ++at)
    {
      EXPECT_GT(
        sides.count({ chain[at], chain[at + 1] }) + sides.count({ chain[at + 1], chain[at] }), 0U);
    }
  }
}

/// The same, that the parts cover the triangle once, and that chords are straight.
void ExpectSplit(const Eigen::MatrixXd& points, int outline, const Chords& chords,
  const shape::TriangleSplit& split)
{
  ExpectChains(outline, chords, split);
  const Eigen::MatrixXd positions = Positions(points, split);
  EXPECT_LT((positions.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-15);
  EXPECT_TRUE(split.Added.size() == 0 || split.Added.minCoeff() > 0.0);
  double area = 0.0;
  for (const auto& t : split.Triangles.rowwise())
  {
    Eigen::Matrix3d corners;
    corners << positions.row(t(0)), positions.row(t(1)), positions.row(t(2));
    EXPECT_GT(corners.determinant(), 0.0);
    area += corners.determinant();
  }
  EXPECT_NEAR(area, 1.0, 1e-14);
  for (const std::vector<int>& chain : split.Chords)
  {
    double length = 0.0;
    for (std::size_t at = 0; at + 1 < chain.size(); ++at)
    {
      length += (positions.row(chain[at + 1]) - positions.row(chain[at])).norm();
    }
    EXPECT_NEAR(length, (positions.row(chain.back()) - positions.row(chain.front())).norm(), 1e-14);
  }
}

TEST(TriangleSplit, ChordsCrossWhereTheirEndsAlternate)
{
  constexpr int bySide = 16, outline = 3 * bySide;
  const Eigen::MatrixXd points = RandomPoints(bySide, 0, 1);
  std::mt19937 random(5);
  std::vector<int> ends(outline);
  std::iota(ends.begin(), ends.end(), 0);
  std::shuffle(ends.begin(), ends.end(), random);
  Chords chords;
  for (int i = 0; i < outline; i += 2)
  {
    if (ends[i] / bySide != ends[i + 1] / bySide && ends[i] % bySide * (ends[i + 1] % bySide) > 0)
    {
      chords.push_back({ ends[i], ends[i + 1] });
    }
  }
  const shape::TriangleSplit split =
    shape::SplitTriangle(Eigen::Matrix3d::Identity(), points, outline, chords);
  ExpectSplit(points, outline, chords, split);
  int crossings = 0;
  for (std::size_t i = 0; i < chords.size(); ++i)
  {
    const auto [low, high] = std::minmax(chords[i][0], chords[i][1]);
    const auto isBetween = [low = low, high = high](int end) { return low < end && end < high; };
    int own = 0;
    for (const auto& [begin, end] : chords)
    {
      own += isBetween(begin) != isBetween(end) && begin != chords[i][0] ? 1 : 0;
    }
    EXPECT_EQ(split.Chords[i].size(), 2U + own);
    crossings += own;
  }
  EXPECT_GT(crossings, 40);
  EXPECT_EQ(2 * split.Added.rows(), crossings);
}

TEST(TriangleSplit, ThreeChordsThroughOnePoint)
{
  // Lines on which one coordinate is a half, a quarter and a quarter.
  Eigen::MatrixXd points(9, 3);
  points << 1, 0, 0, 0.75, 0.25, 0, 0.25, 0.75, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0.25, 0.75, 0, 0, 1,
    0.25, 0, 0.75, 0.5, 0, 0.5;
  const Chords chords = { { 1, 5 }, { 2, 7 }, { 8, 4 } };
  const shape::TriangleSplit split =
    shape::SplitTriangle(Eigen::Matrix3d::Identity(), points, 9, chords);
  ExpectSplit(points, 9, chords, split);
  EXPECT_EQ(split.Added, Eigen::RowVector3d(0.25, 0.25, 0.5));
  // With this point given there is nothing to add, and chords may end there.
  points.conservativeResize(10, 3);
  points.row(9) << 0.25, 0.25, 0.5;
  const Chords more = { { 1, 5 }, { 9, 7 }, { 8, 4 } };
  const shape::TriangleSplit given =
    shape::SplitTriangle(Eigen::Matrix3d::Identity(), points, 9, more);
  ExpectSplit(points, 9, more, given);
  EXPECT_EQ(given.Added.rows(), 0);
  EXPECT_EQ(given.Chords[0], (std::vector<int>{ 1, 9, 5 }));
  EXPECT_EQ(given.Chords[1], (std::vector<int>{ 9, 7 }));
}

/// Free edges whose opposite angles are more than two right ones together.
int NotDelaunay(
  const Eigen::Matrix3d& corners, const Eigen::MatrixXd& points, const shape::TriangleSplit& split)
{
  std::set<Edge> fixed;
  for (const std::vector<int>& chain : split.Chords)
  {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      fixed.insert(std::minmax(chain[i], chain[i + 1]));
    }
  }
  const Eigen::MatrixXd positions = Positions(points, split) * corners;
  const auto angle = [&](const Edge& side, int apex)
  {
    const Eigen::RowVector3d a = positions.row(side.first) - positions.row(apex);
    const Eigen::RowVector3d b = positions.row(side.second) - positions.row(apex);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  const std::map<Edge, int> sides = SidesOf(split.Triangles);
  int wrong = 0;
  for (const auto& [side, apex] : sides)
  {
    const auto twin = sides.find({ side.second, side.first });
    wrong += twin != sides.end() && fixed.count(std::minmax(side.first, side.second)) == 0 &&
        angle(side, apex) + angle(side, twin->second) > M_PI + 1e-9
      ? 1
      : 0;
  }
  return wrong;
}

/// The triangles as sets of points with other numbers.
std::set<std::set<int>> Sets(const Eigen::MatrixXi& triangles, const std::vector<int>& numbers)
{
  std::set<std::set<int>> sets;
  for (const auto& t : triangles.rowwise())
  {
    sets.insert({ numbers[t(0)], numbers[t(1)], numbers[t(2)] });
  }
  return sets;
}

TEST(TriangleSplit, DelaunayInItsOwnPlane)
{
  constexpr int bySide = 6, outline = 3 * bySide;
  const Eigen::MatrixXd points = RandomPoints(bySide, 40, 2);
  const Chords chords = { { 2, 9 }, { 4, 16 }, { outline, outline + 1 } };
  Eigen::Matrix3d regular, needle, blunt;
  regular << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  needle << 0, 0, 0, 0.2, 3, 0, 0.1, 3, 0.3;
  blunt << 2, 1, 0, -2, 0.9, 0.1, 0.3, 1, -0.2;
  std::set<std::set<std::set<int>>> different;
  for (const Eigen::Matrix3d& corners : { regular, needle, blunt })
  {
    const shape::TriangleSplit split = shape::SplitTriangle(corners, points, outline, chords);
    ExpectSplit(points, outline, chords, split);
    EXPECT_EQ(NotDelaunay(corners, points, split), 0);
    std::vector<int> numbers(points.rows() + split.Added.rows());
    std::iota(numbers.begin(), numbers.end(), 0);
    const std::set<std::set<int>> own = Sets(split.Triangles, numbers);
    different.insert(own);

    const Eigen::Matrix3d moved =
      shapetest::Moved(corners, shapetest::SomeRotation(), 1e-4, { 3e-4, -2e-4, 1e-4 });
    EXPECT_EQ(Sets(shape::SplitTriangle(moved, points, outline, chords).Triangles, numbers), own);

    // From the next corner on: what was point i has another number.
    Eigen::Matrix3d turned;
    turned << corners.bottomRows(2), corners.row(0);
    std::rotate(numbers.begin(), numbers.begin() + bySide, numbers.begin() + outline);
    Eigen::MatrixXd positions =
      points(std::vector<int>(numbers.begin(), numbers.begin() + points.rows()), { 1, 2, 0 });
    const auto renumbered = [](int i)
    { return i < outline ? (i + outline - bySide) % outline : i; };
    Chords same;
    for (const auto& [begin, end] : chords)
    {
      same.push_back({ renumbered(begin), renumbered(end) });
    }
    EXPECT_EQ(Sets(shape::SplitTriangle(turned, positions, outline, same).Triangles, numbers), own);
  }
  EXPECT_EQ(different.size(), 3U);
}

TEST(TriangleSplit, WithoutArea)
{
  constexpr int outline = 12;
  const Eigen::MatrixXd points = RandomPoints(4, 20, 3);
  const Chords chords = { { 1, 6 }, { 2, 11 }, { 5, 10 } };
  Eigen::Matrix3d flat;
  flat << 0, 0, 0, 1, 2, 3, 3, 6, 9;
  for (const Eigen::Matrix3d& corners : { flat, Eigen::Matrix3d(Eigen::Matrix3d::Ones()) })
  {
    const shape::TriangleSplit split = shape::SplitTriangle(corners, points, outline, chords);
    ExpectSplit(points, outline, chords, split);
    // By Euler, for the points inside and those of the outline.
    EXPECT_EQ(split.Triangles.rows(), outline - 2 + 2 * (20 + split.Added.rows()));
  }
}

TEST(TriangleSplit, CrossingsTooNearToTheOutline)
{
  // Two chords whose ends change places on a side, few roundings apart: the crossing beside it is
  // rounded onto it, or beyond it. What does not fail has all its edges, and no place outside.
  int failures = 0;
  for (int i = 0; i < 400; ++i)
  {
    const double along = 0.25 + i / 1024.0, next = along + std::ldexp(3.0, -53);
    Eigen::MatrixXd points(7, 3);
    points << 1, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 1 - along, along, 0, 1 - next, next, 0, 0, 1, 0.125,
      0, 0.875;
    const Chords chords = { { 1, 4 }, { 6, 3 } };
    try
    {
      const shape::TriangleSplit split =
        shape::SplitTriangle(Eigen::Matrix3d::Identity(), points, 7, chords);
      ExpectChains(7, chords, split);
      EXPECT_TRUE(split.Added.size() == 0 || split.Added.minCoeff() >= 0.0);
    }
    catch (const shape::SolveFailure&)
    {
      ++failures;
    }
  }
  EXPECT_GT(failures, 0);
  EXPECT_LT(failures, 100);
}

} // namespace
