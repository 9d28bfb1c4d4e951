#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Mesh/TouchingSheets.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>

namespace
{

void Require(const shape::Mesh& mesh)
{
  shape::RequireClosedSurface(mesh, "the surface");
}

} // namespace

TEST(Topology, HalfEdgesOfOneEdgeLieSideBySide)
{
  const shape::Mesh mesh = shapetest::WithoutLast(shapetest::Icosphere(2), 3);
  const auto sides = shape::SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  ASSERT_EQ(sides.size(), 3 * mesh.Triangles.rows());
  std::set<std::array<int, 2>> seen;
  std::array<int, 3> before{ -1, -1, -1 };
  for (const shape::HalfEdge& side : sides)
  {
    EXPECT_EQ(side.Begin, mesh.Triangles(side.Triangle, side.Corner));
    EXPECT_EQ(side.End, mesh.Triangles(side.Triangle, (side.Corner + 1) % 3));
    seen.insert({ side.Triangle, side.Corner });
    const std::array<int, 3> key{ side.Low(), side.High(), side.Triangle };
    EXPECT_LT(before, key);
    before = key;
  }
  EXPECT_EQ(seen.size(), sides.size());
}

TEST(Topology, EulerNumberIsTwoMinusTwiceTheGenus)
{
  EXPECT_EQ(shape::ComputeTopology(shapetest::Icosphere(2)).EulerNumber, 2);
  EXPECT_EQ(shape::ComputeTopology(shapetest::Torus(1.0, 0.3, 20, 10)).EulerNumber, 0);
}

TEST(Topology, CountsComponentsAndIgnoresUnusedPoints)
{
  const shape::Mesh one = shapetest::Icosphere(1);
  const Eigen::Index n = one.Points.rows();
  shape::Mesh two = shapetest::Twice(one);
  two.Points.conservativeResize(2 * n + 1, 3);
  two.Points.bottomRows(1).setZero();
  const shape::Topology topology = shape::ComputeTopology(two);
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.EulerNumber, 4);
  EXPECT_EQ(topology.ComponentId(0), 0);
  EXPECT_EQ(topology.ComponentId(n), 1);
  EXPECT_EQ(topology.ComponentId(2 * n), -1);
  const std::vector<shape::Mesh> components = shape::SplitComponents(two);
  ASSERT_EQ(components.size(), 2u);
  for (int c = 0; c < 2; ++c)
  {
    EXPECT_EQ(components[c].Points, (one.Points.array() + 5.0 * c).matrix());
    EXPECT_EQ(components[c].Triangles, one.Triangles);
  }
}

TEST(Topology, WindingNumbersCountTheSurfacesAroundAPlace)
{
  shape::Mesh sphere = shapetest::Icosphere(2);
  for (const double radius : { 0.0, 0.9, 1.1, 3.0 })
  {
    EXPECT_NEAR(shape::ComputeWindingNumber(
                  sphere.Points, sphere.Triangles, Eigen::RowVector3d(0.0, 0.6, 0.8) * radius),
      radius < 1.0 ? 1.0 : 0.0, 1e-13);
  }
  sphere.Triangles.col(0).swap(sphere.Triangles.col(1));
  EXPECT_NEAR(
    shape::ComputeWindingNumber(sphere.Points, sphere.Triangles, Eigen::RowVector3d::Zero()), -1.0,
    1e-13);
}

TEST(Topology, AnOpenLoopIsRefusedWithItsFirstPoint)
{
  const shape::Mesh open = shapetest::WithoutLast(shapetest::Icosphere(1), 1);
  const shape::Topology topology = shape::ComputeTopology(open);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  EXPECT_EQ(topology.EulerNumber, 1);
  EXPECT_REFUSED(
    Require(open), "1 open loop (first at point " + std::to_string(topology.FirstOpenPoint) + ")");
}

TEST(Topology, ASizeWhosePowersAreNoNumbersIsRefused)
{
  for (const double scale : { 1e-60, 1e60 })
  {
    shape::Mesh mesh = shapetest::Icosphere(1);
    mesh.Points *= scale;
    EXPECT_REFUSED(Require(mesh), "has a longest side of");
  }
  shape::Mesh nowhere = shapetest::Icosphere(1);
  nowhere.Points.setZero();
  EXPECT_REFUSED(Require(nowhere), "has no area");
  shape::Mesh small = shapetest::Icosphere(1);
  small.Points *= 1e-40;
  EXPECT_NO_THROW(Require(small));
}

TEST(Topology, AFlippedTriangleIsRefused)
{
  shape::Mesh mesh = shapetest::Icosphere(1);
  std::swap(mesh.Triangles(7, 0), mesh.Triangles(7, 1));
  EXPECT_EQ(shape::ComputeTopology(mesh).MisorientedEdges, 3);
  EXPECT_REFUSED(Require(mesh), "opposite orientation");
}

TEST(Topology, AOneSidedSurfaceIsToldFromOneWithATriangleTurnedOver)
{
  // A strip of triangles around the axis, its ends joined after half a turn.
  constexpr int around = 9;
  shape::Mesh strip{ Eigen::MatrixXd(2 * around, 3), Eigen::MatrixXi(2 * around, 3) };
  for (int i = 0; i < around; ++i)
  {
    const double angle = 2.0 * M_PI * i / around, across = 0.3 * std::cos(0.5 * angle);
    const Eigen::RowVector3d outwards(std::cos(angle), std::sin(angle), 0.0),
      up(0.0, 0.0, 0.3 * std::sin(0.5 * angle));
    strip.Points.row(2 * i) = (1.0 + across) * outwards + up;
    strip.Points.row(2 * i + 1) = (1.0 - across) * outwards - up;
    const int last = i + 1 == around;
    const int next = last != 0 ? 1 : 2 * i + 2, beyond = last != 0 ? 0 : 2 * i + 3;
    strip.Triangles.row(2 * i) << 2 * i, 2 * i + 1, next;
    strip.Triangles.row(2 * i + 1) << 2 * i + 1, beyond, next;
  }
  const auto require = [](const shape::Mesh& mesh) { shape::RequireManifold(mesh, "the surface"); };
  EXPECT_REFUSED(require(strip), "the surface is one-sided");
  shape::Mesh cut = strip;
  cut.Triangles.conservativeResize(2 * around - 2, 3);
  EXPECT_NO_THROW(require(cut));
  cut.Triangles.row(3).reverseInPlace();
  EXPECT_REFUSED(require(cut), "opposite orientation");
}

TEST(Topology, AnEdgeOfThreeTrianglesIsRefused)
{
  shape::Mesh mesh = shapetest::Icosphere(0);
  mesh.Triangles.conservativeResize(22, 3);
  mesh.Triangles.row(20) << 0, 11, 3;
  mesh.Triangles.row(21) << 11, 0, 3;
  EXPECT_EQ(shape::ComputeTopology(mesh).NonManifoldEdges, 1);
}

TEST(Topology, TwoSheetsThatTouchAtAPointAreRefused)
{
  const shape::Mesh one = shapetest::Icosphere(0);
  shape::Mesh pinched = shapetest::Twice(one);
  pinched.Triangles = (pinched.Triangles.array() == 12).select(3, pinched.Triangles);
  const shape::Topology topology = shape::ComputeTopology(pinched);
  EXPECT_EQ(topology.NonManifoldPoints, 1);
  EXPECT_EQ(topology.FirstPinchedPoint, 3);
  EXPECT_REFUSED(Require(pinched), "touch");
}

TEST(Topology, NotANumberIsRefusedWithItsPoint)
{
  shape::Mesh mesh = shapetest::Icosphere(1);
  mesh.Points(17, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(Require(mesh), "first at point 17");
}

TEST(Topology, AClosedSurfaceHasDirectedAreaZeroAndItsVolume)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  EXPECT_LT(shape::ComputeAreaVectors(sphere).colwise().sum().norm(), 1e-12);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(sphere), 4.0 / 3.0 * M_PI, 0.01);
  EXPECT_NEAR(shape::ComputePointAreas(sphere).sum(), 4.0 * M_PI, 0.03);
}

TEST(Topology, ASurfaceThatFacesInwardsIsTurned)
{
  shape::Mesh mesh = shapetest::Icosphere(1);
  const double volume = shape::ComputeEnclosedVolume(mesh);
  mesh.Triangles.col(0).swap(mesh.Triangles.col(1));
  EXPECT_LT(shape::ComputeEnclosedVolume(mesh), 0.0);
  EXPECT_DOUBLE_EQ(shape::ComputeEnclosedVolume(shape::OrientOutwards(mesh)), volume);
  EXPECT_DOUBLE_EQ(
    shape::ComputeEnclosedVolume(shape::OrientOutwards(shapetest::Icosphere(1))), volume);
}

TEST(TouchingSheets, EachSheetGetsAPointOfItsOwn)
{
  // Two spheres that share their first point.
  const shape::Mesh one = shapetest::Icosphere(1);
  const auto n = static_cast<int>(one.Points.rows());
  shape::Mesh touching = shapetest::Twice(one);
  for (int& corner : touching.Triangles.reshaped())
  {
    corner = corner == n ? 0 : corner;
  }
  EXPECT_EQ(shape::ComputeTopology(touching).NonManifoldPoints, 1);
  const shape::SplitSheets split = shape::SplitTouchingSheets(touching);
  EXPECT_EQ(split.Surface.Points.rows(), touching.Points.rows() + 1);
  EXPECT_EQ(split.Copied.back(), 0);
  EXPECT_EQ(split.Surface.Points, touching.Points(split.Copied, Eigen::all));
  const shape::Topology topology = shape::ComputeTopology(split.Surface);
  EXPECT_EQ(topology.NonManifoldPoints, 0);
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.EulerNumber, 4);
}

TEST(TouchingSheets, AManifoldStaysAsItIs)
{
  const shape::Mesh open = shapetest::WithoutLast(shapetest::Icosphere(2), 3);
  const shape::SplitSheets split = shape::SplitTouchingSheets(open);
  EXPECT_EQ(split.Surface.Points, open.Points);
  EXPECT_EQ(split.Surface.Triangles, open.Triangles);
}
