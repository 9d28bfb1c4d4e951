#include "Solidify/SurfaceDefects.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>

namespace
{

using shape::DefectKind;
using Kinds = std::map<DefectKind, int>;

/// The numbers of all defects that occur.
Kinds CountsOf(const shape::SurfaceDefects& found)
{
  Kinds counts;
  for (const shape::SurfaceDefect& defect : found.Defects)
  {
    ++counts[defect.Kind];
  }
  for (const auto& [kind, count] : counts)
  {
    EXPECT_EQ(found.Count(kind), count);
  }
  return counts;
}

Kinds CountsOf(const shape::Mesh& surface, const shape::SurfaceDefectOptions& options = {})
{
  return CountsOf(shape::FindSurfaceDefects(surface, options));
}

/// Adds a triangle.
shape::Mesh With(shape::Mesh mesh, const Eigen::RowVector3i& triangle)
{
  mesh.Triangles.conservativeResize(mesh.Triangles.rows() + 1, 3);
  mesh.Triangles.bottomRows(1) = triangle;
  return mesh;
}

shape::Mesh WithPoint(shape::Mesh mesh, const Eigen::RowVector3d& point)
{
  mesh.Points.conservativeResize(mesh.Points.rows() + 1, 3);
  mesh.Points.bottomRows(1) = point;
  return mesh;
}

/// No two triangles share a point.
shape::Mesh Soup(const shape::Mesh& mesh)
{
  shape::Mesh soup{ Eigen::MatrixXd(3 * mesh.Triangles.rows(), 3), mesh.Triangles };
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(mesh, t);
    soup.Triangles.row(t) << static_cast<int>(3 * t), static_cast<int>(3 * t + 1),
      static_cast<int>(3 * t + 2);
  }
  return soup;
}

const Eigen::RowVector3d Zero = Eigen::RowVector3d::Zero(), One = Eigen::RowVector3d::Ones();

} // namespace

TEST(SurfaceDefects, ARightSurfaceHasNone)
{
  // A solid with a void in it, and a second solid.
  const shape::Mesh solid = shapetest::Joined({ shapetest::Sphere(2, 2.0),
    shapetest::Reversed(shapetest::Sphere(2, 1.0)), shapetest::Sphere(1, 1.0, 5.0 * One) });
  const shape::SurfaceDefects found = shape::FindSurfaceDefects(solid);
  EXPECT_EQ(CountsOf(found), Kinds());
  EXPECT_EQ(found.Pieces, 3);
  EXPECT_EQ(found.EulerNumber, 6);
}

TEST(SurfaceDefects, EachKindIsCountedWhereItIs)
{
  const shape::Mesh box = shapetest::Box(Zero, One);
  EXPECT_EQ(CountsOf(shapetest::WithoutLast(box)), (Kinds{ { DefectKind::OpenLoop, 1 } }));
  EXPECT_EQ(CountsOf(shapetest::Reversed(box)), (Kinds{ { DefectKind::InvertedPiece, 1 } }));
  EXPECT_EQ(CountsOf(WithPoint(box, 2.0 * One)), (Kinds{ { DefectKind::LoosePoint, 1 } }));
  EXPECT_EQ(
    CountsOf(With(box, box.Triangles.row(3))), (Kinds{ { DefectKind::DuplicateTriangle, 1 } }));
  EXPECT_EQ(CountsOf(With(box, { 0, 0, 1 })), (Kinds{ { DefectKind::DegenerateTriangle, 1 } }));
  // A soup of 36 corners at 8 positions.
  EXPECT_EQ(CountsOf(Soup(box)), (Kinds{ { DefectKind::DuplicatePoint, 28 } }));
  EXPECT_EQ(CountsOf(box, { 0.0, 1.5 }), (Kinds{ { DefectKind::SmallPiece, 1 } }));
  // One reversed triangle has three edges in the same direction as its neighbours.
  shape::Mesh reversed = box;
  std::swap(reversed.Triangles(5, 1), reversed.Triangles(5, 2));
  EXPECT_EQ(CountsOf(reversed), (Kinds{ { DefectKind::MisorientedEdge, 3 } }));
  // A fin on an edge.
  const shape::SurfaceDefects fin =
    shape::FindSurfaceDefects(With(WithPoint(box, { 0.5, -1.0, -1.0 }), { 0, 1, 8 }));
  EXPECT_EQ(
    CountsOf(fin), (Kinds{ { DefectKind::NonManifoldEdge, 1 }, { DefectKind::OpenLoop, 1 } }));
  EXPECT_EQ(fin.Defects[0].Position, Eigen::RowVector3d(0.5, 0.0, 0.0));
  // Two boxes that share a corner.
  const shape::Mesh kiss = shapetest::Joined({ box, shapetest::Box(One, 2.0 * One) });
  EXPECT_EQ(CountsOf(kiss),
    (Kinds{ { DefectKind::DuplicatePoint, 1 }, { DefectKind::NonManifoldPoint, 1 } }));
  // Two spheres that cross.
  const shape::SurfaceDefects crossed = shape::FindSurfaceDefects(
    shapetest::Joined({ shapetest::Sphere(2, 1.0), shapetest::Sphere(2, 1.0, 0.5 * One) }));
  EXPECT_GT(crossed.Count(DefectKind::SelfIntersection), 20);
  EXPECT_EQ(CountsOf(crossed).size(), 1u);
  for (const shape::SurfaceDefect& defect : crossed.Defects)
  {
    EXPECT_NEAR(defect.Position.sum(), 0.75, 0.2); // the plane halfway between the centres
  }
}

TEST(SurfaceDefects, PointsThatAreNotFiniteAreLeftOut)
{
  shape::Mesh box = shapetest::Box(Zero, One);
  box.Points(7, 1) = std::numeric_limits<double>::quiet_NaN();
  const shape::SurfaceDefects found = shape::FindSurfaceDefects(box);
  EXPECT_EQ(CountsOf(found), (Kinds{ { DefectKind::NotFinite, 1 }, { DefectKind::OpenLoop, 1 } }));
  EXPECT_TRUE(found.Defects[0].Position.allFinite());
}

TEST(SurfaceDefects, TheToleranceIsALength)
{
  shape::Mesh soup = Soup(shapetest::Sphere(2, 10.0));
  for (Eigen::Index i = 0; i < soup.Points.rows(); ++i)
  {
    soup.Points(i, i % 3) += 0.01 * static_cast<double>(i % 7) / 7.0;
  }
  EXPECT_GT(CountsOf(soup)[DefectKind::OpenLoop], 100);
  EXPECT_EQ(CountsOf(soup, { 0.05, 0.0 }),
    (Kinds{ { DefectKind::DuplicatePoint, static_cast<int>(soup.Points.rows()) - 162 } }));
}

TEST(SurfaceDefects, RefusesOptionsAndIndices)
{
  const shape::Mesh box = shapetest::Box(Zero, One);
  EXPECT_REFUSED(shape::FindSurfaceDefects(box, { -1.0, 0.0 }), "Tolerance is -1");
  EXPECT_REFUSED(shape::FindSurfaceDefects(box, { 0.0, -1.0 }), "SmallestPiece is -1");
  EXPECT_REFUSED(shape::FindSurfaceDefects(With(box, { 0, 1, 99 })), "triangle 12");
}
