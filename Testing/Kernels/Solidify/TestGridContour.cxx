#include "Mesh/Surface.h"
#include "Solidify/Private/GridContour.h"
#include "Solidify/Private/SolidSampling.h"
#include "Solidify/SurfaceDefects.h"
#include "Support/HoleShapes.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using Eigen::RowVector3d;

TEST(GridContour, AnySolidHasAValidBoundary)
{
  // Random points inside, with random positions and normals on the edges between: every
  // configuration of a cell occurs, and creases in all directions.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 12; ++round)
  {
    constexpr int count = 9;
    shape::GridSolid solid{ { RowVector3d::Zero(), 1.0, { count, count, count }, {} }, {} };
    const double share = 0.15 + 0.06 * round;
    for (int point = 0; point < count * count * count; ++point)
    {
      const Eigen::Array3i at(point % count, point / count % count, point / count / count);
      const bool isBorder = (at == 0 || at == count - 1).any();
      solid.Inside.push_back(!isBorder && 0.5 + 0.5 * uniform(random) < share);
    }
    const std::vector<shape::GridEdge> edges = shape::FindBoundaryEdges(solid);
    std::vector<shape::EdgeCrossing> crossings;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const RowVector3d normal(uniform(random), uniform(random), uniform(random));
      crossings.push_back({ 0.5 + 0.5 * uniform(random), normal.normalized() });
    }
    const shape::Mesh boundary = shape::ContourGrid(solid, edges, crossings);
    const shape::SurfaceDefects defects = shape::FindSurfaceDefects(boundary);
    EXPECT_TRUE(defects.Defects.empty());
    EXPECT_GT(boundary.Triangles.rows(), 100);
  }
}

TEST(GridContour, TheCreasesOfABoxAreExact)
{
  const shape::Mesh box = shapetest::Box(RowVector3d::Zero(), RowVector3d(1.0, 0.8, 0.7));
  const shape::Mesh sampled = shape::ContourWinding(box, 0.043);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(sampled), 0.56, 1e-9);
  EXPECT_NEAR(shape::ComputeArea(sampled), shape::ComputeArea(box), 1e-9);
}

TEST(GridContour, ATurnedBoxKeepsItsVolume)
{
  // Each cell that a crease leaves through a face without a crossing cuts off less than a cell.
  shape::Mesh box = shapetest::Box(RowVector3d::Zero(), RowVector3d::Ones());
  box.Points *=
    Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const double coarse =
    std::abs(shape::ComputeEnclosedVolume(shape::ContourWinding(box, 0.04)) - 1.0);
  const double fine =
    std::abs(shape::ComputeEnclosedVolume(shape::ContourWinding(box, 0.02)) - 1.0);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, 5e-4);
}

TEST(GridContour, WindingNumbersDecideWhatIsInside)
{
  // Two balls that cross, and a torus.
  const shape::Mesh balls = shapetest::Twice(shapetest::Sphere(4, 1.0), RowVector3d(1.0, 0.0, 0.0));
  const shape::Surface united = shape::ContourWinding(balls, 0.05);
  EXPECT_EQ(united.Topology().EulerNumber, 2);
  // A lens of two caps of the height 1/2 is counted once.
  const double ball = 4.0 / 3.0 * M_PI, lens = 2.0 * M_PI * 0.25 * (3.0 - 0.5) / 3.0;
  EXPECT_NEAR(shape::ComputeEnclosedVolume(united), 2.0 * ball - lens, 0.01 * ball);
  const shape::Surface torus = shape::ContourWinding(shapetest::Torus(1.0, 0.4, 60, 30), 0.05);
  EXPECT_EQ(torus.Topology().EulerNumber, 0);
}

TEST(GridContour, ConesCloseAnySurface)
{
  // A cone over a flat loop lies in its plane.
  const shape::Mesh box = shapetest::Box(RowVector3d::Zero(), RowVector3d::Ones());
  const shape::Mesh closed = shape::CloseByCones(shapetest::WithoutLast(box, 2));
  EXPECT_NEAR(shape::ComputeEnclosedVolume(closed), 1.0, 1e-12);
  EXPECT_NEAR(
    shape::ComputeWindingNumber(closed.Points, closed.Triangles, RowVector3d(0.4, 0.5, 0.6)), 1.0,
    1e-12);
  // A reversed triangle is closed by a cone of two layers: the numbers are integers everywhere.
  shape::Mesh flipped = box;
  std::swap(flipped.Triangles(0, 1), flipped.Triangles(0, 2));
  const shape::Mesh cone = shape::CloseByCones(flipped);
  EXPECT_NEAR(shape::ComputeWindingNumber(cone.Points, cone.Triangles, RowVector3d(0.4, 0.5, 0.6)),
    1.0, 1e-12);
}
