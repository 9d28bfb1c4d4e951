#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/PointCharges.h"
#include "Harmonic/Private/FreeBoundary.h"
#include "Harmonic/VolumeMap.h"
#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <utility>

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
  EXPECT_EQ(result.Share, 1.0);
  // Of an isometry the energy is 6: nearly all that is above it goes.
  EXPECT_GT(result.DistortionBefore, 6.5);
  EXPECT_LT(result.DistortionAfter - 6.0, 0.02 * (result.DistortionBefore - 6.0))
    << result.DistortionBefore;
  const shape::ClosestPoints closest = shape::SurfaceLocator(ball).Find(result.Targets);
  EXPECT_LT(closest.Distances.maxCoeff(), 1e-9) << "still on the target";
  EXPECT_GT((result.Targets - targets).rowwise().norm().maxCoeff(), 0.1) << "they slid";
}

/// Mean of |J|^2 + |J^-1|^2 at points of a lattice in the unit ball; infinite if a determinant is
/// not positive.
double MeanEnergy(const shape::ChargeSet& map)
{
  const shape::PointCharges charges(map);
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 21 * 21 * 21; ++i)
  {
    const Eigen::Vector3d at = 0.1 * Eigen::Vector3d(i % 21 - 10, i / 21 % 21 - 10, i / 441 - 10);
    if (at.norm() < 0.9)
    {
      Eigen::Matrix3d jacobian;
      charges.Evaluate(at, jacobian);
      sum += jacobian.determinant() > 0.0
        ? jacobian.squaredNorm() + jacobian.inverse().squaredNorm()
        : std::numeric_limits<double>::infinity();
      ++count;
    }
  }
  return sum / count;
}

TEST(FreeBoundary, LowersTheEnergyOfTheFormulaAtOtherPoints)
{
  const shape::Mesh ball = shapetest::Icosphere(3);
  const Eigen::MatrixXd targets = Slid(ball);
  const shape::HarmonicVolumeMapResult map = shape::ComputeHarmonicVolumeMap(ball, targets);
  const shape::FreeBoundaryResult result = shape::SlideBoundary(ball, targets, ball, {}, {}, map);
  EXPECT_GT(MeanEnergy(map.Map), 6.5);
  EXPECT_LT(MeanEnergy(result.Map.Map) - 6.0, 0.02 * (MeanEnergy(map.Map) - 6.0));
}

/// Mean of |J|^2 + |J^-1|^2 at points of a lattice in a torus around z (radii 1 and 0.4), where the
/// determinant is positive, and the number of points where it is not.
std::pair<double, int> JudgeInTorus(const shape::ChargeSet& map)
{
  const shape::PointCharges charges(map);
  double sum = 0.0;
  int count = 0, folded = 0;
  for (int i = 0; i < 57 * 57 * 17; ++i)
  {
    const Eigen::Vector3d at = 0.05 * Eigen::Vector3d(i % 57 - 28, i / 57 % 57 - 28, i / 3249 - 8) +
      0.01 * Eigen::Vector3d::Ones();
    if (std::hypot(std::hypot(at.x(), at.y()) - 1.0, at.z()) < 0.385)
    {
      Eigen::Matrix3d jacobian;
      charges.Evaluate(at, jacobian);
      if (jacobian.determinant() > 0.0)
      {
        sum += jacobian.squaredNorm() + jacobian.inverse().squaredNorm();
        ++count;
      }
      else
      {
        ++folded;
      }
    }
  }
  return { sum / count, folded };
}

TEST(FreeBoundary, DistortionsAreThoseOfTheFormulaAndNothingFolds)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 40, 20);
  Eigen::MatrixXd targets = torus.Points;
  for (Eigen::Index i = 0; i < targets.rows(); ++i)
  {
    const double x = targets(i, 0), y = targets(i, 1), z = targets(i, 2);
    const double angle = 0.2 * std::sin(2.0 * std::atan2(y, x)) + 0.8 * z;
    targets.row(i) << std::cos(angle) * x - std::sin(angle) * y,
      std::sin(angle) * x + std::cos(angle) * y, z;
  }
  targets = shape::SurfaceLocator(torus).Find(targets).Positions;
  const shape::HarmonicVolumeMapResult map = shape::ComputeHarmonicVolumeMap(torus, targets);
  const shape::FreeBoundaryResult result = shape::SlideBoundary(torus, targets, torus, {}, {}, map);
  const auto [before, foldedBefore] = JudgeInTorus(map.Map);
  const auto [after, foldedAfter] = JudgeInTorus(result.Map.Map);
  EXPECT_GT(result.Share, 0.0);
  EXPECT_LT(after, before);
  EXPECT_EQ(foldedBefore, 0);
  EXPECT_EQ(foldedAfter, 0);
  EXPECT_EQ(result.FoldedAfter, 0.0);
  EXPECT_NEAR(result.DistortionBefore, before, 0.02 * before);
  EXPECT_NEAR(result.DistortionAfter, after, 0.02 * after);
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
  EXPECT_EQ(result.SlidShare, slid.Share);
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
