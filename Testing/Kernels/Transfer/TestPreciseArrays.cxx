#include "Base/Errors.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"
#include "Transfer/PreciseArrays.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace
{

/// A sphere behind three vertices, its triangles in pairs of one polygon each.
shape::NumberedSurface Target()
{
  shape::NumberedSurface target{ shapetest::Icosphere(2), 3, {} };
  const int triangles = static_cast<int>(target.Surface.Triangles.rows());
  target.Cells = Eigen::VectorXi::LinSpaced(triangles, 0, triangles - 1) / 2;
  target.Cells.array() += 3;
  return target;
}

/// One place in each triangle, corner `t % 3` nearest.
shape::PreciseArrays PositionsOn(const shape::NumberedSurface& target)
{
  const auto m = static_cast<int>(target.Surface.Triangles.rows());
  shape::PreciseArrays arrays{ Eigen::VectorXd::LinSpaced(m, 3.0, m + 2.0),
    Eigen::MatrixXd::Constant(m, 3, 0.2), {} };
  for (int t = 0; t < m; ++t)
  {
    arrays.TargetBarycentric(t, t % 3) = 0.6;
  }
  const Eigen::VectorXi triangles = Eigen::VectorXi::LinSpaced(m, 0, m - 1);
  arrays.TargetPosition = shape::PullBack(
    { triangles, arrays.TargetBarycentric }, target.Surface.Triangles, target.Surface.Points);
  return arrays;
}

void Require(const shape::PreciseArrays& arrays, double tolerance = 0.01)
{
  shape::RequirePreciseMap(arrays, Target(), tolerance, "the Input", "the Source");
}

} // namespace

TEST(PreciseArrays, SayWhichTriangleWhichCellAndWhichCorner)
{
  const shape::NumberedSurface target = Target();
  const shape::PreciseArrays arrays = PositionsOn(target);
  const shape::SurfacePoints map =
    shape::RequirePreciseMap(arrays, target, 0.0, "the Input", "the Source");
  const shape::TransferWeights positions = shape::LocateOnTriangles(map, target);
  EXPECT_LT(
    (positions.Weights * target.Surface.Points - arrays.TargetPosition).cwiseAbs().maxCoeff(),
    1e-15);
  for (int t = 0; t < static_cast<int>(map.Triangles.size()); ++t)
  {
    EXPECT_EQ(map.Triangles(t), t);
    EXPECT_EQ(positions.Cells(t), 3 + t / 2);
    int nearest = 0;
    Eigen::RowVectorXd(positions.Weights.row(t)).maxCoeff(&nearest);
    EXPECT_EQ(nearest, target.Surface.Triangles(t, t % 3));
  }
  EXPECT_EQ(positions.Outside.sum(), 0);
}

TEST(PreciseArrays, SinglePrecisionDoesNotSpoilThem)
{
  shape::PreciseArrays arrays = PositionsOn(Target());
  arrays.TargetBarycentric = arrays.TargetBarycentric.cast<float>().cast<double>().eval();
  arrays.TargetPosition = arrays.TargetPosition.cast<float>().cast<double>().eval();
  EXPECT_NO_THROW(Require(arrays, 0.0));
}

TEST(PreciseArrays, WhatDoesNotFitTheTargetIsRefused)
{
  const shape::PreciseArrays good = PositionsOn(Target());
  ASSERT_NO_THROW(Require(good));
  const auto refused = [&](auto spoil, const std::string& words)
  {
    shape::PreciseArrays arrays = good;
    spoil(arrays);
    EXPECT_REFUSED(Require(arrays), words);
  };
  const auto cells = static_cast<double>(good.TargetCell.size());
  for (const double cell : { -1.0, 2.0, cells + 3.0, 5.5 })
  {
    refused([&](shape::PreciseArrays& a) { a.TargetCell(7) = cell; },
      "numbered 3 to 322, at 1 point (first at point 7); give the surface");
  }
  refused([](shape::PreciseArrays& a) { a.TargetBarycentric(4, 1) += 0.01; },
    "does not sum to 1 at 1 point (first at point 4)");
  refused([](shape::PreciseArrays& a) { a.TargetBarycentric.row(5) << 1.2, -0.2, 0.0; },
    "negative or does not sum to 1 at 1 point (first at point 5)");
  refused([](shape::PreciseArrays& a) { a.TargetCell = a.TargetCell.reverse().eval(); },
    "elsewhere on the Source than its TargetPosition says, at 320 points (first at point 0)");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](shape::PreciseArrays& a) { a.TargetCell(2) = nan; }, "TargetCell of the Input");
  refused([](shape::PreciseArrays& a) { a.TargetPosition(2, 2) = nan; }, "not finite");
  // A surface that was moved since is a matter of the tolerance.
  shape::PreciseArrays moved = good;
  moved.TargetPosition.array() += 0.05;
  EXPECT_THROW(Require(moved), shape::InvalidInput);
  EXPECT_NO_THROW(Require(moved, 0.1));
}
