#include "Base/Errors.h"
#include "Geodesics/SurfaceLoop.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

namespace
{

Eigen::MatrixXd Square()
{
  Eigen::MatrixXd points(6, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 5, 5, 5;
  return points;
}

} // namespace

TEST(ClosedCurves, OneThatEndsWhereItBegins)
{
  // By its number, or by its place.
  for (const int last : { 0, 4 })
  {
    const auto curves = shape::ChainClosedCurves(Square(), { { 0, 1, 1, 2, 3, last } }, "the Loop");
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0], Square().topRows(4));
  }
}

TEST(ClosedCurves, LinesInAnyOrderAndSense)
{
  const auto curves =
    shape::ChainClosedCurves(Square(), { { 0, 1 }, { 3, 2 }, { 2, 1 }, { 3, 4 } }, "the Loop");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0], Square().topRows(4));
}

TEST(ClosedCurves, TwoThatShareAPoint)
{
  Eigen::MatrixXd points(5, 3);
  points << 0, 0, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, -1, -1, 0;
  const auto curves = shape::ChainClosedCurves(
    points, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 3, 4 }, { 4, 0 } }, "the Loop");
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].rows(), 3);
  EXPECT_EQ(curves[1].rows(), 3);
}

TEST(ClosedCurves, AnOpenOneIsNamed)
{
  EXPECT_REFUSED(shape::ChainClosedCurves(Square(), { { 0, 1, 2, 0 }, { 3, 5 } }, "the Loop"),
    "the Loop has an open curve, which ends at (5, 5, 5)");
  EXPECT_TRUE(shape::ChainClosedCurves(Square(), {}, "the Loop").empty());
}
