#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/PiecewiseVolumeMap.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using shapetest::Sphere;

/// A sphere whose points go to `factor` times their places.
shape::ExactSurface Scaled(const shape::Mesh& surface, double factor)
{
  return { surface, factor * surface.Points, "the border" };
}

shape::PiecewiseVolumeMapResult MapBall(const std::vector<shape::ExactSurface>& surfaces)
{
  const shape::Mesh ball = Sphere(2, 1.0);
  return shape::ComputePiecewiseVolumeMap(ball, ball.Points, surfaces);
}

} // namespace

TEST(LayeredVolumeMap, NestedSpheresThatGrowDifferentlyAreMappedRadially)
{
  // Radius 2 keeps its size, radius 1 grows by half: between, each coordinate is y_i (a + b / r^3)
  // with a + b / 8 = 1 and a + b = 1.5; inside, 1.5 y_i. Neither is the other's continuation.
  const shape::Mesh outer = Sphere(3, 2.0);
  const auto result =
    shape::ComputePiecewiseVolumeMap(outer, outer.Points, { Scaled(Sphere(3, 1.0), 1.5) });
  ASSERT_EQ(result.Charges.Maps.size(), 2u);
  const shape::PiecewiseHarmonicMap map(result.Charges);
  const Eigen::MatrixXd unit = shapetest::Icosphere(2).Points;
  for (const double radius : { 0.2, 0.6, 0.9, 1.1, 1.4, 1.9 })
  {
    const double factor = radius < 1.0 ? 1.5 : 13.0 / 14.0 + 4.0 / 7.0 / std::pow(radius, 3);
    const Eigen::MatrixXd values = map.Evaluate(radius * unit);
    // The spheres are polyhedra: their sagitta is 1/200 of the radius.
    EXPECT_LT((values - factor * radius * unit).rowwise().norm().maxCoeff(), 0.012) << radius;
  }
  for (const auto& boundary : result.Borders)
  {
    EXPECT_LT(boundary.RMSEInside, 2e-3);
  }
  EXPECT_EQ(result.Borders[0].JumpMaximum, 0.0);
  EXPECT_GT(result.Borders[1].JumpRMS, 0.0);
  EXPECT_LT(result.Borders[1].JumpRMS, 1e-3);
  EXPECT_GE(result.Borders[1].JumpMaximum, result.Borders[1].JumpRMS);
}

TEST(LayeredVolumeMap, IsContinuousToRoundingAndMeetsTheBordersBothSides)
{
  const shape::Mesh outer = Sphere(3, 2.0), middle = Sphere(3, 1.3), core = Sphere(2, 0.7);
  const auto result = shape::ComputePiecewiseVolumeMap(
    outer, outer.Points, { Scaled(core, 1.5), Scaled(middle, 1.2) });
  // Regions are numbered by the order given, not by what is inside what.
  const shape::PiecewiseHarmonicMap map(result.Charges);
  EXPECT_EQ(map.RegionsAt(Eigen::RowVector3d(0.1, 0, 0))(0), 1);
  EXPECT_EQ(map.RegionsAt(Eigen::RowVector3d(1.0, 0, 0))(0), 2);
  EXPECT_EQ(map.RegionsAt(Eigen::RowVector3d(1.7, 0, 0))(0), 0);
  for (const shape::Mesh& boundary : { middle, core })
  {
    const Eigen::MatrixXd normals = shape::ComputeAreaVectors(boundary).rowwise().normalized();
    const Eigen::MatrixXd positions = shape::ComputeCentroids(boundary);
    const Eigen::MatrixXd outside = map.Evaluate(positions + 1e-10 * normals);
    const Eigen::MatrixXd inside = map.Evaluate(positions - 1e-10 * normals);
    EXPECT_LT((outside - inside).rowwise().norm().maxCoeff() / 4.0, 1e-9);
  }
}

TEST(LayeredVolumeMap, PiecesThatDoNotTouchHaveMapsAndNumbersOfTheirOwn)
{
  const shape::Mesh ball = Sphere(3, 1.0);
  const shape::Mesh pair =
    shapetest::Joined({ Sphere(2, 0.25, { 0.5, 0, 0 }), Sphere(2, 0.2, { -0.5, 0, 0 }) });
  const auto result = shape::ComputePiecewiseVolumeMap(ball, ball.Points, { Scaled(pair, 1.1) });
  ASSERT_EQ(result.Charges.Maps.size(), 3u);
  const shape::PiecewiseHarmonicMap map(result.Charges);
  EXPECT_EQ(map.RegionsAt(Eigen::RowVector3d(0.5, 0, 0))(0), 1);
  EXPECT_EQ(map.RegionsAt(Eigen::RowVector3d(-0.5, 0, 0))(0), 2);
  EXPECT_NEAR(map.Evaluate(Eigen::RowVector3d(0.5, 0, 0))(0), 0.55, 5e-3);
  EXPECT_NEAR(map.Evaluate(Eigen::RowVector3d(-0.5, 0, 0))(0), -0.55, 5e-3);
  // A shell: what is inside its inner wall is around it again, and not connected.
  const auto shell = shape::ComputePiecewiseVolumeMap(
    ball, ball.Points, { Scaled(shapetest::Joined({ Sphere(3, 0.8), Sphere(2, 0.4) }), 1.05) });
  EXPECT_EQ(shell.Charges.Maps.size(), 3u);
  const shape::PiecewiseHarmonicMap around(shell.Charges);
  EXPECT_EQ(around.RegionsAt(Eigen::RowVector3d(0.6, 0, 0))(0), 1);
  EXPECT_EQ(around.RegionsAt(Eigen::RowVector3d(0.1, 0, 0))(0), 2);
}

TEST(LayeredVolumeMap, VoidsAndSoftFeaturesBelongToTheirLayers)
{
  const shape::Mesh ball = Sphere(3, 1.0);
  const shape::Mesh hollow = shapetest::Joined({ ball, Sphere(2, 0.2) });
  shape::VolumeFeatures features;
  features.Points = Eigen::MatrixXd(2, 3);
  features.Points << 0.4, 0, 0, 0, 0.85, 0;
  features.Targets = features.Points;
  features.Targets(0, 1) += 0.01;
  const auto result = shape::ComputePiecewiseVolumeMap(
    hollow, hollow.Points, { { Sphere(3, 0.7), Sphere(3, 0.7).Points, "the border" } }, features);
  const shape::PiecewiseHarmonicMap map(result.Charges);
  EXPECT_EQ(shape::ApplyVolumeMap(map, Eigen::RowVector3d(0.1, 0, 0)).OutsideDomain(0), 1);
  EXPECT_GT(result.RMSEFeatures, 0.0);
  EXPECT_LT(result.RMSEFeatures, 0.01 / 2.0) << "softly met, in the one layer";
}

TEST(LayeredVolumeMap, WithoutSurfacesItIsTheHarmonicVolumeMap)
{
  const shape::Mesh ball = Sphere(2, 1.0);
  Eigen::MatrixXd targets = ball.Points;
  targets.col(0) = targets.col(0).array() + 0.2 * targets.col(1).array().square();
  const auto layered = shape::ComputePiecewiseVolumeMap(ball, targets, {});
  const auto plain = shape::ComputeHarmonicVolumeMap(ball, targets);
  const Eigen::MatrixXd positions = 0.7 * ball.Points;
  EXPECT_EQ(shape::PiecewiseHarmonicMap(layered.Charges).Evaluate(positions),
    Evaluate(plain.Map, positions));
  EXPECT_NEAR(layered.OffsetDistance, plain.OffsetDistance, 1e-15);
  EXPECT_NEAR(layered.Borders[0].RMSEInside, plain.Levels.back().RMSEInside, 1e-12);
}

TEST(LayeredVolumeMap, SaysWhatIsWrongWithABorder)
{
  EXPECT_REFUSED(MapBall({ Scaled(Sphere(2, 0.5, { 0.7, 0, 0 }), 1.0) }), "cross");
  EXPECT_REFUSED(MapBall({ Scaled(Sphere(2, 0.5, { 3.0, 0, 0 }), 1.0) }), "outside");
  const shape::Mesh open = shapetest::WithoutLast(Sphere(2, 0.5));
  EXPECT_REFUSED(MapBall({ Scaled(open, 1.0) }), "the border has 1 open loop");
  EXPECT_REFUSED(
    MapBall({ Scaled(Sphere(2, 0.4), 1.0), Scaled(Sphere(2, 0.4, { 0.2, 0, 0 }), 1.0) }), "cross");
  shape::ExactSurface wrong = Scaled(Sphere(2, 0.5), 1.0);
  wrong.Targets(5, 1) = std::nan("");
  EXPECT_REFUSED(MapBall({ wrong }), "finite");
  const shape::Mesh ball = Sphere(2, 1.0);
  EXPECT_THROW(shape::ComputePiecewiseVolumeMap(ball, ball.Points, { Scaled(Sphere(2, 0.5), 1.2) },
                 {}, {}, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
