#include "Base/Errors.h"
#include "Distortion/InjectiveRefinement.h"
#include "Distortion/SimplexElements.h"
#include "Geometry/Orientation.h"
#include "Mesh/BoundaryLoops.h"
#include "Parameterize/ConvexCombination.h"
#include "Support/Distortions.h"
#include "Support/FlatMaps.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using shape::Distortion;

namespace
{

using shapetest::AllMeasures;

/// Tutte's map onto the unit circle.
Eigen::MatrixXd Tutte(const shape::Mesh& mesh)
{
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(mesh).front();
  Eigen::MatrixXd positions(loop.size(), 2);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const double angle =
      2.0 * M_PI * static_cast<double>(i) / static_cast<double>(positions.rows());
    positions.row(i) << std::cos(angle), std::sin(angle);
  }
  return shape::SolveConvexCombination(mesh, shape::CombinationWeights::Uniform, loop, positions);
}

} // namespace

TEST(InjectiveRefinement, LaysAFlatSurfaceOutAsItIs)
{
  const shape::Mesh flat = shapetest::FlatSquare(8, 0.3);
  const shape::InjectiveRefinementResult map = shape::RefineInjectively(flat, Tutte(flat));
  EXPECT_GT(map.StartEnergy, 4.2);
  EXPECT_NEAR(map.Energy, 4.0, 1e-4);
  for (const auto& corners : flat.Triangles.rowwise())
  {
    const double before = (flat.Points.row(corners(0)) - flat.Points.row(corners(1))).norm();
    EXPECT_NEAR(
      (map.Points.row(corners(0)) - map.Points.row(corners(1))).norm() / before, 1.0, 0.02);
  }
}

TEST(InjectiveRefinement, EveryMeasureFallsToAStationaryPointWithoutAFlip)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(8, 0.5);
  const Eigen::MatrixXd start = Tutte(mesh);
  const shape::SimplexElements<2> elements = shape::BuildTriangleElements(mesh, 1.0);
  for (const Distortion measure : AllMeasures)
  {
    shape::InjectiveRefinementOptions options;
    options.Measure = measure;
    options.Tolerance = 1e-12;
    options.MaximumIterations = 3000;
    options.Exponent = 0.5;
    const auto map = shape::RefineInjectively(mesh, start, {}, options);
    const std::string name = "measure " + std::to_string(static_cast<int>(measure));
    EXPECT_EQ(shapetest::CountFlips(mesh.Triangles, map.Points), 0) << name;
    // The exponential ones start where SymmetricDirichlet has ended.
    EXPECT_LT(map.Energy, (shape::IsExponential(measure) ? 1.0 : 0.9) * map.StartEnergy) << name;
    EXPECT_DOUBLE_EQ(map.Energy, elements.Energy(map.Points, measure, options.Exponent)) << name;
    if (measure == Distortion::ARAP || measure == Distortion::Hencky)
    {
      continue; // Their least may lie where triangles have no area.
    }
    // No point moved alone, in any direction, lowers the energy by more than the second order.
    for (const int point : { 0, 50, 120, 200 })
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        Eigen::MatrixXd there = map.Points, back = map.Points;
        there(point, axis) += 1e-5;
        back(point, axis) -= 1e-5;
        const double slope = (elements.Energy(there, measure, options.Exponent) -
                               elements.Energy(back, measure, options.Exponent)) /
          2e-5;
        EXPECT_NEAR(slope / map.Energy, 0.0, 1e-4) << name << " point " << point;
      }
    }
  }
}

TEST(InjectiveRefinement, ConformalMeasureReachesTheStereographicProjectionOfACap)
{
  // A cap of the sphere has a conformal image; the mean of s1 / s2 + s2 / s1 goes to 2 with h^2.
  double before = 1.0;
  for (const int rings : { 6, 12 })
  {
    shape::Mesh cap = shapetest::FlatDisk(rings);
    for (Eigen::Index i = 0; i < cap.Points.rows(); ++i)
    {
      const double square = cap.Points.row(i).squaredNorm();
      cap.Points.row(i) *= 2.0 / (1.0 + square);
      cap.Points(i, 2) = (1.0 - square) / (1.0 + square);
    }
    shape::InjectiveRefinementOptions options;
    options.Measure = Distortion::ConformalAMIPS;
    options.Tolerance = 1e-9;
    const double above = shape::RefineInjectively(cap, Tutte(cap), {}, options).Energy - 2.0;
    EXPECT_GT(above, 0.0);
    EXPECT_LT(above, 0.4 * before) << rings;
    before = above;
  }
}

TEST(InjectiveRefinement, FixedPointsStayToTheBitAndScaleCounts)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(6, 0.5);
  const Eigen::MatrixXd start = Tutte(mesh);
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(mesh).front();
  const auto map = shape::RefineInjectively(mesh, start, loop);
  EXPECT_EQ(map.Points(loop, Eigen::all), start(loop, Eigen::all));
  EXPECT_LT(map.Energy, map.StartEnergy);
  EXPECT_EQ(shapetest::CountFlips(mesh.Triangles, map.Points), 0);
  // Twice as large an image of a surface that counts as twice as large.
  shape::InjectiveRefinementOptions options;
  options.Scale = 2.0;
  const auto twice = shape::RefineInjectively(mesh, 2.0 * start, loop, options);
  EXPECT_LT((twice.Points - 2.0 * map.Points).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(InjectiveRefinement, DegenerateTrianglesStayFinite)
{
  shape::Mesh mesh = shapetest::BumpyDisk(6, 0.5);
  mesh.Points.row(0) = mesh.Points.row(1);
  mesh.Points.row(20) = 0.5 * (mesh.Points.row(21) + mesh.Points.row(19));
  const auto map = shape::RefineInjectively(mesh, Tutte(mesh));
  EXPECT_TRUE(map.Points.allFinite());
  EXPECT_EQ(shapetest::CountFlips(mesh.Triangles, map.Points), 0);
  EXPECT_LT(map.Energy, map.StartEnergy);
}

TEST(InjectiveRefinement, TheStepToTheFirstFlipIsExact)
{
  const shape::Mesh triangle{ (Eigen::MatrixXd(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(),
    (Eigen::MatrixXi(1, 3) << 0, 1, 2).finished() };
  const shape::SimplexElements<2> elements = shape::BuildTriangleElements(triangle, 1.0);
  Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(3, 2);
  const Eigen::MatrixXd points = triangle.Points.leftCols(2);
  EXPECT_TRUE(std::isinf(elements.LargestStep(points, steps)));
  steps(2, 1) = -4.0; // reaches the line of the others after a quarter
  EXPECT_DOUBLE_EQ(elements.LargestStep(points, steps), 0.25);
  steps(2, 1) = 4.0;
  EXPECT_TRUE(std::isinf(elements.LargestStep(points, steps)));
  // All shrinks towards the first corner: a double root at 1.
  steps = -points;
  EXPECT_DOUBLE_EQ(elements.LargestStep(points, steps), 1.0);
}

TEST(InjectiveRefinement, FindsTheFirstOfUpToThreeRoots)
{
  // (1 - t) (1 - t / 2) (1 - t / 4) and (1 - t / 3) (1 + t^2).
  EXPECT_NEAR(shape::FindFirstRoot(1.0, -1.75, 0.875, -0.125), 1.0, 1e-15);
  EXPECT_NEAR(shape::FindFirstRoot(1.0, -1.0 / 3.0, 1.0, -1.0 / 3.0), 3.0, 1e-14);
  // (1 + t) (1 - t)^2, whose double root rounding may miss, and 1 + t^3.
  EXPECT_NEAR(shape::FindFirstRoot(1.0, -1.0, -1.0, 1.0), 1.0, 1e-7);
  EXPECT_TRUE(std::isinf(shape::FindFirstRoot(1.0, 0.0, 0.0, 1.0)));
  // A cube shrinks to a point at 1e9.
  EXPECT_NEAR(1e-9 * shape::FindFirstRoot(1.0, -3e-9, 3e-18, -1e-27), 1.0, 1e-4);
}

TEST(InjectiveRefinement, TheStepToTheFirstInversionInSpaceIsExact)
{
  const Eigen::MatrixXi corners = (Eigen::MatrixXi(1, 4) << 0, 1, 2, 3).finished();
  const shape::SimplexElements<3> elements(
    corners, { Eigen::Matrix3d::Identity() }, Eigen::VectorXd::Ones(1));
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(4, 3), steps = points;
  points.bottomRows(3).setIdentity();
  EXPECT_TRUE(std::isinf(elements.LargestStep(points, steps)));
  steps(3, 2) = -4.0; // reaches the plane of the others after a quarter
  EXPECT_DOUBLE_EQ(elements.LargestStep(points, steps), 0.25);
  steps(3, 2) = 4.0;
  EXPECT_TRUE(std::isinf(elements.LargestStep(points, steps)));
}

TEST(InjectiveRefinement, RefusesAFlippedStartAndBadOptions)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(3, 0.5);
  Eigen::MatrixXd start = Tutte(mesh);
  start.col(0) *= -1.0;
  EXPECT_REFUSED(shape::RefineInjectively(mesh, start), "of the start is not counter-clockwise");
  start.col(0) *= -1.0;
  using Options = shape::InjectiveRefinementOptions;
  shapetest::ExpectRefused<Options>(
    [&](const Options& options) { shape::RefineInjectively(mesh, start, {}, options); }, {},
    { { &Options::Tolerance, 1.0, { "Tolerance is 1" } },
      { &Options::Scale, 0.0, { "Scale is 0" } } });
}

TEST(InjectiveRefinement, ProgressRisesAndCanStop)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(6, 0.5);
  const Eigen::MatrixXd start = Tutte(mesh);
  shapetest::ExpectProgressRises([&](const shape::Progress& progress)
    { shape::RefineInjectively(mesh, start, {}, {}, progress); });
  EXPECT_THROW(shape::RefineInjectively(mesh, start, {}, {},
                 shape::Progress([](double fraction) { return fraction < 0.3; })),
    shape::Aborted);
}
