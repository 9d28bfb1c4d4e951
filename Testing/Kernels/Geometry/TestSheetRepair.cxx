#include "Geometry/SheetRepair.h"

#include "Mesh/CoincidentPoints.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace
{

using Eigen::RowVector3d;

int AddPoint(shape::Mesh& mesh, const RowVector3d& position)
{
  mesh.Points.conservativeResize(mesh.Points.rows() + 1, 3);
  mesh.Points.bottomRows(1) = position;
  return static_cast<int>(mesh.Points.rows()) - 1;
}

void AddTriangle(shape::Mesh& mesh, int a, int b, int c)
{
  mesh.Triangles.conservativeResize(mesh.Triangles.rows() + 1, 3);
  mesh.Triangles.bottomRows(1) << a, b, c;
}

/// The mesh with the first of several points at one position in place of the others.
shape::Mesh MergePoints(shape::Mesh mesh)
{
  const std::vector<int> first = shape::FindCoincidentPoints(mesh.Points);
  mesh.Triangles = mesh.Triangles.unaryExpr([&](int point) { return first[point]; }).eval();
  return mesh;
}

/// The result must be the surface alone, over the same points.
void ExpectOnly(const shape::RepairedSheets& repaired, const shape::Mesh& surface)
{
  EXPECT_EQ(repaired.Surface.Triangles, surface.Triangles);
  EXPECT_EQ(repaired.SplitPoints, 0);
  EXPECT_TRUE(repaired.IsChanged());
  EXPECT_EQ(repaired.FirstRemoved, surface.Triangles.rows());
}

} // namespace

TEST(SheetRepair, ASoundSurfaceStaysAsItIs)
{
  for (const shape::Mesh& mesh :
    { shapetest::Torus(1.0, 0.3, 12, 8), shapetest::FlatDisk(3), shapetest::Icosphere(1) })
  {
    const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
    EXPECT_FALSE(repaired.IsChanged());
    EXPECT_EQ(repaired.Surface.Points, mesh.Points);
    EXPECT_EQ(repaired.Surface.Triangles, mesh.Triangles);
    EXPECT_EQ(repaired.FirstRemoved, -1);
    EXPECT_EQ(repaired.FirstNonManifold, -1);
    EXPECT_EQ(repaired.FirstSplit, -1);
  }
}

// Outside and inside of the sphere, in both orientations.
TEST(SheetRepair, AFinIsRemoved)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const int a = sphere.Triangles(5, 0), b = sphere.Triangles(5, 1);
  for (const double height : { 1.1, 0.9 })
  {
    for (const bool isTurned : { false, true })
    {
      shape::Mesh mesh = sphere;
      const int tip = AddPoint(mesh, height * 0.5 * (sphere.Points.row(a) + sphere.Points.row(b)));
      AddTriangle(mesh, isTurned ? b : a, isTurned ? a : b, tip);
      const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
      ExpectOnly(repaired, sphere);
      EXPECT_EQ(repaired.FinTriangles, 1);
      EXPECT_EQ(repaired.NonManifoldEdges, 1);
      EXPECT_EQ(repaired.FirstNonManifold, std::min(a, b));
    }
  }
}

TEST(SheetRepair, RepeatedAndDegenerateTrianglesAreRemoved)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::RowVector3i first = sphere.Triangles.row(7);
  shape::Mesh same = sphere;
  AddTriangle(same, first(1), first(2), first(0));
  const shape::RepairedSheets once = shape::RepairSheets(same);
  ExpectOnly(once, sphere);
  EXPECT_EQ(once.DuplicateTriangles, 1);

  // A copy that faces the other way meets three triangles at each of its edges.
  shape::Mesh reversed = sphere;
  AddTriangle(reversed, first(1), first(0), first(2));
  const shape::RepairedSheets other = shape::RepairSheets(reversed);
  ExpectOnly(other, sphere);
  EXPECT_EQ(other.FinTriangles, 1);

  shape::Mesh degenerate = sphere;
  AddTriangle(degenerate, first(0), first(0), first(1));
  const shape::RepairedSheets without = shape::RepairSheets(degenerate);
  ExpectOnly(without, sphere);
  EXPECT_EQ(without.DegenerateTriangles, 1);
}

// Two triangles back to back are a closed surface.
TEST(SheetRepair, APillowStays)
{
  shape::Mesh pillow{ Eigen::MatrixXd(3, 3), Eigen::MatrixXi(2, 3) };
  pillow.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  pillow.Triangles << 0, 1, 2, 0, 2, 1;
  EXPECT_FALSE(shape::RepairSheets(pillow).IsChanged());
}

TEST(SheetRepair, TheEndsOfAnEdgeWithoutLengthBecomeOne)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const std::vector<int> twins = shape::Surface(sphere).Twins();
  // The fan of point a is divided in two at its edges to b and d; the second half gets a copy of a,
  // and two triangles without area connect them.
  const int a = sphere.Triangles(9, 0), b = sphere.Triangles(9, 1);
  shape::Mesh mesh = sphere;
  const int copy = AddPoint(mesh, sphere.Points.row(a));
  int side = 27, d = -1;
  for (int step = 0; step < 3; ++step)
  {
    const int triangle = side / 3;
    d = sphere.Triangles(triangle, (side + 2) % 3);
    for (int k = 0; k < 3; ++k)
    {
      mesh.Triangles(triangle, k) =
        sphere.Triangles(triangle, k) == a ? copy : sphere.Triangles(triangle, k);
    }
    side = twins[shape::PreviousHalfEdge(side)];
  }
  AddTriangle(mesh, a, b, copy);
  AddTriangle(mesh, copy, d, a);
  ASSERT_EQ(shape::ComputeTopology(mesh).BoundaryLoops, 0);
  const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
  ExpectOnly(repaired, sphere);
  EXPECT_EQ(repaired.JoinedPoints, 1);
  EXPECT_EQ(repaired.DegenerateTriangles, 2);
  EXPECT_EQ(repaired.Representatives[copy], a);
  EXPECT_EQ(repaired.Representatives[a], a);
}

// Boxes that share an edge of 1 segment: each is closed afterwards, with its own volume.
TEST(SheetRepair, SolidsThatShareAnEdgeAreSeparated)
{
  const shape::Mesh one = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const shape::Mesh other = shapetest::Box({ 1, 1, 0 }, { 2, 3, 1 });
  const shape::Mesh mesh = MergePoints(shapetest::Joined({ one, other }));
  ASSERT_EQ(shape::ComputeTopology(mesh).NonManifoldEdges, 1);
  const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
  EXPECT_EQ(repaired.SplitPoints, 2);
  EXPECT_EQ(repaired.RemovedTriangles(), 0);
  EXPECT_EQ(shape::RequireClosedSurface(repaired.Surface, "the boxes").Components, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(repaired.Surface), 3.0, 1e-14);
  for (std::size_t i = 0; i < repaired.Points.size(); ++i)
  {
    EXPECT_EQ(repaired.Surface.Points.row(static_cast<Eigen::Index>(i)),
      mesh.Points.row(repaired.Points[i]));
  }
}

// A torus whose hole is closed at a point: its fans there are separated again.
TEST(SheetRepair, ASurfaceThatTouchesItselfIsSplit)
{
  shape::Mesh mesh = shapetest::Torus(1.0, 0.3, 24, 12);
  int left = 0, right = 0; // the points closest to the axis on both sides
  const auto score = [&](int i, double side)
  { return side * mesh.Points(i, 0) - 3.0 * mesh.Points.row(i).head(2).norm(); };
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    left = score(i, -1.0) > score(left, -1.0) ? i : left;
    right = score(i, 1.0) > score(right, 1.0) ? i : right;
  }
  ASSERT_NE(left, right);
  mesh.Points.row(left).setZero();
  mesh.Triangles =
    mesh.Triangles.unaryExpr([&](int point) { return point == right ? left : point; }).eval();
  ASSERT_EQ(shape::ComputeTopology(mesh).NonManifoldPoints, 1);
  const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
  EXPECT_EQ(repaired.SplitPoints, 1);
  EXPECT_EQ(repaired.FirstSplit, left);
  EXPECT_EQ(shape::RequireClosedSurface(repaired.Surface, "the torus").EulerNumber, 0);
}

// A chain of five cubes whose ends touch along an edge: one sheet meets itself there, and the
// wedges of the solid decide which triangles stay connected.
TEST(SheetRepair, ASolidThatTouchesItselfAlongAnEdgeIsSeparatedOutside)
{
  std::vector<shape::Mesh> cubes;
  for (const RowVector3d& low : { RowVector3d(0, 0, 0), RowVector3d(0, 0, 1), RowVector3d(1, 0, 1),
         RowVector3d(1, 1, 1), RowVector3d(1, 1, 0) })
  {
    cubes.push_back(shapetest::Box(low, low + RowVector3d::Ones()));
  }
  shape::Mesh mesh = MergePoints(shapetest::Joined(cubes));
  // Walls between cubes are two triangles on the same points.
  std::map<std::set<int>, std::vector<int>> sides;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const auto corners = mesh.Triangles.row(t);
    sides[{ corners(0), corners(1), corners(2) }].push_back(t);
  }
  std::vector<int> outer;
  for (const auto& [corners, triangles] : sides)
  {
    if (triangles.size() == 1)
    {
      outer.push_back(triangles.front());
    }
  }
  mesh.Triangles = mesh.Triangles(outer, Eigen::all).eval();
  ASSERT_EQ(outer.size(), 5 * 12 - 4 * 4);
  ASSERT_EQ(shape::ComputeTopology(mesh).NonManifoldEdges, 1);
  const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
  EXPECT_EQ(repaired.SplitPoints, 1);
  const shape::Topology topology = shape::RequireClosedSurface(repaired.Surface, "the solid");
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(repaired.Surface), 5.0, 1e-14);
}

// A wall across a sphere is no fin: it is larger than 1%. The hemispheres stay connected.
TEST(SheetRepair, AWallIsSeparated)
{
  const shape::Mesh disk = shapetest::FlatDisk(4);
  const auto boundary = [&](const RowVector3d& p) { return p.norm() > 1.0 - 1e-9; };
  shape::Mesh upper = disk, lower = shapetest::Reversed(disk);
  for (int i = 0; i < disk.Points.rows(); ++i)
  {
    const double height = std::sqrt(std::max(0.0, 1.0 - disk.Points.row(i).squaredNorm()));
    upper.Points(i, 2) = boundary(disk.Points.row(i)) ? 0.0 : height;
    lower.Points(i, 2) = -upper.Points(i, 2);
  }
  const shape::Mesh parts = shapetest::Joined({ upper, lower, disk });
  const auto n = static_cast<int>(disk.Points.rows());
  shape::Mesh mesh = parts;
  mesh.Triangles = parts.Triangles
                     .unaryExpr(
                       [&](int point)
                       {
                         return boundary(disk.Points.row(point % n)) && point >= n &&
                             std::abs(parts.Points(point, 2)) < 1e-9
                           ? point % n
                           : point;
                       })
                     .eval();
  ASSERT_GT(shape::ComputeTopology(mesh).NonManifoldEdges, 0);
  const shape::RepairedSheets repaired = shape::RepairSheets(mesh);
  EXPECT_EQ(repaired.RemovedTriangles(), 0);
  const shape::Topology topology = shape::RequireManifold(repaired.Surface, "the sphere");
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  EXPECT_EQ(topology.EulerNumber, 3); // a sphere and a disk
}
