#include "Base/Errors.h"
#include "Correspondence/Evaluate/MapDifference.h"
#include "Correspondence/Evaluate/MetricEmbedding.h"
#include "Correspondence/Evaluate/MetricRecovery.h"
#include "Mesh/Surface.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using shapetest::DistanceFrom;
using shapetest::IdentityMap;

Eigen::MatrixXd SidesOf(const shape::Mesh& mesh)
{
  Eigen::MatrixXd sides(mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < sides.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      sides(t, k) = (corners.row((k + 1) % 3) - corners.row((k + 2) % 3)).norm();
    }
  }
  return sides;
}

/// The mean relative error of lengths.
double ErrorOf(const Eigen::MatrixXd& sides, const shape::Mesh& truth)
{
  return (sides.array() / SidesOf(truth).array() - 1.0).abs().mean();
}

/// Recovers `second` from its operators to `first`, which has the same triangles.
shape::RecoveredMetric Recover(const shape::Surface& first, const shape::Surface& second, int pairs)
{
  shape::MapDifferenceOptions options;
  options.NumberOfEigenpairs = pairs;
  options.Products = shape::MapDifferenceOptions::ProductsType::Triangles;
  const shape::MapDifferenceResult difference =
    shape::MapDifference(first, second, IdentityMap(second), options);
  return shape::RecoverMetric(first, difference.Area.Matrix, difference.Conformal.Matrix);
}

} // namespace

TEST(MetricRecovery, OfTheSameShapeIsItsMetricAndScalesWithTheAreas)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 30, 12);
  for (const double scale : { 1.0, 3.0 })
  {
    shape::Mesh scaled = torus;
    scaled.Points *= scale;
    const shape::RecoveredMetric metric = Recover(torus, scaled, 30);
    EXPECT_LT((metric.Sides - SidesOf(scaled)).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT((metric.Areas - 0.5 * shape::ComputeAreaVectors(scaled).rowwise().norm())
                .cwiseAbs()
                .maxCoeff(),
      1e-8);
    EXPECT_EQ(metric.BrokenTriangles, 0);
  }
}

TEST(MetricRecovery, FindsLengthsToOnePercentFromAHundredEigenpairs)
{
  const auto check = [](const shape::Mesh& first, const shape::Mesh& second)
  {
    const shape::RecoveredMetric metric = Recover(first, second, 100);
    EXPECT_LT(ErrorOf(metric.Sides, second), 0.01);
    EXPECT_GT(ErrorOf(SidesOf(first), second), 0.05) << "the shapes differ";
    EXPECT_EQ(metric.BrokenTriangles, 0);
    EXPECT_NEAR(metric.Areas.sum() / shape::ComputeArea(second), 1.0, 0.01);
  };
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  shape::Mesh waved = torus;
  waved.Points.col(2).array() += 0.6 * (1.5 * torus.Points.col(0).array()).sin();
  waved.Points.col(0) *= 1.3;
  check(torus, waved);

  const shape::Mesh pebble = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh twisted = pebble;
  for (Eigen::Index i = 0; i < pebble.Points.rows(); ++i)
  {
    twisted.Points.row(i) = pebble.Points.row(i) *
      shapetest::Rotation(0.8 * pebble.Points(i, 0), Eigen::Vector3d::UnitX()).transpose();
  }
  check(pebble, twisted);

  const shape::Mesh plate = shapetest::FlatSquare(24, 0.2);
  shape::Mesh dome = plate;
  dome.Points.col(2) =
    (1.5 * plate.Points.col(0).array()).cos() * (1.5 * plate.Points.col(1).array()).cos();
  check(plate, dome);
}

TEST(MetricEmbedding, ReachesGivenLengths)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Mesh pebble = shapetest::Pebble(sphere);
  const shape::EmbeddedMetric found = shape::EmbedMetric(sphere, SidesOf(pebble));
  EXPECT_LT(found.LengthError, 1e-4);
  EXPECT_LT(DistanceFrom(found.Points, pebble), 0.01);
}

TEST(MetricRecovery, RefusesWhatIsNoOperatorOfTheSurface)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  const auto recover = [&](const Eigen::MatrixXd& area, const Eigen::MatrixXd& conformal)
  { return shape::RecoverMetric(sphere, area, conformal); };
  const Eigen::MatrixXd good = Eigen::MatrixXd::Identity(9, 9);
  EXPECT_NO_THROW(recover(good, good));
  EXPECT_THROW(recover(good, good.topRows(8)), shape::InvalidInput);
  EXPECT_THROW(recover(good, NAN * good), shape::InvalidInput);
  EXPECT_THROW(recover(-good, good), shape::SolveFailure);
  const Eigen::MatrixXd large = Eigen::MatrixXd::Identity(43, 43);
  EXPECT_THROW(recover(large, large), shape::InvalidInput);
  EXPECT_THROW(shape::OffsetSurface(sphere, -1.5, "it"), shape::InvalidInput);
  EXPECT_THROW(
    shape::RecoverMetric(sphere, good, good, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
