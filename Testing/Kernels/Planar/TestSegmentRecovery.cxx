// Facts checked: segments become edges by flips alone, and what they do to the other edges is the
// constrained Delaunay triangulation, whatever their order; a segment through points of a grid has
// as many edges as the greatest common divisor says, and each knows what runs along it; k chords
// cross at k (k - 1) / 2 points, or at one; crossings that may not be are named.

#include "Planar/Private/SegmentRecovery.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Support/RandomPoints.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using shape::PlanarTriangles;
using Edge = std::pair<int, int>;

/// The Delaunay triangulation; the first three points are not on one line.
PlanarTriangles Triangulated(const Eigen::MatrixXd& points)
{
  PlanarTriangles plane(points, Eigen::Matrix2d::Identity());
  plane.Start(0, 1, 2);
  for (int i = 3; i < static_cast<int>(points.rows()); ++i)
  {
    plane.Insert(i);
  }
  return plane;
}

std::set<Edge> EdgesOf(const PlanarTriangles& plane)
{
  std::set<Edge> edges;
  for (int side = 0; side < plane.Sides(); ++side)
  {
    const Edge edge = std::minmax(plane.Begin(side), plane.End(side));
    if (edge.first != PlanarTriangles::Far)
    {
      edges.insert(edge);
    }
  }
  return edges;
}

/// That it is a triangulation of a convex hull whose free edges are locally Delaunay.
void ExpectDelaunay(const PlanarTriangles& plane)
{
  int triangles = 0, wrong = 0;
  for (int t = 0; t < plane.Sides() / 3; ++t)
  {
    if (plane.IsFar(t))
    {
      continue;
    }
    ++triangles;
    wrong += plane.Turn(plane.Begin(3 * t), plane.Begin(3 * t + 1), plane.Begin(3 * t + 2)) <= 0;
    for (int side = 3 * t; side < 3 * t + 3; ++side)
    {
      const int beyond = plane.Apex(plane.Twin(side));
      wrong += plane.Begin(side) != plane.End(plane.Twin(side));
      if (beyond != PlanarTriangles::Far && plane.Mark(side).Group < 0)
      {
        wrong += shape::EvaluateInCircle(plane.Position(plane.Begin(side)),
                   plane.Position(plane.End(side)), plane.Position(plane.Apex(side)),
                   plane.Position(beyond)) > 0;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(plane.Points() - static_cast<int>(EdgesOf(plane).size()) + triangles, 1);
}

/// The sides of finite edges that a segment runs along.
std::vector<int> SidesOf(
  const PlanarTriangles& plane, const shape::SegmentRecovery& recovery, int segment)
{
  std::vector<int> sides;
  for (int side = 0; side < plane.Sides(); ++side)
  {
    const int mark = plane.Mark(side).Group;
    if (mark >= 0 && plane.Begin(side) < plane.End(side))
    {
      const std::vector<int>& group = recovery.Group(mark);
      EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
      if (std::binary_search(group.begin(), group.end(), segment))
      {
        sides.push_back(side);
      }
    }
  }
  return sides;
}

TEST(SegmentRecovery, OneTriangulationWhateverTheOrder)
{
  // Segments side by side from left to right: none crosses another one, but each much else.
  const Eigen::MatrixXd points = shapetest::RandomPointsInSquare(300, 4);
  std::vector<int> order(points.rows());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return points(a, 0) < points(b, 0); });
  std::vector<Edge> segments;
  for (std::size_t i = 0; i + 20 < order.size(); i += 20)
  {
    segments.emplace_back(order[i], order[i + 20]);
  }
  Eigen::MatrixXd turned(points.rows(), 2); // by a right angle: exactly
  turned << -points.col(1), points.col(0);
  const auto recovered = [&](const Eigen::MatrixXd& positions, bool isTurnedAround)
  {
    PlanarTriangles plane = Triangulated(positions);
    const int sides = plane.Sides();
    shape::SegmentRecovery recovery(plane, false, static_cast<Eigen::Index>(segments.size()));
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const std::size_t at = isTurnedAround ? segments.size() - 1 - i : i;
      const auto [begin, end] = segments[at];
      recovery.Recover(
        isTurnedAround ? end : begin, isTurnedAround ? begin : end, static_cast<int>(at), 0);
    }
    ExpectDelaunay(plane);
    EXPECT_EQ(plane.Sides(), sides);
    EXPECT_EQ(plane.Points(), static_cast<int>(positions.rows()));
    return EdgesOf(plane);
  };
  const std::set<Edge> edges = recovered(points, false), before = EdgesOf(Triangulated(points));
  int made = 0;
  for (const auto& [begin, end] : segments)
  {
    EXPECT_EQ(edges.count(std::minmax(begin, end)), 1U);
    made += before.count(std::minmax(begin, end)) == 0;
  }
  EXPECT_GT(made, 10);
  EXPECT_EQ(recovered(points, true), edges);
  EXPECT_EQ(recovered(turned, false), edges);
}

TEST(SegmentRecovery, ThroughPointsOfAGrid)
{
  // From one corner to every point. Every other one backwards; every third one is no outline.
  constexpr int side = 9;
  Eigen::MatrixXd points(side * side, 2);
  for (int i = 0; i < side * side; ++i)
  {
    points.row(i) << i % side, i / side;
  }
  points.row(2).swap(points.row(side)); // the first three are not on one line
  PlanarTriangles plane = Triangulated(points);
  shape::SegmentRecovery recovery(plane, false, side * side - 1);
  const auto windingOf = [](int i) { return i % 3 == 0 ? 0 : 1; };
  for (int i = 1; i < side * side; ++i)
  {
    recovery.Recover(i % 2 == 0 ? 0 : i, i % 2 == 0 ? i : 0, i, windingOf(i));
  }
  ExpectDelaunay(plane);
  EXPECT_EQ(plane.Points(), side * side);
  for (int i = 1; i < side * side; ++i)
  {
    const Eigen::RowVector2i to = points.row(i).cast<int>();
    EXPECT_EQ(static_cast<int>(SidesOf(plane, recovery, i).size()), std::gcd(to(0), to(1))) << to;
  }
  int marked = 0;
  for (int at = 0; at < plane.Sides(); ++at)
  {
    const int end = plane.End(at), begin = plane.Begin(at);
    if (plane.Mark(at).Group < 0 || plane.Position(begin).sum() > plane.Position(end).sum())
    {
      continue;
    }
    ++marked; // outwards: of all segments that reach as far in this direction
    std::vector<int> along;
    int winding = 0;
    for (int i = 1; i < side * side; ++i)
    {
      if (plane.Turn(0, end, i) == 0 && points.row(i).sum() >= points.row(end).sum())
      {
        along.push_back(i);
        winding += i % 2 == 0 ? windingOf(i) : -windingOf(i);
      }
    }
    EXPECT_EQ(recovery.Group(plane.Mark(at).Group), along);
    EXPECT_EQ(plane.Mark(at).Winding, winding);
    EXPECT_EQ(plane.Mark(plane.Twin(at)).Winding, -winding);
  }
  EXPECT_EQ(marked, side * side - 1);
}

/// Chords of a circle, each of which crosses every other one: from point i to point i + count.
Eigen::MatrixXd ChordEnds(int count)
{
  const Eigen::MatrixXd shares = shapetest::RandomPointsInSquare(2 * count, 8);
  Eigen::MatrixXd points(2 * count, 2);
  for (int i = 0; i < 2 * count; ++i)
  {
    const double angle = M_PI * (i + 0.8 * shares(i, 0)) / count;
    points.row(i) << std::cos(angle), std::sin(angle);
  }
  return points;
}

TEST(SegmentRecovery, ChordsCrossPairByPair)
{
  constexpr int count = 24;
  PlanarTriangles plane = Triangulated(ChordEnds(count));
  shape::SegmentRecovery recovery(plane, true, count);
  for (int i = 0; i < count; ++i)
  {
    recovery.Recover(i, i + count, i, 1);
  }
  ExpectDelaunay(plane);
  EXPECT_EQ(plane.Points(), 2 * count + count * (count - 1) / 2);
  for (int i = 0; i < count; ++i)
  {
    const Eigen::RowVector2d begin = plane.Position(i), end = plane.Position(i + count);
    const Eigen::RowVector2d way = (end - begin).normalized();
    double length = 0.0;
    const std::vector<int> sides = SidesOf(plane, recovery, i);
    EXPECT_EQ(sides.size(), static_cast<std::size_t>(count));
    for (const int side : sides)
    {
      const Eigen::RowVector2d from = plane.Position(plane.Begin(side));
      const Eigen::RowVector2d step = plane.Position(plane.End(side)) - from;
      EXPECT_LT(std::abs(way(0) * (from - begin)(1) - way(1) * (from - begin)(0)), 1e-14);
      EXPECT_EQ(plane.Mark(side).Winding, step.dot(way) > 0.0 ? 1 : -1);
      length += step.norm();
    }
    EXPECT_NEAR(length, (end - begin).norm(), 1e-13);
  }
  // All through one point: there is one crossing, and it is exact.
  Eigen::MatrixXd star(10, 2);
  star << 4, 0, 3, 1, 2, 7, -5, 8, -6, 2, -4, 0, -3, -1, -2, -7, 5, -8, 6, -2;
  PlanarTriangles through = Triangulated(star);
  shape::SegmentRecovery all(through, true, 5);
  for (int i = 0; i < 5; ++i)
  {
    all.Recover(i, i + 5, i, 0);
    EXPECT_EQ(SidesOf(through, all, i).size(), i == 0 ? 1U : 2U);
  }
  EXPECT_EQ(through.Points(), 11);
  EXPECT_TRUE(through.Position(10).isZero(0.0));
  ExpectDelaunay(through);
}

TEST(SegmentRecovery, WhatCannotBe)
{
  Eigen::MatrixXd points(6, 2);
  points << 0, 0, 4, 4, 0, 4, 4, 0, 3, 3, 5, 2;
  PlanarTriangles plane = Triangulated(points);
  shape::SegmentRecovery recovery(plane, false, 3);
  recovery.Recover(0, 1, 7, 0);
  recovery.Recover(4, 5, 8, 0); // ends on the first one: that is no crossing
  EXPECT_EQ(SidesOf(plane, recovery, 7).size(), 2U);
  EXPECT_REFUSED(recovery.Recover(2, 3, 5, 0), "segments 5 and 7 cross at (2, 2)");
  // More crossings than the segments that were announced can have are taken for an endless loop.
  constexpr int count = 50;
  const auto recoverAnnounced = [&](int announced)
  {
    PlanarTriangles circle = Triangulated(ChordEnds(count));
    shape::SegmentRecovery many(circle, true, announced);
    for (int i = 0; i < count; ++i)
    {
      many.Recover(i, i + count, i, 0);
    }
  };
  EXPECT_NO_THROW(recoverAnnounced(count));
  EXPECT_THROW(recoverAnnounced(0), shape::SolveFailure);
}

} // namespace
