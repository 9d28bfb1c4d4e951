// Facts checked: a place on an edge or at a corner is the same one in each triangle there; paths
// are straight in a flat convex region, turn at its reflex corners only, and are helices on a tube,
// also more than once around it; on a surface that is convex at every point none turns; each round
// of LeadAround shortens, and the way back is as long.

#include "Geodesics/TriangleStrip.h"

#include "Mesh/HalfEdges.h"
#include "Support/DeformShapes.h"
#include "Support/HoleShapes.h"
#include "Support/SurfacePathChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using shapetest::ExpectPath;
using shapetest::PositionOf;

/// The place at a corner of a triangle.
shape::SurfacePoint AtCorner(const shape::Mesh& mesh, int triangle, int point)
{
  return { triangle, (mesh.Triangles.row(triangle).array() == point).cast<double>() };
}

/// The sides that lead from a triangle to another one through the fewest, whatever their shapes.
std::vector<int> SidesBetween(const std::vector<int>& twins, int first, int last)
{
  std::vector<int> before(twins.size() / 3, -2), reached = { first };
  before[first] = -1;
  for (std::size_t i = 0; before[last] == -2; ++i)
  {
    for (int side = 3 * reached.at(i); side < 3 * reached[i] + 3; ++side)
    {
      if (twins[side] >= 0 && before[twins[side] / 3] == -2)
      {
        before[twins[side] / 3] = side;
        reached.push_back(twins[side] / 3);
      }
    }
  }
  std::vector<int> sides;
  for (int triangle = last; before[triangle] >= 0; triangle = sides.back() / 3)
  {
    sides.push_back(before[triangle]);
  }
  std::reverse(sides.begin(), sides.end());
  return sides;
}

/// The same way back.
std::vector<int> Back(const std::vector<int>& twins, std::vector<int> sides)
{
  std::reverse(sides.begin(), sides.end());
  std::transform(sides.begin(), sides.end(), sides.begin(), [&](int side) { return twins[side]; });
  return sides;
}

/// Leads a strip around points until there is none left; each time the path is shorter.
void Shorten(shape::TriangleStrip& strip)
{
  strip.FindPath();
  for (int round = 0; round < 1000; ++round)
  {
    const double length = strip.Length();
    if (!strip.LeadAround())
    {
      return;
    }
    strip.FindPath();
    EXPECT_LT(strip.Length(), length);
  }
  FAIL();
}

shape::SurfacePoint RandomPositionInside(const shape::Mesh& mesh, std::mt19937& random)
{
  const double a = 0.1 + 0.3 * static_cast<double>(random()) / 4294967296.0;
  return { static_cast<int>(random() % mesh.Triangles.rows()), { a, 0.3, 0.7 - a } };
}

TEST(TriangleStrip, APlaceIsTheSameInEachTriangleThatHasIt)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  const std::vector<int> twins = shape::FindTwins(sphere.Triangles, sphere.Points.rows());
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int triangle = side / 3, beside = twins[side] / 3;
    const int begin = sphere.Triangles(triangle, side % 3);
    const int end = sphere.Triangles(triangle, shape::NextHalfEdge(side) % 3);
    const int apex = sphere.Triangles(triangle, shape::PreviousHalfEdge(side) % 3);
    shape::SurfacePoint position{ triangle, Eigen::RowVector3d::Zero() };
    position.Barycentric(side % 3) = 0.75;
    position.Barycentric(shape::NextHalfEdge(side) % 3) = 0.25;
    const shape::PointSupport onEdge(sphere, position);
    EXPECT_EQ(onEdge.Count, 2);
    EXPECT_TRUE(onEdge.IsOn(end, begin));
    EXPECT_FALSE(onEdge.IsOn(apex, begin));
    int having = 0;
    for (const auto& corners : sphere.Triangles.rowwise())
    {
      having += onEdge.IsIn(corners) ? 1 : 0;
    }
    EXPECT_EQ(having, 2);
    const shape::SurfacePoint there = onEdge.In(sphere, beside);
    EXPECT_EQ(there.Triangle, beside);
    EXPECT_LT((PositionOf(sphere, there) - PositionOf(sphere, position)).norm(), 1e-15);
    EXPECT_EQ(onEdge.In(sphere, triangle).Barycentric, position.Barycentric);

    const shape::PointSupport atCorner(sphere, AtCorner(sphere, triangle, begin));
    EXPECT_EQ(atCorner.Count, 1);
    EXPECT_TRUE(atCorner.IsOn(begin, apex));
    EXPECT_EQ(PositionOf(sphere, atCorner.In(sphere, beside)), sphere.Points.row(begin));
    shape::TriangleStrip nowhere(sphere, twins, AtCorner(sphere, triangle, begin),
      AtCorner(sphere, beside, begin), triangle, { side });
    nowhere.FindPath();
    EXPECT_EQ(nowhere.Length(), 0.0);
    EXPECT_EQ(nowhere.Path().Positions.size(), 1U);
    const shape::PointSupport inside(sphere, { triangle, { 0.5, 0.25, 0.25 } });
    EXPECT_EQ(inside.Count, 3);
    EXPECT_FALSE(inside.IsIn(sphere.Triangles.row(beside)));
  }
}

TEST(TriangleStrip, StraightInAFlatConvexRegion)
{
  const shape::Mesh plane = shapetest::FlatSquare(14, 0.3);
  const std::vector<int> twins = shape::FindTwins(plane.Triangles, plane.Points.rows());
  std::mt19937 random(7);
  int bent = 0;
  for (int i = 0; i < 60; ++i)
  {
    const shape::SurfacePoint from = RandomPositionInside(plane, random),
                              to = RandomPositionInside(plane, random);
    const Eigen::RowVector3d begin = PositionOf(plane, from), end = PositionOf(plane, to);
    const double distance = (end - begin).norm();
    const std::vector<int> sides = SidesBetween(twins, from.Triangle, to.Triangle);
    shape::TriangleStrip strip(plane, twins, from, to, from.Triangle, sides);
    shape::TriangleStrip back(plane, twins, to, from, to.Triangle, Back(twins, sides));
    strip.FindPath();
    back.FindPath();
    const double first = strip.Length();
    EXPECT_GE(first, distance * (1.0 - 1e-14));
    EXPECT_NEAR(back.Length(), first, 1e-13);
    bent += first > distance * (1.0 + 1e-9) ? 1 : 0;
    // There and back again at once is left out.
    const int out = twins[3 * from.Triangle] >= 0 ? 3 * from.Triangle : 3 * from.Triangle + 1;
    std::vector<int> longer = { out, twins[out] };
    longer.insert(longer.end(), sides.begin(), sides.end());
    shape::TriangleStrip same(plane, twins, from, to, from.Triangle, longer);
    same.FindPath();
    EXPECT_EQ(same.Length(), first);

    Shorten(strip);
    EXPECT_NEAR(strip.Length(), distance, 1e-13);
    const shape::SurfacePath path = strip.Path();
    ExpectPath(plane, path);
    for (const shape::SurfacePoint& position : path.Positions)
    {
      EXPECT_LT((PositionOf(plane, position) - begin).cross(end - begin).norm(), 1e-12 * distance);
    }
  }
  EXPECT_GT(bent, 20);
}

TEST(TriangleStrip, AroundAReflexCornerOfTheBorder)
{
  const shape::Mesh bracket = shapetest::Without(shapetest::FlatSquare(10, 0.0),
    [](const Eigen::RowVector3d& position) { return position(0) > 0.0 && position(1) > 0.0; });
  const std::vector<int> twins = shape::FindTwins(bracket.Triangles, bracket.Points.rows());
  const Eigen::MatrixXd centres = shape::ComputeCentroids(bracket);
  const Eigen::RowVector3d third = Eigen::RowVector3d::Constant(1.0 / 3.0);
  int around = 0;
  for (int a = 0; a < centres.rows(); a += 7)
  {
    for (int b = 0; b < centres.rows(); b += 11)
    {
      shape::TriangleStrip strip(
        bracket, twins, { a, third }, { b, third }, a, SidesBetween(twins, a, b));
      Shorten(strip);
      // The straight way, or by the corner where it leaves the bracket.
      const Eigen::RowVector3d begin = centres.row(a), end = centres.row(b);
      const double turn = begin(0) * end(1) - begin(1) * end(0);
      const bool isHidden = begin(0) * end(0) < 0.0 && begin(1) * end(1) < 0.0 &&
        (begin(0) > end(0) ? turn > 0.0 : turn < 0.0);
      around += isHidden ? 1 : 0;
      EXPECT_NEAR(
        strip.Length(), isHidden ? begin.norm() + end.norm() : (end - begin).norm(), 1e-13);
      const shape::SurfacePath path = strip.Path();
      ExpectPath(bracket, path);
      const bool isPassed = std::any_of(path.Positions.begin(), path.Positions.end(),
        [&](const shape::SurfacePoint& position)
        { return PositionOf(bracket, position).norm() < 1e-14; });
      EXPECT_TRUE(isPassed == isHidden || std::abs(turn) < 1e-14);
    }
  }
  EXPECT_GT(around, 20);
}

TEST(TriangleStrip, AHelixMoreThanOnceAroundATube)
{
  constexpr int across = 12;
  const shape::Mesh tube = shapetest::Tube(across, 4, 2.0);
  const double width = 2.0 * std::sin(M_PI / across);
  const std::vector<int> twins = shape::FindTwins(tube.Triangles, tube.Points.rows());
  shape::Mesh moved = tube;
  moved.Points = shapetest::Moved(tube.Points, shapetest::SomeRotation(), 250.0, { 7, -3, 900 });
  for (const int quads : { 1, 7, 12, 31 })
  {
    // Along the lowest row, from point 0 on: over the diagonal of each quad and on.
    std::vector<int> sides;
    for (int quad = 0; quad < quads; ++quad)
    {
      const int lower = 2 * (quad % across);
      sides.push_back(3 * (lower + 1)); // the diagonal, from the upper triangle
      if (quad + 1 < quads)
      {
        sides.push_back(3 * lower + 1);
      }
    }
    const shape::SurfacePoint from = AtCorner(tube, 1, 0);
    const shape::SurfacePoint to =
      AtCorner(tube, 2 * ((quads - 1) % across), across + quads % across);
    shape::TriangleStrip helix(tube, twins, from, to, 1, sides);
    helix.FindPath();
    const double length = std::hypot(0.5, width * quads);
    EXPECT_NEAR(helix.Length(), length, 1e-12 * length);
    EXPECT_FALSE(helix.LeadAround());
    ExpectPath(tube, helix.Path());
    shape::TriangleStrip large(moved, twins, from, to, 1, sides);
    large.FindPath();
    EXPECT_NEAR(large.Length(), 250.0 * length, 1e-10 * length);
    EXPECT_EQ(large.Path().Triangles, helix.Path().Triangles);
  }
}

TEST(TriangleStrip, NoTurnAtAConvexPoint)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const std::vector<int> twins = shape::FindTwins(sphere.Triangles, sphere.Points.rows());
  std::mt19937 random(9);
  for (int i = 0; i < 60; ++i)
  {
    const shape::SurfacePoint from = RandomPositionInside(sphere, random),
                              to = RandomPositionInside(sphere, random);
    shape::TriangleStrip strip(
      sphere, twins, from, to, from.Triangle, SidesBetween(twins, from.Triangle, to.Triangle));
    Shorten(strip);
    const shape::SurfacePath path = strip.Path();
    ExpectPath(sphere, path);
    for (std::size_t at = 1; at + 1 < path.Positions.size(); ++at)
    {
      EXPECT_EQ(shape::PointSupport(sphere, path.Positions[at]).Count, 2);
    }
  }
}

} // namespace
