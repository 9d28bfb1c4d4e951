#include "Base/Errors.h"
#include "Harmonic/ChargeSet.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

shape::ChargeSet SomeCharges(int count)
{
  shape::ChargeSet set;
  set.Points = 2.0 * shapetest::Icosphere(2).Points.topRows(count);
  set.Charges = Eigen::MatrixXd::NullaryExpr(
    count, 3, [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + 3.0 * i + 7.0 * j); });
  set.Affine << 1, 0.2, 0, 3, 0, 0.9, 0.1, -2, 0.3, 0, 1.1, 0.5;
  return set;
}

} // namespace

TEST(ChargeSet, IsTheFormula)
{
  const shape::ChargeSet set = SomeCharges(40);
  const Eigen::MatrixXd points = 0.7 * shapetest::Icosphere(1).Points;
  const Eigen::MatrixXd values = shape::Evaluate(set, points);
  const Eigen::MatrixXd product = shape::BuildPotentialMatrix(points, set.Points) * set.Charges;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    Eigen::RowVector3d expected =
      points.row(i) * set.Affine.leftCols<3>().transpose() + set.Affine.col(3).transpose();
    for (Eigen::Index j = 0; j < set.Points.rows(); ++j)
    {
      expected += set.Charges.row(j) / (4.0 * M_PI * (points.row(i) - set.Points.row(j)).norm());
    }
    EXPECT_LT((values.row(i) - expected).norm(), 1e-13);
    EXPECT_LT((product.row(i) + points.row(i) * set.Affine.leftCols<3>().transpose() +
                set.Affine.col(3).transpose() - expected)
                .norm(),
      1e-13);
  }
}

TEST(ChargeSet, ItsMeanOverASmallSphereIsItsValueAtTheCentre)
{
  const shape::ChargeSet set = SomeCharges(80);
  const Eigen::RowVector3d centre(0.3, -0.4, 0.2);
  // The icosahedron's 12 points integrate polynomials of degree 5 exactly: the error is O(r^6).
  const auto error = [&](double radius)
  {
    const Eigen::MatrixXd sphere = (radius * shapetest::Icosphere(0).Points).rowwise() + centre;
    return (shape::Evaluate(set, sphere).colwise().mean() - shape::Evaluate(set, centre)).norm();
  };
  EXPECT_LT(error(0.1), 1e-6);
  EXPECT_GT(error(0.4) / error(0.2), 32.0);
}

TEST(ChargeSet, AgreesBitForBitForAnyNumberOfThreads)
{
  const shape::ChargeSet set = SomeCharges(100);
  const Eigen::MatrixXd points = shapetest::Icosphere(4).Points;
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const Eigen::MatrixXd one = shape::Evaluate(set, points);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const Eigen::MatrixXd two = shape::Evaluate(set, points);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one, two);
  // Nor does a point's value depend on which points stand beside it.
  EXPECT_EQ(shape::Evaluate(set, points.middleRows(77, 5)), one.middleRows(77, 5));
}

TEST(ChargeSet, WithoutChargesIsAffineAndCanBeAborted)
{
  shape::ChargeSet set;
  const Eigen::MatrixXd points = shapetest::Icosphere(1).Points;
  EXPECT_EQ(shape::Evaluate(set, points), points);
  EXPECT_THROW(
    shape::Evaluate(set, points, shape::Progress([](double) { return false; })), shape::Aborted);
}
