#include "Mesh/Surface.h"
#include "Solidify/Private/ClosedDraft.h"
#include "Solidify/Private/SolidSurface.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using Eigen::RowVector3d;
using shape::TriangleOrigin;

namespace
{

int CountFrom(const shape::MendedSurface& solid, TriangleOrigin origin)
{
  return static_cast<int>((solid.Origin.array() == static_cast<int>(origin)).count());
}

/// It bounds a solid with this volume and Euler number; kept triangles are those of the input.
shape::MendedSurface ExpectUnion(
  const shape::Mesh& input, double volume, double tolerance, int euler)
{
  shape::MendedSurface solid = shape::MakeSolid(input);
  const shape::SurfaceDefects defects = shape::FindSurfaceDefects(solid.Surface);
  EXPECT_TRUE(defects.Defects.empty());
  EXPECT_EQ(defects.EulerNumber, euler);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(solid.Surface), volume, tolerance);
  EXPECT_EQ(solid.Provenance.Weights.rows(), solid.Surface.Points.rows());
  EXPECT_EQ(solid.Provenance.Cells.size(), solid.Surface.Triangles.rows());
  for (Eigen::Index t = 0; t < solid.Origin.size(); ++t)
  {
    if (solid.Origin(t) == static_cast<int>(TriangleOrigin::Kept))
    {
      EXPECT_EQ(
        shape::GetCorners(solid.Surface, t), shape::GetCorners(input, solid.Provenance.Cells(t)));
    }
  }
  return solid;
}

/// Every triangle lies in a plane x, y or z = constant, to 1e-9.
void ExpectOrthogonal(const shape::Mesh& mesh)
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    const RowVector3d spread = corners.colwise().maxCoeff() - corners.colwise().minCoeff();
    EXPECT_LT(spread.minCoeff(), 1e-9);
  }
}

shape::Mesh UnitBox()
{
  return shapetest::Box(RowVector3d::Zero(), RowVector3d::Ones());
}

/// 12 quads, in 24 triangles.
shape::Mesh MoebiusStrip()
{
  constexpr int count = 12;
  shape::Mesh strip{ Eigen::MatrixXd(2 * count, 3), Eigen::MatrixXi(2 * count, 3) };
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    const RowVector3d radial(std::cos(angle), std::sin(angle), 0.0);
    const RowVector3d across =
      std::cos(0.5 * angle) * radial + std::sin(0.5 * angle) * RowVector3d::UnitZ();
    strip.Points.row(2 * i) = radial - 0.3 * across;
    strip.Points.row(2 * i + 1) = radial + 0.3 * across;
    const int a = 2 * i, b = a + 1;
    const int c = i + 1 < count ? a + 2 : 1, d = i + 1 < count ? a + 3 : 0;
    strip.Triangles.row(2 * i) << a, c, b;
    strip.Triangles.row(2 * i + 1) << b, c, d;
  }
  return strip;
}

} // namespace

TEST(SolidSurface, CrossingBoxesBecomeTheirUnion)
{
  const RowVector3d shift(0.5, 0.3, 0.4);
  const shape::MendedSurface solid =
    ExpectUnion(shapetest::Twice(UnitBox(), shift), 2.0 - 0.5 * 0.7 * 0.6, 1e-9, 2);
  ExpectOrthogonal(solid.Surface);
  EXPECT_EQ(solid.GridSpacing, 0.0);
  EXPECT_EQ(CountFrom(solid, TriangleOrigin::Made), 0);
  // The three faces at the corner of each box that is outside the other are not crossed.
  EXPECT_GE(CountFrom(solid, TriangleOrigin::Kept), 12);
}

TEST(SolidSurface, CoplanarFacesAreUnited)
{
  // Two faces of each lie in the same planes and overlap.
  const shape::Mesh beam = shapetest::Box(RowVector3d(0.5, 0.25, 0.0), RowVector3d(1.5, 0.75, 1.0));
  ExpectOrthogonal(ExpectUnion(shapetest::Joined({ UnitBox(), beam }), 1.25, 1e-9, 2).Surface);
  // A face of one is a part of a face of the other.
  const shape::Mesh knob =
    shapetest::Box(RowVector3d(1.0, 0.25, 0.25), RowVector3d(2.0, 0.75, 0.75));
  ExpectOrthogonal(ExpectUnion(shapetest::Joined({ UnitBox(), knob }), 1.25, 1e-9, 2).Surface);
  // The same box twice.
  ExpectUnion(shapetest::Joined({ UnitBox(), UnitBox(), beam }), 1.25, 1e-9, 2);
}

TEST(SolidSurface, ObliqueBoxesBecomeTheirUnion)
{
  // A bar of the width 0.2 passes through the centre of the box and leaves through two faces. The
  // volumes of its parts outside are prisms, whose mean length decides.
  shape::Mesh bar = shapetest::Box(RowVector3d(-2.0, -0.1, -0.1), RowVector3d(2.0, 0.1, 0.1));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  bar.Points = (bar.Points * turn.transpose()).eval();
  bar = shapetest::Shifted(bar, RowVector3d::Constant(0.5));
  const double inside = 0.04 / std::cos(0.3);
  const shape::MendedSurface solid =
    ExpectUnion(shapetest::Joined({ UnitBox(), bar }), 1.0 + 4.0 * 0.04 - inside, 1e-9, 2);
  EXPECT_EQ(solid.GridSpacing, 0.0);
}

TEST(SolidSurface, AVoidStaysWhereAnotherPartCrossesItsShell)
{
  const shape::Mesh shell = shapetest::Joined(
    { shapetest::Sphere(3, 2.0), shapetest::Reversed(shapetest::Sphere(3, 1.0)) });
  const shape::Mesh knob =
    shapetest::Box(RowVector3d(1.5, -0.21, -0.22), RowVector3d(3.0, 0.23, 0.24));
  const double hollow = shape::ComputeEnclosedVolume(shell);
  const shape::MendedSurface solid = shape::MakeSolid(shapetest::Joined({ shell, knob }));
  const shape::SurfaceDefects defects = shape::FindSurfaceDefects(solid.Surface);
  EXPECT_TRUE(defects.Defects.empty());
  EXPECT_EQ(defects.Pieces, 2);
  EXPECT_EQ(defects.EulerNumber, 4);
  const double volume = shape::ComputeEnclosedVolume(solid.Surface);
  EXPECT_GT(volume, hollow);
  EXPECT_LT(volume, hollow + shape::ComputeEnclosedVolume(knob));
  EXPECT_EQ(CountFrom(solid, TriangleOrigin::Made), 0);
}

TEST(SolidSurface, FinsOfCrossingPartsAreRemoved)
{
  // A triangle stands on an edge of each box, inside the other one. There, rays cross both boxes.
  const shape::Mesh fin = { (Eigen::Matrix3d() << 1, 1, 0, 1, 1, 1, 0.8, 0.8, 0.6).finished(),
    Eigen::RowVector3i(0, 1, 2) };
  shape::Mesh other = fin;
  other.Points = -fin.Points.array() + 1.6;
  const shape::Mesh moved = shapetest::Box(RowVector3d::Constant(0.6), RowVector3d::Constant(1.6));
  const shape::MendedSurface solid = ExpectUnion(
    shapetest::Joined({ UnitBox(), fin, moved, other }), 2.0 - 0.4 * 0.4 * 0.4, 1e-9, 2);
  EXPECT_EQ(solid.GridSpacing, 0.0);
  EXPECT_EQ(solid.GapsClosed, 0);
}

TEST(SolidSurface, TheHoleOfATorusStays)
{
  // A knob on the outer side of the tube.
  const shape::Mesh torus = shapetest::Torus(2.0, 0.5, 40, 20);
  const shape::Mesh knob =
    shapetest::Box(RowVector3d(2.2, -0.21, -0.22), RowVector3d(3.0, 0.23, 0.24));
  const shape::MendedSurface solid = shape::MakeSolid(shapetest::Joined({ torus, knob }));
  const shape::SurfaceDefects defects = shape::FindSurfaceDefects(solid.Surface);
  EXPECT_TRUE(defects.Defects.empty());
  EXPECT_EQ(defects.EulerNumber, 0);
}

TEST(SolidSurface, AFlippedPatchIsReversed)
{
  shape::Mesh box = UnitBox();
  for (const int t : { 2, 3, 8 })
  {
    std::swap(box.Triangles(t, 1), box.Triangles(t, 2));
  }
  const shape::MendedSurface solid = ExpectUnion(box, 1.0, 1e-12, 2);
  EXPECT_EQ(CountFrom(solid, TriangleOrigin::Kept), 9);
  EXPECT_EQ(CountFrom(solid, TriangleOrigin::Mended), 3);
}

TEST(SolidSurface, InvertedPartsAreUnited)
{
  const shape::Mesh ball = shapetest::Reversed(shapetest::Sphere(2, 1.0));
  const shape::MendedSurface solid =
    shape::MakeSolid(shapetest::Twice(ball, RowVector3d(0.1, 0.07, 0.03)));
  EXPECT_TRUE(shape::FindSurfaceDefects(solid.Surface).Defects.empty());
  EXPECT_GT(shape::ComputeEnclosedVolume(solid.Surface), -shape::ComputeEnclosedVolume(ball));
}

TEST(SolidSurface, ASphereWithSlitsIsNoSheet)
{
  // Cones over the slits would be larger than the sphere, but the slits are narrow.
  const shape::Mesh slits = shapetest::Without(shapetest::Icosphere(4),
    [](const RowVector3d& centre)
    { return centre(0) < 0.5 && std::abs(std::remainder(centre(2), 0.3)) < 0.03; });
  ASSERT_LT(slits.Triangles.rows(), 0.9 * shapetest::Icosphere(4).Triangles.rows());
  EXPECT_NO_THROW(shape::RequireNoSheets(slits));
}

TEST(SolidSurface, RefusesWhatEnclosesNothing)
{
  const shape::Mesh sheet = shapetest::FlatSquare(4, 0.0);
  EXPECT_REFUSED(shape::MakeSolid(sheet), "is empty", "1 sheet(s)", "enclose nothing", "Wrap");
  // Beside a box, a sheet of 4 % of the area must not be lost; one of 0.4 % may be.
  const auto withSheet = [&](double side)
  {
    shape::Mesh small = sheet;
    small.Points *= side / (sheet.Points.col(0).maxCoeff() - sheet.Points.col(0).minCoeff());
    return shapetest::Joined({ UnitBox(), shapetest::Shifted(small, { 3.0, 0.0, 0.0 }) });
  };
  EXPECT_REFUSED(shape::MakeSolid(withSheet(0.5)), "lacks 4 %", "Wrap");
  EXPECT_NO_THROW(shape::MakeSolid(withSheet(0.16)));
  // It has one side, so a grid is needed.
  EXPECT_REFUSED(shape::MakeSolid(MoebiusStrip(), { {}, 1e-6 }), "points", "raise DetailSize");
}
