#include "Mesh/UsedPoints.h"
#include "Solidify/Solidify.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <vector>

using shape::SolidifyMethod;

TEST(Solidify, ARightSurfaceIsReturnedBitForBit)
{
  // With a void, as a file may have it: the inner component first.
  const shape::Mesh solid = shapetest::Joined(
    { shapetest::Reversed(shapetest::Sphere(2, 1.0)), shapetest::Sphere(2, 2.0) });
  for (const SolidifyMethod method : { SolidifyMethod::Automatic, SolidifyMethod::Report,
         SolidifyMethod::Mend, SolidifyMethod::Solid })
  {
    const shape::SolidifyResult result = shape::Solidify(solid, { method, {} });
    EXPECT_EQ(result.Method, SolidifyMethod::Report);
    EXPECT_EQ(result.Mended.Surface.Points, solid.Points);
    EXPECT_EQ(result.Mended.Surface.Triangles, solid.Triangles);
    EXPECT_EQ(result.Mended.Origin.cwiseAbs().sum(), 0);
    EXPECT_EQ(result.Pieces, 2);
    EXPECT_EQ(result.EulerNumber, 4);
    EXPECT_EQ(result.Distances.Larger(), 0.0);
  }
}

TEST(Solidify, ReportChangesNothing)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(3, 40);
  const shape::SolidifyResult result = shape::Solidify(open, { SolidifyMethod::Report, {} });
  EXPECT_EQ(result.Mended.Surface.Points, open.Points);
  EXPECT_EQ(result.Mended.Surface.Triangles, open.Triangles);
  EXPECT_EQ(result.Defects.Count(shape::DefectKind::OpenLoop), 1);
}

TEST(Solidify, DistancesGoBothWays)
{
  // The input is a part of the result. The pole of the fill is as far from the input as from the
  // nearest point of the loop.
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 40);
  const shape::SolidifyResult result = shape::Solidify(open);
  EXPECT_EQ(result.Method, SolidifyMethod::Mend);
  EXPECT_EQ(result.Defects.EulerNumber, 1);
  EXPECT_EQ(result.EulerNumber, 2);
  EXPECT_LT(result.Distances.FromFirst, 1e-12);
  const std::vector<int> used = shape::FindUsedPoints(open.Triangles, open.Points.rows());
  const Eigen::MatrixXd points = open.Points(used, Eigen::all);
  const double nearest = (points.rowwise() - shapetest::CapAxis()).rowwise().norm().minCoeff();
  EXPECT_NEAR(result.Distances.FromSecond, nearest, 0.01);
}

TEST(Solidify, AutomaticTakesTheFirstMethodThatSucceeds)
{
  const shape::Mesh box = shapetest::Box(Eigen::RowVector3d::Zero(), Eigen::RowVector3d::Ones());
  EXPECT_EQ(shape::Solidify(shapetest::WithoutLast(box)).Method, SolidifyMethod::Mend);
  const shape::Mesh crossing = shapetest::Twice(box, Eigen::RowVector3d::Constant(0.4));
  EXPECT_EQ(shape::Solidify(crossing).Method, SolidifyMethod::Solid);
  shape::SolidifyOptions coarse;
  coarse.DetailSize = 0.1;
  const shape::SolidifyResult plate =
    shape::Solidify(shapetest::WithoutLast(shapetest::FlatSquare(1, 0.0)), coarse);
  EXPECT_EQ(plate.Method, SolidifyMethod::Wrap);
  EXPECT_EQ(shape::Solidify(shapetest::FlatSquare(4, 0.0), coarse).Method, SolidifyMethod::Wrap);
  EXPECT_EQ(plate.EulerNumber, 2);
}

TEST(Solidify, RefusesLengthsOutOfRange)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(3, 40);
  for (const SolidifyMethod method : { SolidifyMethod::Automatic, SolidifyMethod::Mend,
         SolidifyMethod::Solid, SolidifyMethod::Wrap })
  {
    EXPECT_REFUSED(shape::Solidify(open, { method, {}, -1.0, 0.0 }), "DetailSize is -1");
    EXPECT_REFUSED(shape::Solidify(open, { method, {}, 0.0, -1.0 }), "GapSize is -1");
  }
}
