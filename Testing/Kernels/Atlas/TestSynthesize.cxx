#include "Atlas/Synthesize.h"
#include "Base/Errors.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using shape::ModeValues;

constexpr int Tetrahedra = 3000;

/// A mean that is the template, and two modes that are not affine.
ModeValues BallModes(const Eigen::MatrixXd& ball)
{
  const Eigen::ArrayXd x = ball.col(0), y = ball.col(1), z = ball.col(2);
  ModeValues values{ ball, Eigen::MatrixXd::Zero(ball.rows(), 6) };
  values.Modes.col(0) = 0.1 * (y * y - z * z);
  values.Modes.col(1) = 0.1 * x * z;
  values.Modes.col(5) = 0.05 * (3.0 * x).sin();
  return values;
}

/// Positions in the ball.
Eigen::MatrixXd InnerPoints()
{
  Eigen::MatrixXd points(60, 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    const double height = 1.0 - (2.0 * i + 1.0) / 60.0, angle = 2.399963 * i;
    const double flat = std::sqrt(1.0 - height * height);
    points.row(i) = 0.9 * std::cbrt(std::fmod(0.618034 * i, 1.0)) *
      Eigen::RowVector3d(flat * std::cos(angle), flat * std::sin(angle), height);
  }
  return points;
}

shape::FiniteElementMap Solve(const shape::Mesh& surface, const ModeValues& values)
{
  shape::SynthesizeOptions options;
  options.Tetrahedra = Tetrahedra;
  return shape::FiniteElementMap(shape::SolveModes(surface, values, options));
}

} // namespace

TEST(Synthesize, WithoutWeightsIsTheMeanAndElseTheSum)
{
  const ModeValues values{ Eigen::MatrixXd::Random(5, 2), Eigen::MatrixXd::Random(5, 6) };
  EXPECT_EQ(shape::Synthesize(values, Eigen::VectorXd()), values.Mean);
  EXPECT_EQ(shape::Synthesize(values, Eigen::VectorXd::Zero(3)), values.Mean);
  const Eigen::Vector3d weights(1.5, 0.0, -2.0);
  const Eigen::MatrixXd sum =
    values.Mean + 1.5 * values.Modes.leftCols(2) - 2.0 * values.Modes.rightCols(2);
  EXPECT_LT((shape::Synthesize(values, weights) - sum).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Synthesize, RefusesMoreWeightsThanModesAndNoNumbers)
{
  const ModeValues values{ Eigen::MatrixXd::Zero(2, 3), Eigen::MatrixXd::Zero(2, 3) };
  EXPECT_TRUE(shapetest::HasWords(
    shapetest::Refusal([&] { shape::Synthesize(values, Eigen::Vector2d::Zero()); }),
    { "2 weights", "1 modes", "at most one" }));
  const Eigen::VectorXd bad =
    Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(shapetest::HasWords(
    shapetest::Refusal([&] { shape::Synthesize(values, bad); }), { "not finite" }));
  const shape::Mesh ball = shapetest::Icosphere(1);
  shape::SynthesizeOptions few;
  few.Tetrahedra = 10;
  EXPECT_TRUE(shapetest::HasWords(
    shapetest::Refusal([&] { shape::SolveModes(ball, BallModes(ball.Points), few); }),
    { "Tetrahedra is 10", "1000" }));
}

/// A template that is its own mean, and an affine mode: the finite elements reproduce both.
TEST(Synthesize, MovesTheInsideAffinelyByAnAffineMode)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  Eigen::Matrix3d a;
  a << 0.2, -0.1, 0.3, 0.0, 0.4, 0.1, -0.2, 0.0, 0.1;
  const Eigen::RowVector3d b(0.5, -0.25, 1.0);
  const ModeValues values{ ball.Points, (ball.Points * a).rowwise() + b };
  const Eigen::MatrixXd points = InnerPoints();
  const shape::CarriedModes carried = shape::CarryModes(Solve(ball, values), points);
  EXPECT_EQ(carried.OutsideDomain.sum(), 0);
  EXPECT_EQ(carried.Distances.maxCoeff(), 0.0);
  const Eigen::MatrixXd same = shape::Synthesize(carried, Eigen::VectorXd::Zero(1));
  EXPECT_LT((same - points).cwiseAbs().maxCoeff(), 1e-13) << "the mean is the template";
  const Eigen::MatrixXd moved = shape::Synthesize(carried, Eigen::VectorXd::Constant(1, -1.7));
  const Eigen::MatrixXd expected = points - 1.7 * ((points * a).rowwise() + b);
  EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-12);
}

/// The sum of the modes' maps is the map of the sample.
TEST(Synthesize, IsTheHarmonicMapOfTheSample)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const ModeValues values = BallModes(ball.Points);
  const Eigen::Vector2d weights(2.0, -1.3);
  const Eigen::MatrixXd points = InnerPoints();
  const Eigen::MatrixXd summed =
    shape::Synthesize(shape::CarryModes(Solve(ball, values), points), weights);
  const shape::FiniteElementMap direct(
    shape::ComputeFiniteElements(ball, shape::Synthesize(values, weights), Tetrahedra));
  EXPECT_LT((summed - direct.Evaluate(points).Images).cwiseAbs().maxCoeff(), 1e-13);
  // The modes do move the points.
  EXPECT_GT((summed - points).rowwise().norm().maxCoeff(), 0.1);
}

TEST(Synthesize, ContinuesNearTheTemplateAndLeavesTheRest)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const ModeValues values{ 2.0 * ball.Points, ball.Points };
  // On the way out through a point of the ball, whose longest side is 2.
  const Eigen::RowVector3d out = ball.Points.row(0).normalized();
  Eigen::MatrixXd points(2, 3);
  points << (1.0 + 1.9 * shape::NearTemplate) * out, (1.0 + 2.5 * shape::NearTemplate) * out;
  const shape::CarriedModes carried = shape::CarryModes(Solve(ball, values), points);
  EXPECT_EQ(carried.OutsideDomain, Eigen::Vector2i(0, 1));
  EXPECT_NEAR(carried.Distances(0), 0.95 * shape::NearTemplate, 1e-12);
  const Eigen::MatrixXd moved = shape::Synthesize(carried, Eigen::VectorXd::Ones(1));
  EXPECT_LT((moved.row(0) - 3.0 * points.row(0)).norm(), 1e-12);
  EXPECT_EQ(moved.row(1), points.row(1));
}

TEST(Synthesize, FindsTheCellsThatAMapInverts)
{
  Eigen::MatrixXd points(8, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  const int corners[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  shape::CellSimplices cells;
  cells.Add(shape::CellShape::Hexahedron, corners);
  cells.EndCell();
  cells.Add(shape::CellShape::Triangle, corners);
  cells.EndCell();
  // Turned inside out already: what counts is the change by the map.
  const int turned[] = { 0, 2, 1, 4 };
  cells.Add(shape::CellShape::Tetrahedron, turned);
  cells.EndCell();
  EXPECT_EQ(shape::FindInvertedCells(cells, points, points), Eigen::Vector3i(0, 0, 0));
  Eigen::MatrixXd moved = points;
  moved.row(6) << 0.1, 0.1, 0.1; // through the plane of its neighbours
  EXPECT_EQ(shape::FindInvertedCells(cells, points, moved), Eigen::Vector3i(1, 0, 0));
  EXPECT_EQ(shape::FindInvertedCells(cells, points, -points), Eigen::Vector3i(1, 0, 1));
  moved = points;
  moved.col(2).setZero();
  EXPECT_EQ(shape::FindInvertedCells(cells, points, moved), Eigen::Vector3i(1, 0, 1));
}

TEST(Synthesize, ReportsProgressAndStops)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  const ModeValues values = BallModes(ball.Points);
  shape::SynthesizeOptions options;
  options.Tetrahedra = Tetrahedra;
  const auto solve = [&](const shape::Progress& progress)
  { shape::SolveModes(ball, values, options, progress); };
  EXPECT_GT(shapetest::ExpectProgressRises(solve), 3);
  shapetest::ExpectStopsAt(3, solve);
}
