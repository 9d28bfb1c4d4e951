#include "Base/Errors.h"
#include "Geometry/SurfaceWelding.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

/// Every triangle with three points of its own, each moved by up to `noise`.
shape::Mesh Soup(const shape::Mesh& mesh, double noise)
{
  const Eigen::Index count = mesh.Triangles.rows();
  shape::Mesh soup{ Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(count, 3) };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-noise, noise);
  for (Eigen::Index t = 0; t < count; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      soup.Triangles(t, k) = static_cast<int>(3 * t + k);
      soup.Points.row(3 * t + k) = mesh.Points.row(mesh.Triangles(t, k)) +
        Eigen::RowVector3d(shift(random), shift(random), shift(random));
    }
  }
  return soup;
}

} // namespace

TEST(SurfaceWelding, PointsWithinTheToleranceAreTheFirstOfThem)
{
  Eigen::MatrixXd points(5, 3);
  points << 0, 0, 0, 1, 0, 0, 4e-10, 0, 0, 1, 3e-9, 0, 1, 0, 0;
  EXPECT_EQ(shape::FindPointsWithinTolerance(points), (std::vector<int>{ 0, 1, 0, 3, 1 }));
  // A share of the diagonal, however large or small this is, and wherever.
  for (const double scale : { 1e-200, 1e-3, 1e140 })
  {
    EXPECT_EQ(
      shape::FindPointsWithinTolerance(scale * points), shape::FindPointsWithinTolerance(points))
      << scale;
  }
  EXPECT_EQ(shape::FindPointsWithinTolerance(Eigen::MatrixXd::Ones(4, 3)),
    (std::vector<int>{ 0, 0, 0, 0 }));
  EXPECT_TRUE(shape::FindPointsWithinTolerance(Eigen::MatrixXd(0, 3)).empty());
}

TEST(SurfaceWelding, ASoupIsTheSurfaceThatItIs)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.3, 30, 12);
  const double diagonal = shape::ComputeBoxDiagonal(torus.Points);
  for (const double noise : { 0.0, 1e-10 * diagonal })
  {
    const shape::WeldedSurface welded(Soup(torus, noise));
    const shape::Topology topology = shape::RequireClosedSurface(welded.Surface, "the soup");
    EXPECT_EQ(topology.EulerNumber, 0);
    EXPECT_EQ(welded.WeldedPoints, 3 * torus.Triangles.rows() - torus.Points.rows());
    EXPECT_EQ(welded.Triangles.size(), static_cast<std::size_t>(torus.Triangles.rows()));
  }
  // Farther apart than the tolerance they are what they were.
  EXPECT_EQ(shape::WeldedSurface(Soup(torus, 1e-6)).WeldedPoints, 0);
}

TEST(SurfaceWelding, WhatOnlyTouchesStaysApart)
{
  // Two tetrahedra that touch at a point each has of its own, and a third one at an index.
  shape::Mesh two{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(8, 3) };
  two.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1;
  two.Triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 4, 5, 6, 4, 7, 5, 4, 6, 7, 5, 7, 6;
  const shape::WeldedSurface touching(two);
  EXPECT_EQ(touching.WeldedPoints, 0);
  EXPECT_EQ(shape::ComputeTopology(touching.Surface).Components, 2);
  // Two sheets over each other, each whole by itself, are joined at their rims alone.
  const shape::Mesh square = shapetest::FlatSquare(4, 0.0);
  const Eigen::Index points = square.Points.rows(), count = square.Triangles.rows();
  shape::Mesh pillow{ Eigen::MatrixXd(2 * points, 3), Eigen::MatrixXi(2 * count, 3) };
  pillow.Points << square.Points, square.Points;
  pillow.Triangles << square.Triangles,
    square.Triangles.rowwise().reverse().array() + static_cast<int>(points);
  const shape::WeldedSurface closed(pillow);
  EXPECT_EQ(closed.WeldedPoints, 16);
  EXPECT_EQ(shape::RequireClosedSurface(closed.Surface, "the pillow").EulerNumber, 2);
}

TEST(SurfaceWelding, TrianglesWithoutThreePlacesGoAndLeaveNoHole)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const double tiny = 1e-11 * shape::ComputeBoxDiagonal(sphere.Points);
  // A point is doubled, and the cleft along two of its edges is filled by slivers.
  shape::Mesh cleft = sphere;
  const auto points = static_cast<int>(sphere.Points.rows());
  cleft.Points.conservativeResize(points + 1, 3);
  cleft.Points.row(points) = sphere.Points.row(0) + Eigen::RowVector3d(0, 0, tiny);
  std::vector<int> around; // triangles at point 0
  for (int t = 0; t < sphere.Triangles.rows(); ++t)
  {
    if ((sphere.Triangles.row(t).array() == 0).any())
    {
      around.push_back(t);
    }
  }
  const int moved = around.front();
  int corner = 0;
  cleft.Triangles.row(moved).array().cwiseEqual(0).maxCoeff(&corner);
  cleft.Triangles(moved, corner) = points;
  const int next = cleft.Triangles(moved, (corner + 1) % 3),
            last = cleft.Triangles(moved, (corner + 2) % 3);
  const Eigen::Index count = cleft.Triangles.rows();
  cleft.Triangles.conservativeResize(count + 3, 3);
  cleft.Triangles.row(count) << 0, next, points;
  cleft.Triangles.row(count + 1) << last, 0, points;
  cleft.Triangles.row(count + 2) << 3, 3, 5; // a point twice
  EXPECT_EQ(shape::RequireClosedSurface({ cleft.Points, cleft.Triangles.topRows(count + 2) }, "it")
              .EulerNumber,
    2);
  const shape::WeldedSurface welded(cleft);
  EXPECT_EQ(welded.Triangles.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(welded.WeldedPoints, 1);
  EXPECT_EQ(welded.First[points], 0);
  EXPECT_EQ(welded.Surface.Triangles, sphere.Triangles);
}

TEST(SurfaceWelding, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  EXPECT_REFUSED(shape::WeldedSurface({ sphere.Points, {} }), "has no triangles");
  shape::Mesh wrong = sphere;
  wrong.Triangles(3, 1) = 1000;
  EXPECT_REFUSED(shape::WeldedSurface{ wrong }, "uses a point that does not exist");
  wrong = sphere;
  wrong.Points(3, 1) = NAN;
  EXPECT_REFUSED(shape::WeldedSurface{ wrong }, "first at point 3");
  wrong.Points = Eigen::MatrixXd::Ones(sphere.Points.rows(), 3);
  EXPECT_REFUSED(shape::WeldedSurface{ wrong }, "no triangle of");
}
