#include "Base/Errors.h"
#include "Correspondence/Transport/Coupling.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// Three limbs of different lengths that meet at the origin, as lines between points.
const Eigen::Matrix3d Limbs =
  (Eigen::Matrix3d() << 3.0, 0.0, 0.0, -1.0, 1.8, 0.0, -0.5, -1.1, 0.3).finished();

shape::ShapeElements CurveNetwork(int pieces)
{
  shape::ShapeElements shape{ Eigen::MatrixXd::Zero(1 + 3 * pieces, 3),
    Eigen::MatrixXi(3 * pieces, 2), {}, {} };
  for (int limb = 0; limb < 3; ++limb)
  {
    for (int i = 1; i <= pieces; ++i)
    {
      const int point = limb * pieces + i;
      shape.Points.row(point) = Limbs.row(limb) * i / pieces;
      shape.Lines.row(point - 1) << (i == 1 ? 0 : point - 1), point;
    }
  }
  return shape;
}

/// Points on thin tubes around the limbs.
shape::ShapeElements TubePoints(int pieces, int around, double radius)
{
  shape::ShapeElements shape{ Eigen::MatrixXd(3 * pieces * around, 3), {}, {}, {} };
  int point = 0;
  for (int limb = 0; limb < 3; ++limb)
  {
    const Eigen::Vector3d axis = Limbs.row(limb).normalized(), side = axis.unitOrthogonal(),
                          up = axis.cross(side);
    for (int i = 0; i < pieces; ++i)
    {
      for (int k = 0; k < around; ++k)
      {
        const double angle = 2.0 * M_PI * (k + 0.5 * (i % 2)) / around;
        shape.Points.row(point++) = Limbs.row(limb) * (i + 0.5) / pieces +
          radius * (std::cos(angle) * side + std::sin(angle) * up).transpose();
      }
    }
  }
  return shape;
}

} // namespace

TEST(ShapeCoupling, PointsOfATubeGoToItsCentreline)
{
  const shape::ShapeElements tube = TubePoints(30, 8, 0.1), curve = CurveNetwork(40);
  const auto found = shape::CoupleShapes(tube, curve, {});
  for (Eigen::Index i = 0; i < tube.Points.rows(); ++i)
  {
    const double away = (curve.Points.row(found.ImagesOfA(i)) - tube.Points.row(i)).norm();
    EXPECT_LT(away, 0.5) << i; // another limb would be farther, except near the centre
  }
  Eigen::VectorXd away(curve.Points.rows());
  for (Eigen::Index i = 0; i < away.size(); ++i)
  {
    away(i) = (tube.Points.row(found.ImagesOfB(i)) - curve.Points.row(i)).norm();
  }
  EXPECT_LT(away.mean(), 0.25);
}

TEST(ShapeCoupling, ACopyInOtherNumbersAndAnotherSizeIsFoundPointByPoint)
{
  const shape::Mesh mesh = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  const shapetest::Renumbered copy = shapetest::Renumber(mesh, 7);
  const Eigen::Matrix3d turn = shapetest::Rotation(1.0, { 1, 2, 3 });
  // The surface against its points and triangles elsewhere, twice as large.
  const shape::ShapeElements a{ mesh.Points, {}, mesh.Triangles, {} },
    b{ 2.0 * copy.Mesh.Points * turn.transpose(), {}, copy.Mesh.Triangles, {} };
  const auto found = shape::CoupleShapes(a, b, {});
  int exact = 0;
  for (int i = 0; i < static_cast<int>(mesh.Points.rows()); ++i)
  {
    exact += found.ImagesOfA(i) == copy.NewOf(i) ? 1 : 0;
  }
  EXPECT_GE(exact, 0.95 * static_cast<double>(mesh.Points.rows()));
  EXPECT_LT(found.Distortion, 0.05);
  EXPECT_LT((found.Coupling.Masses.rowwise().sum() - found.Coupling.WeightsOfA).lpNorm<1>(),
    found.Error + 1e-9);
}

TEST(ShapeCoupling, LandmarksDecideBetweenTheEndsOfALine)
{
  shape::ShapeElements line{ Eigen::MatrixXd::Zero(41, 3), Eigen::MatrixXi(40, 2), {}, {} };
  for (int i = 0; i <= 40; ++i)
  {
    line.Points(i, 0) = 0.1 * i;
  }
  for (int i = 0; i < 40; ++i)
  {
    line.Lines.row(i) << i, i + 1;
  }
  for (const bool isTurned : { false, true })
  {
    const auto found = shape::CoupleShapes(line, line, { { 0, isTurned ? 40 : 0 } });
    for (int i = 0; i <= 40; ++i)
    {
      EXPECT_NEAR(found.ImagesOfA(i), isTurned ? 40 - i : i, 1) << i;
    }
  }
}

TEST(ShapeCoupling, NamesWhatIsWrong)
{
  const shape::ShapeElements curve = CurveNetwork(5);
  shape::ShapeElements pieces = curve; // the middle line of a limb is missing
  pieces.Lines.row(2) = curve.Lines.row(1);
  EXPECT_REFUSED(shape::CoupleShapes(curve, pieces, {}), "ShapeB is in several pieces");
  shape::ShapeCouplingOptions options;
  options.Samples = 3;
  EXPECT_REFUSED(shape::CoupleShapes(curve, curve, {}, options), "Samples");
  EXPECT_REFUSED(shape::CoupleShapes(curve, curve, { { 0, 99 } }), "landmark 0 is point 99");
  // A pair that repeats a point is left out.
  EXPECT_NO_THROW(shape::CoupleShapes(curve, curve, { { 5, 5 }, { 5, 6 } }));
  shape::ShapeElements few = curve;
  few.Points = curve.Points.topRows(2);
  few.Lines = curve.Lines.topRows(1);
  EXPECT_REFUSED(shape::CoupleShapes(curve, few, {}), "ShapeB has 2 different points");
}
