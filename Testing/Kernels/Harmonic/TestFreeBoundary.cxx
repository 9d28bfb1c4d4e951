#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/FreeBoundary.h"
#include "Harmonic/VolumeMap.h"
#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// The ball's boundary turned around z by an angle that grows with z, and drawn towards +x, on it.
Eigen::MatrixXd Slid(const shape::Mesh& ball)
{
  Eigen::MatrixXd slid = ball.Points;
  for (Eigen::Index i = 0; i < slid.rows(); ++i)
  {
    const double angle = 0.9 * slid(i, 2);
    const double x = slid(i, 0), y = slid(i, 1);
    slid(i, 0) = std::cos(angle) * x - std::sin(angle) * y + 0.3;
    slid(i, 1) = std::sin(angle) * x + std::cos(angle) * y;
    slid.row(i).normalize();
  }
  return shape::SurfaceLocator(ball).Find(slid).Positions;
}

TEST(FreeBoundary, TakesBackASlideOfABallsBoundary)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const Eigen::MatrixXd targets = Slid(ball);
  const shape::HarmonicVolumeMapResult map = shape::ComputeHarmonicVolumeMap(ball, targets);
  const shape::FreeBoundaryResult result = shape::SlideBoundary(ball, targets, ball, {}, {}, map);
  EXPECT_TRUE(result.Kept);
  // Of an isometry the energy is 6: most of what is above it goes.
  EXPECT_GT(result.DistortionBefore, 6.5);
  EXPECT_LT(result.DistortionAfter - 6.0, 0.3 * (result.DistortionBefore - 6.0))
    << result.DistortionBefore;
  const shape::ClosestPoints closest = shape::SurfaceLocator(ball).Find(result.Targets);
  EXPECT_LT(closest.Distances.maxCoeff(), 1e-9) << "still on the target";
  EXPECT_GT((result.Targets - targets).rowwise().norm().maxCoeff(), 0.1) << "they slid";
}

TEST(FreeBoundary, IsAStepOfTheVolumeMap)
{
  const shape::Surface ball = shapetest::Icosphere(1);
  const Eigen::MatrixXd targets = Slid(ball);
  shape::VolumeMapOptions options;
  options.FreeBoundary = true;
  const shape::VolumeMapResult result =
    shape::ComputeVolumeMap({ ball, targets, ball, {}, {} }, options);
  const shape::FreeBoundaryResult slid = shape::SlideBoundary(
    ball, targets, ball, {}, {}, shape::ComputeHarmonicVolumeMap(ball, targets));
  EXPECT_EQ(result.Slid, slid.Kept);
  EXPECT_EQ(result.Targets, slid.Targets);
  EXPECT_EQ(result.Map.Charges.Maps[0].Charges, slid.Map.Map.Charges);
  EXPECT_EQ(result.DistortionAfter, slid.DistortionAfter);
}

TEST(FreeBoundary, KeepsWhatCannotBeBetter)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const shape::HarmonicVolumeMapResult map = shape::ComputeHarmonicVolumeMap(ball, ball.Points);
  const shape::FreeBoundaryResult result =
    shape::SlideBoundary(ball, ball.Points, ball, {}, {}, map);
  EXPECT_NEAR(result.DistortionBefore, 6.0, 1e-6);
  EXPECT_LE(result.DistortionAfter, result.DistortionBefore);
  EXPECT_NEAR((result.Targets - ball.Points).cwiseAbs().maxCoeff(), 0.0, 1e-6);
}

} // namespace
