#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/ChargeShells.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// The unit ball with a spherical void, both surfaces facing any way.
shape::Mesh BallWithVoid(const Eigen::RowVector3d& centre, double radius)
{
  const shape::Mesh sphere = shapetest::Icosphere(3), wall = shapetest::Icosphere(2);
  shape::Mesh ball{ Eigen::MatrixXd(642 + 162, 3), Eigen::MatrixXi(1280 + 320, 3) };
  ball.Points << sphere.Points, (radius * wall.Points).rowwise() + centre;
  ball.Triangles << sphere.Triangles, wall.Triangles.array() + 642;
  return ball;
}

shape::Mesh FacingOut(shape::Mesh ball)
{
  ball.Triangles.bottomRows(320).col(0).swap(ball.Triangles.bottomRows(320).col(1));
  return ball;
}

/// A map that is harmonic in the ball but for a point in the void, so that no charges around the
/// ball make it.
Eigen::MatrixXd OfAChargeAt(const Eigen::RowVector3d& centre, const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd values = points;
  const Eigen::VectorXd distances = (points.rowwise() - centre).rowwise().norm();
  values.col(0).array() += 0.05 / distances.array();
  values.col(2).array() -= 0.03 / distances.array();
  return values;
}

} // namespace

TEST(ChargeShells, SitAroundTheSolidAndInsideItsVoids)
{
  const Eigen::RowVector3d centre(0.3, 0, 0);
  for (const auto& [radius, depth] : { std::pair(0.4, 0.1), std::pair(0.08, 0.04) })
  {
    const shape::Mesh ball = FacingOut(BallWithVoid(centre, radius));
    const shape::ChargeShells shells(ball, 0.1);
    EXPECT_NEAR(shells.Nearest(), depth, 0.15 * depth);
    const auto samples = shells.Sample(800, shape::SamplingMode::Uniform, 1);
    ASSERT_EQ(samples.size(), 2u);
    Eigen::MatrixXd sources(samples[0].rows() + samples[1].rows(), 3);
    sources << samples[0], samples[1];
    int inVoid = 0;
    for (const auto& source : sources.rowwise())
    {
      const double fromVoid = (source - centre).norm();
      inVoid += fromVoid < radius;
      EXPECT_TRUE(fromVoid < radius ? std::abs(radius - fromVoid - depth) < 0.25 * depth
                                    : std::abs(source.norm() - 1.1) < 0.01);
    }
    EXPECT_GE(inVoid, 24);
  }
}

TEST(ChargeShells, ChargesInAVoidMakeWhatNoneOutsideCan)
{
  const Eigen::RowVector3d centre(0.3, 0, 0);
  for (const double radius : { 0.4, 0.08 })
  {
    const shape::Mesh ball = BallWithVoid(centre, radius);
    for (const auto method : { shape::HarmonicVolumeMapOptions::MethodType::MultiLevel,
           shape::HarmonicVolumeMapOptions::MethodType::SingleShot })
    {
      shape::HarmonicVolumeMapOptions options;
      options.Method = method;
      options.Tolerance = 0.0;
      options.CollocationRatio = 1.0;
      options.SourceRatio = 0.6;
      const auto result =
        shape::ComputeHarmonicVolumeMap(ball, OfAChargeAt(centre, ball.Points), {}, options);
      EXPECT_LT(result.Levels.back().RMSEInside, 2e-3) << radius;
      // Inside the solid, along a ring halfway between wall and sphere.
      Eigen::MatrixXd ring(64, 3);
      for (int i = 0; i < ring.rows(); ++i)
      {
        const double angle = 2.0 * M_PI * i / ring.rows();
        ring.row(i) =
          centre + 0.5 * (radius + 0.6) * Eigen::RowVector3d(0.2, std::cos(angle), std::sin(angle));
      }
      EXPECT_LT((shape::Evaluate(result.Map, ring) - OfAChargeAt(centre, ring)).norm() / 8.0, 2e-3)
        << radius;
    }
  }
}

TEST(ChargeShells, TheFirstLevelHasAsManyRowsAsThereArePoints)
{
  // Two components share the points out by area and round: at some ratio one is missing.
  const Eigen::RowVector3d centre(0.2, 0, 0);
  const shape::Mesh ball = BallWithVoid(centre, 0.7);
  shape::HarmonicVolumeMapOptions options;
  options.Method = shape::HarmonicVolumeMapOptions::MethodType::MultiLevel;
  options.SourceSubsets = 1;
  options.MaximumLevels = 1;
  options.Tolerance = 0.0;
  for (int points = 300; points < 312; ++points)
  {
    options.CollocationRatio = (points + 0.1) / ball.Points.rows();
    options.SourceRatio = 0.9 * options.CollocationRatio;
    const auto result =
      shape::ComputeHarmonicVolumeMap(ball, OfAChargeAt(centre, ball.Points), {}, options);
    EXPECT_NEAR(result.Levels.back().Collocations, points, 1);
    EXPECT_LT(result.Levels.back().RMSEInside, result.Levels.front().RMSEInside);
  }
}

TEST(ChargeShells, AVoidMayFaceAnyWay)
{
  const shape::Mesh ball = BallWithVoid(Eigen::RowVector3d(0.3, 0, 0), 0.4);
  const Eigen::MatrixXd targets = OfAChargeAt(Eigen::RowVector3d(0.3, 0, 0), ball.Points);
  shape::HarmonicVolumeMapOptions options;
  options.MaximumLevels = 2;
  const auto one = shape::ComputeHarmonicVolumeMap(ball, targets, {}, options);
  const auto other = shape::ComputeHarmonicVolumeMap(FacingOut(ball), targets, {}, options);
  EXPECT_EQ(one.Map.Charges, other.Map.Charges);
}
