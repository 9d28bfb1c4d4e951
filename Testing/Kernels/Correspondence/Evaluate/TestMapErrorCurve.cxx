#include "Base/Errors.h"
#include "Correspondence/Evaluate/MapErrorCurve.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

Eigen::Matrix3d Turned(double angle)
{
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

shape::MapErrorCurveOptions InUnits()
{
  shape::MapErrorCurveOptions options;
  options.Normalisation = shape::MapErrorCurveOptions::NormalisationType::None;
  return options;
}

/// The elk, which is no symmetric shape, twice as large.
shape::Mesh Model()
{
  shape::Mesh mesh = shapetest::ReadModel("elk");
  mesh.Points *= 2.0;
  return mesh;
}

} // namespace

TEST(MapErrorCurve, OfTheTruthIsZero)
{
  const shape::Mesh mesh = Model();
  const Eigen::MatrixXd positions = shape::SampleRandomly(mesh, 500, 1);
  // A rigid motion is the true map of all places, also between points.
  shape::Mesh moved = mesh;
  moved.Points = mesh.Points * Turned(1.0).transpose();
  const shape::MapErrorCurveResult result = shape::ComputeMapErrorCurve(
    mesh, moved.Points, moved, { positions, positions * Turned(1.0).transpose(), {} });
  EXPECT_LT(result.Maximum, 1e-10);
  EXPECT_NEAR(result.AreaUnderCurve, 1.0, 1e-10);
  EXPECT_EQ(result.Shares.size(), 500);
  EXPECT_EQ(result.Shares(499), 1.0);
  EXPECT_LT(result.LargestGap, 1e-10 * result.Unit);
  EXPECT_FALSE(result.Mirrored);
  EXPECT_LT(
    shape::ComputeRoundTripErrors(mesh, moved.Points, moved, mesh.Points).maxCoeff(), 1e-10);
  EXPECT_NEAR(shape::ComputeCoverage(mesh, moved.Points, moved), 1.0, 1e-12);
}

TEST(MapErrorCurve, OfATurnedSphereIsAsLongAsTheArcs)
{
  const shape::Mesh sphere = shapetest::Icosphere(5);
  const double angle = 0.3;
  const Eigen::MatrixXd map = sphere.Points * Turned(angle).transpose();
  const shape::GroundTruth truth{ sphere.Points, sphere.Points, {} };
  const shape::MapErrorCurveResult result =
    shape::ComputeMapErrorCurve(sphere, map, sphere, truth, InUnits());
  const Eigen::ArrayXd across = sphere.Points.leftCols(2).rowwise().norm();
  // 2 asin(r sin(a / 2)) for the great circle between the ends of an arc of a circle of radius r.
  Eigen::VectorXd wanted = 2.0 * (across * std::sin(0.5 * angle)).asin();
  std::sort(wanted.begin(), wanted.end());
  EXPECT_LT((result.Errors - wanted).cwiseAbs().maxCoeff(), 1e-3 * angle);
  EXPECT_NEAR(result.Mean, wanted.mean(), 1e-3 * angle);
  EXPECT_NEAR(result.Median, wanted(wanted.size() / 2), 1e-3 * angle);
  EXPECT_NEAR(result.Percentile95, wanted(wanted.size() * 19 / 20), 2e-3 * angle);
  EXPECT_NEAR(result.Maximum, angle, 1e-3 * angle);
  // The same divided: sqrt(4 pi), pi.
  shape::MapErrorCurveOptions options;
  EXPECT_NEAR(shape::ComputeMapErrorCurve(sphere, map, sphere, truth, options).Mean,
    wanted.mean() / std::sqrt(4.0 * M_PI), 1e-3 * angle);
  options.Normalisation = shape::MapErrorCurveOptions::NormalisationType::GeodesicDiameter;
  EXPECT_NEAR(shape::ComputeMapErrorCurve(sphere, map, sphere, truth, options).Mean,
    wanted.mean() / M_PI, 1e-3 * angle);
  // Linear in each error up to the largest.
  options = InUnits();
  options.LargestError = 0.2;
  EXPECT_NEAR(shape::ComputeMapErrorCurve(sphere, map, sphere, truth, options).AreaUnderCurve,
    (1.0 - wanted.array() / 0.2).max(0.0).mean(), 1e-3);
}

TEST(MapErrorCurve, IsMeasuredAlongTheSurface)
{
  // Two sides of a thin slab: near through it, far around its edge.
  shape::Mesh slab = shapetest::Prism({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } });
  slab.Points.col(2) *= 0.01;
  Eigen::MatrixXd below(1, 3), above(1, 3);
  below << 1.0, 2.0, 0.0;
  above << 1.0, 2.0, 0.01;
  const shape::MapErrorCurveResult result =
    shape::ComputeMapErrorCurve(slab, slab.Points, slab, { below, above, {} }, InUnits());
  EXPECT_NEAR(result.Maximum, 2.01, 1e-10);
}

TEST(MapErrorCurve, TakesTheTruthOrItsMirrorImageAsAWhole)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  Eigen::MatrixXd mirror = torus.Points;
  mirror.col(0) *= -1.0;
  const Eigen::MatrixXd& right = torus.Points;
  const shape::GroundTruth truth{ right, right, mirror };
  EXPECT_FALSE(shape::ComputeMapErrorCurve(torus, right, torus, truth).Mirrored);
  EXPECT_EQ(shape::ComputeMapErrorCurve(torus, right, torus, truth).Maximum, 0.0);
  EXPECT_TRUE(shape::ComputeMapErrorCurve(torus, mirror, torus, truth).Mirrored);
  EXPECT_LT(shape::ComputeMapErrorCurve(torus, mirror, torus, truth).Maximum, 1e-12);
  // Half of one and half of the other is no good map by either.
  Eigen::MatrixXd torn = right;
  torn.topRows(torn.rows() / 2) = mirror.topRows(torn.rows() / 2);
  const shape::MapErrorCurveResult result = shape::ComputeMapErrorCurve(torus, torn, torus, truth);
  EXPECT_GT(result.Mean, 0.1);
  EXPECT_GT(result.Maximum, 0.5);
}

TEST(MapErrorCurve, CoverageIsTheShareOfTheArea)
{
  const shape::Mesh square = shapetest::FlatSquare(40, 0.2);
  Eigen::MatrixXd half = square.Points;
  half.col(0) = 0.5 * (half.col(0).array() - 1.0);
  EXPECT_DOUBLE_EQ(shape::ComputeCoverage(square, square.Points, square), 1.0);
  EXPECT_NEAR(shape::ComputeCoverage(square, half, square), 0.5, 0.02);
}

TEST(MapErrorCurve, RoundTripsOfMapsThatAreNotInverseAreAsLongAsTheWay)
{
  const shape::Mesh sphere = shapetest::Icosphere(5);
  const Eigen::MatrixXd map = sphere.Points * Turned(0.3).transpose(),
                        back = sphere.Points * Turned(-0.2).transpose();
  const Eigen::VectorXd errors = shape::ComputeRoundTripErrors(sphere, map, sphere, back);
  EXPECT_NEAR(errors(errors.size() - 1), 0.1 / std::sqrt(4.0 * M_PI), 1e-4);
}

TEST(MapErrorCurve, ImagesOnAnotherComponentHaveNoError)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const Eigen::Index count = ball.Points.rows();
  shape::Mesh two;
  two.Points.resize(2 * count, 3);
  two.Points << ball.Points, ball.Points.rowwise() + Eigen::RowVector3d(5.0, 0.0, 0.0);
  two.Triangles.resize(2 * ball.Triangles.rows(), 3);
  two.Triangles << ball.Triangles, ball.Triangles.array() + static_cast<int>(count);
  Eigen::MatrixXd map = two.Points;
  map.bottomRows(count) = ball.Points;
  const shape::MapErrorCurveResult result =
    shape::ComputeMapErrorCurve(two, map, two, { two.Points, two.Points, {} });
  EXPECT_EQ(result.Unreached, count);
  EXPECT_EQ(result.Shares(count - 1), 0.5);
  EXPECT_LT(result.PositionErrors.head(count).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_TRUE((result.PositionErrors.tail(count).array() == -1.0).all());
}

TEST(MapErrorCurve, RefusesWhatHasNoError)
{
  const shape::Mesh mesh = shapetest::Icosphere(2);
  const shape::GroundTruth none{ Eigen::MatrixXd(0, 3), Eigen::MatrixXd(0, 3), {} };
  EXPECT_REFUSED(
    shape::ComputeMapErrorCurve(mesh, mesh.Points, mesh, none), "the Truth has no points");
  const shape::GroundTruth truth{ mesh.Points, mesh.Points, {} };
  EXPECT_REFUSED(shape::ComputeMapErrorCurve(mesh, mesh.Points.topRows(3), mesh, truth),
    "the map of the Input has 3");
  shape::MapErrorCurveOptions options;
  options.LargestError = 0.0;
  EXPECT_REFUSED(
    shape::ComputeMapErrorCurve(mesh, mesh.Points, mesh, truth, options), "LargestError is 0");
  EXPECT_THROW(shape::ComputeMapErrorCurve(
                 mesh, mesh.Points, mesh, truth, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
