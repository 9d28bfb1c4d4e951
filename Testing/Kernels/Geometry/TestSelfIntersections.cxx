#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

/// How many pairs meet of two triangles, given by their six corners; the second may use points of
/// the first.
std::size_t Count(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles)
{
  return shape::FindSelfIntersections({ points, triangles }).size();
}

Eigen::MatrixXd Rows(std::initializer_list<Eigen::RowVector3d> rows)
{
  Eigen::MatrixXd points(rows.size(), 3);
  std::copy(rows.begin(), rows.end(), points.rowwise().begin());
  return points;
}

} // namespace

TEST(Crossings, TrianglesApartThroughAndTouching)
{
  const Eigen::MatrixXi two = (Eigen::MatrixXi(2, 3) << 0, 1, 2, 3, 4, 5).finished();
  const Eigen::RowVector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto with = [&](const Eigen::RowVector3d& d, const Eigen::RowVector3d& e,
                      const Eigen::RowVector3d& f) {
    return Count(Rows({ a, b, c, d, e, f }), two);
  };
  EXPECT_EQ(with({ 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 1 }), 1U) << "an edge through the inside";
  EXPECT_EQ(with({ 3, 3, -1 }, { 3, 3, 1 }, { 9, 9, 1 }), 0U) << "past it";
  EXPECT_EQ(with({ 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 1 }), 1U) << "a corner on the inside";
  EXPECT_EQ(with({ 1, 1, 1e-300 }, { 1, 1, 1 }, { 2, 1, 1 }), 0U) << "a corner just above";
  EXPECT_EQ(with({ 2, 2, 0 }, { 3, 3, 1 }, { 3, 3, -1 }), 1U) << "a corner on an edge";
  EXPECT_EQ(with({ 2, 0, -1 }, { 2, 0, 1 }, { 2, -3, 0 }), 1U) << "an edge through an edge";
  EXPECT_EQ(with({ 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 }), 1U) << "in one plane, one in the other";
  EXPECT_EQ(with({ 3, 3, 0 }, { -1, 3, 0 }, { 3, -1, 0 }), 1U) << "in one plane, overlapping";
  EXPECT_EQ(with({ 3, 3, 0 }, { 5, 3, 0 }, { 3, 5, 0 }), 0U) << "in one plane, apart";
  EXPECT_EQ(with({ 4, 0, 0 }, { 5, -1, 0 }, { 5, 1, 0 }), 1U) << "corner at corner, not shared";
}

TEST(Crossings, SharedCornersAndEdgesAreNone)
{
  const Eigen::RowVector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto atEdge = [&](const Eigen::RowVector3d& d) {
    return Count(Rows({ a, b, c, d }), (Eigen::MatrixXi(2, 3) << 0, 1, 2, 1, 0, 3).finished());
  };
  EXPECT_EQ(atEdge({ 1, -2, 0 }), 0U) << "flat neighbours";
  EXPECT_EQ(atEdge({ 1, 1, 1e-300 }), 0U) << "a sharp fold";
  EXPECT_EQ(atEdge({ 1, 1, 0 }), 1U) << "folded onto itself";
  const auto atCorner = [&](const Eigen::RowVector3d& d, const Eigen::RowVector3d& e) {
    return Count(Rows({ a, b, c, d, e }), (Eigen::MatrixXi(2, 3) << 0, 1, 2, 0, 3, 4).finished());
  };
  EXPECT_EQ(atCorner({ -1, -1, 0 }, { -1, -2, 0 }), 0U);
  EXPECT_EQ(atCorner({ 1, 1, 1 }, { 1, 1, 2 }), 0U);
  EXPECT_EQ(atCorner({ 1, 1, 1 }, { 1, 1, -1 }), 1U) << "through the inside, from the corner on";
  EXPECT_EQ(atCorner({ 1, 1, 0 }, { 1, 1, 1 }), 1U) << "an edge along the inside";
  EXPECT_EQ(atCorner({ 9, 0, 0 }, { 9, -1, 0 }), 1U) << "an edge along an edge";
  EXPECT_EQ(Count(Rows({ a, b, c }), (Eigen::MatrixXi(2, 3) << 0, 1, 2, 2, 1, 0).finished()), 1U)
    << "the same triangle twice";
}

TEST(Crossings, AFlatTriangleCountsAsItsEdges)
{
  Eigen::MatrixXi triangles(2, 3);
  triangles << 0, 1, 2, 3, 4, 5;
  const auto meet = [&](const Eigen::RowVector3d& from, const Eigen::RowVector3d& to)
  {
    const shape::Mesh mesh{
      Rows({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, from, 0.5 * (from + to), to }), triangles
    };
    EXPECT_EQ(shape::DoTrianglesIntersect(mesh, 0, 1), shape::DoTrianglesIntersect(mesh, 1, 0));
    return shape::DoTrianglesIntersect(mesh, 0, 1);
  };
  EXPECT_TRUE(meet({ 0.25, 0.25, -1 }, { 0.25, 0.25, 1 }));
  EXPECT_TRUE(meet({ -1, 0.25, 0 }, { 2, 0.25, 0 }));
  EXPECT_FALSE(meet({ 2, 2, -1 }, { 2, 2, 1 }));
  EXPECT_FALSE(meet({ 0.25, 0.25, 0.5 }, { 0.25, 0.25, 1 }));
  EXPECT_FALSE(meet({ -1, 0.25, -2 }, { 5, 0.25, 3 }));
}

TEST(Crossings, OfTwoSpheresLieOnTheCircleWhereTheyMeet)
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  EXPECT_TRUE(shape::FindSelfIntersections(mesh).empty());
  EXPECT_TRUE(shape::FindDegenerateTriangles(mesh).empty());
  const Eigen::Index points = mesh.Points.rows(), triangles = mesh.Triangles.rows();
  mesh.Points = mesh.Points.replicate(2, 1).eval();
  mesh.Points.bottomRows(points).rowwise() += Eigen::RowVector3d(1.0, 0.01, 0.02);
  mesh.Triangles = mesh.Triangles.replicate(2, 1).eval();
  mesh.Triangles.bottomRows(triangles).array() += static_cast<int>(points);
  const std::vector<shape::Crossing> crossings = shape::FindSelfIntersections(mesh);
  EXPECT_GT(crossings.size(), 60U);
  for (const shape::Crossing& crossing : crossings)
  {
    EXPECT_LT(crossing.First, triangles);
    EXPECT_GE(crossing.Second, triangles);
    EXPECT_NEAR(crossing.Position.norm(), 1.0, 0.15);
    EXPECT_NEAR(crossing.Position(0), 0.5, 0.15);
  }
}

TEST(Crossings, DoNotDependOnTheOrderOfCornersOrTriangles)
{
  std::mt19937_64 generator(3);
  for (int round = 0; round < 2000; ++round)
  {
    // Small integers: half of the cases are touching, flat or in one plane.
    Eigen::MatrixXd points(6, 3);
    for (double& value : points.reshaped())
    {
      value = static_cast<double>(generator() % 4);
    }
    const Eigen::MatrixXi one = (Eigen::MatrixXi(2, 3) << 0, 1, 2, 3, 4, 5).finished();
    const Eigen::MatrixXi other = (Eigen::MatrixXi(2, 3) << 4, 3, 5, 2, 0, 1).finished();
    if (shape::FindDegenerateTriangles({ points, one }).empty())
    {
      EXPECT_EQ(Count(points, one), Count(points, other)) << points;
    }
  }
}
