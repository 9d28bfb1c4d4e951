#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Geometry/Sampling.h"
#include "Harmonic/Private/OffsetSurface.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

double MinimumSpacing(const Eigen::MatrixXd& points)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 1; i < points.rows(); ++i)
  {
    minimum = std::min(
      minimum, (points.topRows(i).rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff());
  }
  return std::sqrt(minimum);
}

} // namespace

TEST(OffsetSurface, IsClosedAndNearItsDistanceThatPointsCanBeMovedTo)
{
  const std::pair<shape::Mesh, int> cases[] = { { shapetest::Icosphere(3), 2 },
    { shapetest::Torus(1.0, 0.3, 40, 20), 0 } };
  for (const auto& [mesh, eulerNumber] : cases)
  {
    const shape::SignedDistance field(mesh);
    const shape::Mesh offset = shape::BuildOffsetSurface(field, 0.2);
    EXPECT_EQ(shape::RequireClosedSurface(offset, "the offset").EulerNumber, eulerNumber);
    EXPECT_GT(shape::ComputeEnclosedVolume(offset), shape::ComputeEnclosedVolume(mesh));
    const Eigen::VectorXd distances = field.Evaluate(offset.Points).Distances;
    EXPECT_LT((distances.array() - 0.2).abs().maxCoeff(), 0.02);
    const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(offset.Points.rows(), 0.1, 0.3);
    Eigen::MatrixXd moved = offset.Points;
    shape::MoveToDistance(moved, field, wanted);
    EXPECT_LT((field.Evaluate(moved).Distances - wanted).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(OffsetSurface, ClosesTheHoleOfATorusBeyondItsRadius)
{
  const shape::SignedDistance field(shapetest::Torus(1.0, 0.3, 40, 20));
  EXPECT_EQ(shape::ComputeTopology(shape::BuildOffsetSurface(field, 0.8)).EulerNumber, 2);
}

TEST(OffsetSurface, ItsVolumeIsSteinersFormulaWhateverTheGrid)
{
  // V + S d + M d^2 + 4/3 pi d^3 of a convex body; a sphere's is the volume at radius 1 + d.
  const shape::SignedDistance field(shapetest::Icosphere(4));
  for (const double cells : { 1.5, 3.0 })
  {
    shape::OffsetSurfaceOptions options;
    options.CellsPerDistance = cells;
    const double volume =
      shape::ComputeEnclosedVolume(shape::BuildOffsetSurface(field, 0.15, options));
    EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI * std::pow(1.15, 3), 0.05);
  }
}

TEST(OffsetSurface, RefusesDistancesThatCannotBeSampled)
{
  const shape::SignedDistance field(shapetest::Icosphere(2));
  EXPECT_THROW(shape::BuildOffsetSurface(field, 0.0), shape::InvalidInput);
  EXPECT_THROW(shape::BuildOffsetSurface(field, 1e-4), shape::InvalidInput);
  shape::OffsetSurfaceOptions capped;
  capped.MaximumSamples = 2e4; // a quarter of the distance would need about 10^5
  EXPECT_GT(shape::BuildOffsetSurface(field, 0.2, capped).Triangles.rows(), 0);
}

TEST(Sampling, UniformIsExactInNumberAndFarApart)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 40, 20);
  const Eigen::MatrixXd points = shape::SampleSurface(torus, 400, shape::SamplingMode::Uniform, 3);
  ASSERT_EQ(points.rows(), 400);
  EXPECT_LT(shape::SurfaceLocator(torus).Find(points).Distances.maxCoeff(), 1e-12);
  // Yuksel reports 0.7 and more of the densest packing's spacing; random points give a hundredth.
  const double area = 0.5 * shape::ComputeAreaVectors(torus).rowwise().norm().sum();
  const double densest = 2.0 * std::sqrt(area / (2.0 * std::sqrt(3.0) * 400));
  EXPECT_GT(MinimumSpacing(points), 0.6 * densest);
  EXPECT_EQ(points, shape::SampleSurface(torus, 400, shape::SamplingMode::Uniform, 3));
  EXPECT_NE(points, shape::SampleSurface(torus, 400, shape::SamplingMode::Uniform, 4));
}

TEST(Sampling, AdaptivePutsMorePointsWhereTheSurfaceBends)
{
  // A long ellipsoid: its two tips beyond three quarters of the length.
  shape::Mesh ellipsoid = shapetest::Icosphere(4);
  ellipsoid.Points.col(0) *= 4.0;
  const auto atTips = [&](shape::SamplingMode mode)
  {
    const Eigen::MatrixXd points = shape::SampleSurface(ellipsoid, 300, mode);
    EXPECT_EQ(points.rows(), 300);
    return static_cast<double>((points.col(0).array().abs() > 3.0).count()) / points.rows();
  };
  EXPECT_GT(
    atTips(shape::SamplingMode::GeometryAdaptive), 1.5 * atTips(shape::SamplingMode::Uniform));
}

TEST(Sampling, QuadricLeavesFlatPartsEmptyAndKeepsTheShape)
{
  const shape::Mesh cube = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const Eigen::MatrixXd corners = shape::SampleSurface(cube, 8, shape::SamplingMode::Quadric);
  // A cube is its eight corners: every other point can go at no cost.
  ASSERT_EQ(corners.rows(), 8);
  for (const auto& corner : corners.rowwise())
  {
    EXPECT_LT((corner.array() - corner.array().round()).abs().maxCoeff(), 1e-6);
  }
}

TEST(Sampling, QuadricPutsMorePointsWhereTheSurfaceBends)
{
  shape::Mesh ellipsoid = shapetest::Icosphere(4);
  ellipsoid.Points.col(0) *= 4.0;
  const auto points = [&](shape::SamplingMode mode)
  { return shape::SampleSurface(ellipsoid, 300, mode); };
  const auto atTips = [](const Eigen::MatrixXd& samples)
  { return (samples.col(0).array().abs() > 3.0).count(); };
  const Eigen::MatrixXd quadric = points(shape::SamplingMode::Quadric);
  EXPECT_NEAR(quadric.rows(), 300, 2);
  EXPECT_GT(atTips(quadric), 1.5 * atTips(points(shape::SamplingMode::Uniform)));
  // They lie near the surface: within the sagitta of a chord between neighbours at its sides.
  EXPECT_LT(shape::SurfaceLocator(ellipsoid).Find(quadric).Distances.maxCoeff(), 0.05);
  EXPECT_EQ(quadric, points(shape::SamplingMode::Quadric));
}

TEST(Sampling, AdaptiveLeavesNoFlatPartEmpty)
{
  // A cube: the whole of its bending is at the edges.
  const shape::Mesh cube = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  constexpr int count = 600;
  const Eigen::MatrixXd points =
    shape::SampleSurface(cube, count, shape::SamplingMode::GeometryAdaptive);
  // Within 0.05 of an edge of its face lie 19 % of the area.
  int nearEdges = 0;
  for (const auto& point : points.rowwise())
  {
    Eigen::Array3d toSides = point.array().min(1.0 - point.array()).transpose();
    std::sort(toSides.begin(), toSides.end());
    nearEdges += toSides(1) < 0.05;
  }
  EXPECT_GT(nearEdges, 0.3 * count);
  // No place of the surface is farther from a sample than 2.5 times what the best spread allows.
  const Eigen::MatrixXd positions =
    shape::SampleSurface(cube, 4000, shape::SamplingMode::Uniform, 7);
  double farthest = 0.0;
  for (const auto& position : positions.rowwise())
  {
    farthest = std::max(farthest, (points.rowwise() - position).rowwise().norm().minCoeff());
  }
  EXPECT_LT(farthest, 2.5 * shape::ComputePackingRadius(6.0, count) * 2.0 / std::sqrt(3.0));
}

TEST(Sampling, AreasMakeASumAnIntegralHoweverDenseTheSamplesAre)
{
  // The mean of x^2 over the surface of a long ellipsoid; adaptive samples crowd at its tips.
  shape::Mesh ellipsoid = shapetest::Icosphere(4);
  ellipsoid.Points.col(0) *= 4.0;
  const auto mean = [](const Eigen::MatrixXd& points, const Eigen::VectorXd& weights)
  { return weights.dot(points.col(0).cwiseAbs2()) / weights.sum(); };
  const Eigen::VectorXd exactWeights = shape::ComputeAreaVectors(ellipsoid).rowwise().norm();
  const double exact = mean(shape::ComputeCentroids(ellipsoid), exactWeights);
  const Eigen::MatrixXd points =
    shape::SampleSurface(ellipsoid, 2000, shape::SamplingMode::GeometryAdaptive);
  const Eigen::VectorXd areas = shape::ComputeSampledAreas(points);
  EXPECT_GT(mean(points, Eigen::VectorXd::Ones(2000)), 1.2 * exact);
  EXPECT_NEAR(mean(points, areas), exact, 0.05 * exact);
  EXPECT_GT(areas.minCoeff(), 0.0);
  EXPECT_EQ(shape::ComputeSampledAreas(Eigen::MatrixXd::Ones(5, 3)), Eigen::VectorXd::Ones(5));
}

TEST(Sampling, RefusesAndAborts)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  EXPECT_THROW(shape::SampleSurface(sphere, 3, shape::SamplingMode::Uniform), shape::InvalidInput);
  const shape::Progress stop([](double) { return false; });
  for (const auto mode : { shape::SamplingMode::Uniform, shape::SamplingMode::GeometryAdaptive,
         shape::SamplingMode::Quadric })
  {
    EXPECT_THROW(shape::SampleSurface(sphere, 100, mode, 1, stop), shape::Aborted);
  }
}

TEST(Sampling, SpatialOrderSpreadsEveryFourthPoint)
{
  const Eigen::MatrixXd points =
    shape::SampleSurface(shapetest::Icosphere(3), 800, shape::SamplingMode::Uniform);
  const Eigen::VectorXi order = shape::FindSpatialOrder(points);
  Eigen::VectorXi sorted = order;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, Eigen::VectorXi::LinSpaced(800, 0, 799));
  const Eigen::MatrixXd subset = points(order(Eigen::seq(0, 799, 4)), Eigen::all);
  // Each octant holds its share of the subset to a few points.
  for (int octant = 0; octant < 8; ++octant)
  {
    int inside = 0;
    for (Eigen::Index i = 0; i < subset.rows(); ++i)
    {
      inside += (subset(i, 0) > 0) + 2 * (subset(i, 1) > 0) + 4 * (subset(i, 2) > 0) == octant;
    }
    EXPECT_NEAR(inside, 25, 5);
  }
}

TEST(OutsideDomain, SparesWhatAMeshOfTheSmoothSurfaceSticksOut)
{
  const shape::SignedDistance field(shapetest::Icosphere(2));
  // Points on the smooth sphere lie outside the facets by up to the sagitta.
  const Eigen::MatrixXd onSphere = shapetest::Icosphere(4).Points;
  EXPECT_EQ(shape::FindPointsOutsideDomain(field, onSphere, 0.1).sum(), 0);
  EXPECT_EQ(shape::FindPointsOutsideDomain(field, 0.5 * onSphere, 0.1).sum(), 0);
  EXPECT_EQ(shape::FindPointsOutsideDomain(field, 1.2 * onSphere, 0.1).sum(), onSphere.rows());
}

TEST(OutsideDomain, TheToleranceStaysWellWithinTheCharges)
{
  // The cube's triangles are so large that a quarter of their edges reaches past charges at 0.1.
  const shape::Mesh cube = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const shape::SignedDistance field(cube);
  Eigen::MatrixXd points(3, 3);
  points << 1.04, 0.5, 0.5, 1.06, 0.5, 0.5, 0.5, 0.5, 0.5;
  EXPECT_EQ(shape::FindPointsOutsideDomain(field, points, 0.05), Eigen::Vector3i(0, 1, 0));
  EXPECT_EQ(shape::FindPointsOutsideDomain(field, points, 1.0), Eigen::Vector3i(0, 0, 0));
}
