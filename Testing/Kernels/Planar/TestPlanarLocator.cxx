#include "Geometry/Orientation.h"
#include "Planar/PlanarLocator.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{

using Eigen::RowVector2d;

/// The lowest counter-clockwise triangle that contains a place, found by looking at all.
int Lowest(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles, const RowVector2d& position)
{
  for (int t = 0; t < triangles.rows(); ++t)
  {
    const RowVector2d a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                      c = points.row(triangles(t, 2));
    if (shape::EvaluateOrientation(a, b, c) > 0 &&
      shape::EvaluateOrientation(a, b, position) >= 0 &&
      shape::EvaluateOrientation(b, c, position) >= 0 &&
      shape::EvaluateOrientation(c, a, position) >= 0)
    {
      return t;
    }
  }
  return -1;
}

} // namespace

TEST(PlanarLocator, FindsTheTriangleOfAPlace)
{
  // Shaken until some triangles are turned over and others lie over one another.
  for (const double shake : { 0.0, 0.3, 0.9 })
  {
    const shape::Mesh mesh = shapetest::FlatSquare(12, shake);
    const Eigen::MatrixXd points = mesh.Points.leftCols(2);
    const shape::PlanarLocator locator(points, mesh.Triangles);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.2, 1.2);
    int inside = 0;
    const auto check = [&](const RowVector2d& position)
    {
      const shape::SurfacePoint found = locator.Find(position);
      ASSERT_EQ(found.Triangle, Lowest(points, mesh.Triangles, position));
      if (found.Triangle >= 0)
      {
        ++inside;
        RowVector2d back = RowVector2d::Zero();
        for (int k = 0; k < 3; ++k)
        {
          back += found.Barycentric(k) * points.row(mesh.Triangles(found.Triangle, k));
        }
        EXPECT_LT((back - position).norm(), 1e-13);
        EXPECT_GE(found.Barycentric.minCoeff(), 0.0);
      }
    };
    for (int i = 0; i < 2000; ++i)
    {
      check(RowVector2d(uniform(random), uniform(random)));
    }
    for (const auto& point : points.rowwise())
    {
      check(RowVector2d(point));
    }
    EXPECT_GT(inside, 1000);
  }
}

TEST(PlanarLocator, LeavesOutWhatItIsTold)
{
  const shape::Mesh mesh = shapetest::FlatSquare(4, 0.0);
  const Eigen::MatrixXd points = mesh.Points.leftCols(2);
  const RowVector2d position(0.3, -0.4);
  const int first = shape::PlanarLocator(points, mesh.Triangles).Find(position).Triangle;
  ASSERT_GE(first, 0);
  EXPECT_EQ(shape::PlanarLocator(points, mesh.Triangles, { first }).Find(position).Triangle, -1);
}

TEST(PlanarLocator, IsDefinedWithoutAnythingToFind)
{
  const Eigen::MatrixXd none(0, 2), one = Eigen::MatrixXd::Ones(1, 2);
  const Eigen::MatrixXi noTriangles(0, 3);
  EXPECT_EQ(shape::PlanarLocator(none, noTriangles).Find({ 0, 0 }).Triangle, -1);
  EXPECT_EQ(shape::PlanarLocator(one, noTriangles).Find({ 1, 1 }).Triangle, -1);
  // All on a line, and far apart.
  Eigen::MatrixXd line(3, 2);
  line << 0, 0, 1, 1e-300, 1e9, 0;
  Eigen::MatrixXi triangle(1, 3);
  triangle << 0, 1, 2;
  EXPECT_EQ(shape::PlanarLocator(line, triangle).Find({ 0.5, 1.0 }).Triangle, -1);
}

TEST(PlanarLocator, NamesEveryTriangleNearABox)
{
  const shape::Mesh mesh = shapetest::FlatSquare(9, 0.3);
  const Eigen::MatrixXd points = mesh.Points.leftCols(2);
  const shape::PlanarLocator locator(points, mesh.Triangles);
  const RowVector2d lower(-0.31, 0.05), upper(0.2, 0.4);
  std::vector<char> named(mesh.Triangles.rows(), 0);
  EXPECT_FALSE(locator.AnyNear(lower, upper,
    [&](int triangle)
    {
      named[triangle] = 1;
      return false;
    }));
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::MatrixXd corners = points(mesh.Triangles.row(t), Eigen::all);
    const bool meets = (corners.colwise().maxCoeff().array() >= lower.array()).all() &&
      (corners.colwise().minCoeff().array() <= upper.array()).all();
    EXPECT_TRUE(named[t] || !meets);
  }
  EXPECT_TRUE(locator.AnyNear(lower, upper, [](int) { return true; }));
}
