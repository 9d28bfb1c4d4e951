#include "Distance/HausdorffDistance.h"
#include "Mesh/Surface.h"
#include "Mesh/UsedPoints.h"
#include "Solidify/Private/WrapSurface.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using Eigen::RowVector3d;

namespace
{

/// It bounds a solid with this Euler number. Returns its volume.
double ExpectWrap(const shape::Mesh& input, const shape::WrapSurfaceOptions& options, int euler)
{
  const shape::MendedSurface wrap = shape::WrapSurface(input, options);
  const shape::SurfaceDefects defects = shape::FindSurfaceDefects(wrap.Surface);
  EXPECT_TRUE(defects.Defects.empty());
  EXPECT_EQ(defects.EulerNumber, euler);
  EXPECT_EQ(wrap.Provenance.Weights.rows(), wrap.Surface.Points.rows());
  return shape::ComputeEnclosedVolume(wrap.Surface);
}

shape::Mesh Cube()
{
  return shapetest::Box(RowVector3d::Zero(), RowVector3d::Ones());
}

/// Unconnected triangles, every third one reversed.
shape::Mesh ToTangledSoup(const shape::Mesh& mesh)
{
  shape::Mesh soup{ Eigen::MatrixXd(3 * mesh.Triangles.rows(), 3), mesh.Triangles };
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(mesh, t);
    soup.Triangles.row(t) = Eigen::RowVector3i(0, 1, 2).array() + static_cast<int>(3 * t);
    if (t % 3 == 0)
    {
      std::swap(soup.Triangles(t, 1), soup.Triangles(t, 2));
    }
  }
  return soup;
}

} // namespace

TEST(WrapSurface, ASheetBecomesAPlate)
{
  // The square has sides of 2, and its points move along one normal.
  const shape::Mesh square = shapetest::FlatSquare(4, 0.0);
  EXPECT_NEAR(ExpectWrap(square, { {}, 0.05, 0.2 }, 2), 4.0 * 0.1 * 0.05, 1e-12);
  EXPECT_NEAR(ExpectWrap(square, { {}, 0.05, 0.2, 0.02 }, 2), 4.0 * 0.02, 1e-12);
  EXPECT_NEAR(ExpectWrap(ToTangledSoup(square), { {}, 0.05, 0.2, 0.02 }, 2), 4.0 * 0.02, 1e-12);
}

TEST(WrapSurface, PlatesThatCrossAreUnited)
{
  // Two squares whose middles cross at a right angle: both plates but for what they share.
  const shape::Mesh square = shapetest::FlatSquare(5, 0.0);
  shape::Mesh upright = square;
  upright.Points.col(2) = square.Points.col(1);
  upright.Points.col(1).setConstant(0.03);
  constexpr double thickness = 0.02;
  const double volume =
    ExpectWrap(shape::JoinMeshes({ square, upright }), { {}, 0.05, 0.2, thickness }, 2);
  EXPECT_NEAR(volume, 2.0 * 4.0 * thickness - 2.0 * thickness * thickness, 1e-9);
}

TEST(WrapSurface, APlateOfACurvedSheetHasTheDistanceOfHalfItsThickness)
{
  const shape::Mesh sheet = shapetest::SphereWithoutCap(3, 100);
  constexpr double thickness = 0.01;
  const shape::MendedSurface wrap = shape::WrapSurface(sheet, { {}, 0.05, 0.2, thickness });
  EXPECT_TRUE(shape::FindSurfaceDefects(wrap.Surface).Defects.empty());
  EXPECT_EQ(wrap.GridSpacing, 0.0);
  const shape::HausdorffDistances distances = shape::ComputeHausdorffDistance(sheet, wrap.Surface);
  EXPECT_LE(distances.Larger(), 0.5 * thickness * (1.0 + 1e-9));
  EXPECT_GT(distances.Larger(), 0.49 * thickness);
}

TEST(WrapSurface, ASheetBesideASolidBecomesAThickPlate)
{
  // The square has sides of 2; the plate is 1.8 times the spacing thick, and rounded at the border.
  constexpr double spacing = 0.05, half = 0.9 * spacing;
  const shape::Mesh both = shape::JoinMeshes(
    { shapetest::FlatSquare(4, 0.0), shapetest::Shifted(Cube(), { -0.5, -0.5, 0.31 }) });
  const double volume = ExpectWrap(both, { {}, spacing, 0.2 }, 4) - 1.0;
  const double plate = 4.0 * 2.0 * half, border = 8.0 * 0.5 * M_PI * half * half;
  EXPECT_NEAR(volume, plate + border, 0.05 * plate);
}

TEST(WrapSurface, TheCreasesOfABoxStay)
{
  EXPECT_NEAR(ExpectWrap(ToTangledSoup(Cube()), { {}, 0.043, 0.2 }, 2), 1.0, 1e-9);
}

TEST(WrapSurface, GapsUpToTheSizeAreClosed)
{
  // A box with a slit of the width 0.1 in its top. Wrapped with a larger gap size, it is full; with
  // a smaller one, the air enters, and only the walls are left.
  shape::Mesh box = shapetest::WithoutLast(Cube(), 0);
  const shape::Mesh left = shapetest::Box(RowVector3d::Zero(), RowVector3d(0.45, 1.0, 1.0));
  const shape::Mesh right = shapetest::Box(RowVector3d(0.55, 0.0, 0.0), RowVector3d::Ones());
  const auto isTop = [](const RowVector3d& centre) { return centre(2) > 0.999; };
  const auto isNoTop = [](const RowVector3d& centre) { return centre(2) < 0.999; };
  const shape::Mesh slit = shapetest::Joined({ shapetest::Without(box, isTop),
    shapetest::Without(left, isNoTop), shapetest::Without(right, isNoTop) });
  EXPECT_GT(ExpectWrap(slit, { {}, 0.05, 0.2 }, 2), 0.98);
  const shape::MendedSurface open = shape::WrapSurface(slit, { {}, 0.02, 0.05 });
  EXPECT_LT(shape::ComputeEnclosedVolume(open.Surface), 0.4);
}

TEST(WrapSurface, ASoupOfASphereWithAHoleBecomesABall)
{
  const double ball = 4.0 / 3.0 * M_PI;
  const shape::Mesh soup = ToTangledSoup(shapetest::SphereWithoutCap(4, 5.0));
  EXPECT_NEAR(ExpectWrap(soup, { {}, 0.1, 0.5 }, 2), ball, 0.01 * ball);
}

TEST(WrapSurface, TheHoleOfATorusStays)
{
  const shape::Mesh torus = ToTangledSoup(shapetest::Torus(1.0, 0.4, 60, 30));
  ExpectWrap(torus, { {}, 0.1, 0.3 }, 0);
}

TEST(WrapSurface, RefusesOptionsOutOfRange)
{
  EXPECT_REFUSED(shape::WrapSurface(Cube(), { {}, 0.1, 0.1 }), "GapSize is 0.1", "DetailSize");
  EXPECT_REFUSED(shape::WrapSurface(Cube(), { {}, 1e-5, 0.0 }), "points", "raise DetailSize");
}
