#include "Remesh/SurfaceFeatures.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

/// A roof 10 long whose sides rise by an angle that changes from one end to the other, in degrees.
shape::Mesh MakeRoof(double first, double last)
{
  constexpr int steps = 10;
  shape::Mesh roof{ Eigen::MatrixXd(3 * (steps + 1), 3), Eigen::MatrixXi(6 * steps + 2, 3) };
  int t = 0;
  for (int i = 0; i <= steps; ++i)
  {
    roof.Points.row(3 * i) << i, -1.0, 0.0;
    roof.Points.row(3 * i + 1) << i, 0.0,
      std::tan((first + (last - first) * i / steps) * M_PI / 180.0);
    roof.Points.row(3 * i + 2) << i, 1.0, 0.0;
    for (int k = 0; i < steps && k < 3; ++k) // two sides, and the floor
    {
      const int a = 3 * i + k, b = 3 * i + (k + 1) % 3;
      roof.Triangles.row(t++) << a, a + 3, b + 3;
      roof.Triangles.row(t++) << a, b + 3, b;
    }
  }
  roof.Triangles.row(t++) << 0, 1, 2;
  roof.Triangles.row(t++) << 3 * steps, 3 * steps + 2, 3 * steps + 1;
  return roof;
}

} // namespace

TEST(SurfaceFeatures, OfAnLAreItsSidesEdgesAndCorners)
{
  // Its inner corner is point 0, so that the fans are right.
  const shape::Mesh bracket =
    shapetest::Prism({ { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 }, { 2, 0 }, { 2, 1 } });
  const shape::SurfaceFeatures features = shape::FindFeatures(bracket, 40.0, 0.0);
  EXPECT_EQ(features.Patches, 8);
  EXPECT_EQ(features.Corners.size(), 12U);
  EXPECT_EQ(features.Curves.size(), 18U);
  EXPECT_DOUBLE_EQ(features.CreaseLength, 2.0 * 8.0 + 6.0);
  EXPECT_DOUBLE_EQ(features.CurveLength, features.CreaseLength);
  int concave = 0;
  for (const shape::FeatureCurve& curve : features.Curves)
  {
    EXPECT_FALSE(curve.Closed);
    EXPECT_EQ(curve.Points.size(), 2U);
    EXPECT_NEAR(curve.Angle, curve.Angle > 180.0 ? 270.0 : 90.0, 1e-9);
    concave += curve.Angle > 180.0;
  }
  EXPECT_EQ(concave, 1);
  EXPECT_EQ(shape::FindFeatures(bracket, 100.0, 0.0).Patches, 1);
}

TEST(SurfaceFeatures, OfACylinderAreTwoClosedCurves)
{
  std::vector<Eigen::RowVector2d> circle;
  for (int i = 0; i < 48; ++i)
  {
    circle.emplace_back(std::cos(i * M_PI / 24.0), std::sin(i * M_PI / 24.0));
  }
  const shape::SurfaceFeatures features = shape::FindFeatures(shapetest::Prism(circle), 40.0, 0.0);
  EXPECT_EQ(features.Patches, 3);
  EXPECT_TRUE(features.Corners.empty());
  ASSERT_EQ(features.Curves.size(), 2U);
  for (const shape::FeatureCurve& curve : features.Curves)
  {
    EXPECT_TRUE(curve.Closed);
    EXPECT_EQ(curve.Points.size(), 48U);
    EXPECT_NEAR(curve.Angle, 90.0, 1e-9);
  }
}

TEST(SurfaceFeatures, SmallPatchesJoinTheirNeighbours)
{
  // The sides of a flat cylinder are smaller than its ends.
  std::vector<Eigen::RowVector2d> square = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  const shape::Mesh plate = shapetest::Prism(square);
  EXPECT_EQ(shape::FindFeatures(plate, 40.0, 3.9).Patches, 6);
  const shape::SurfaceFeatures united = shape::FindFeatures(plate, 40.0, 4.1);
  EXPECT_LT(united.Patches, 6);
  EXPECT_LT(united.CurveLength, united.CreaseLength);
  const shape::SurfaceFeatures none = shape::FindFeatures(plate, 40.0, 1000.0);
  EXPECT_EQ(none.Patches, 1);
  EXPECT_TRUE(none.Curves.empty());
  EXPECT_EQ(shape::RemoveCurves(united).Patches, 1);
  const std::vector<shape::Mesh> patches =
    shape::SplitIntoPatches(plate, shape::FindFeatures(plate, 40.0, 0.0));
  ASSERT_EQ(patches.size(), 6U);
  double area = 0.0;
  for (const shape::Mesh& patch : patches)
  {
    EXPECT_EQ(patch.Points.rows(), 4);
    area += 0.5 * shape::ComputeAreaVectors(patch).rowwise().norm().sum();
  }
  EXPECT_DOUBLE_EQ(area, 2.0 * 16.0 + 4.0 * 4.0);
}

TEST(SurfaceFeatures, WhatIsSharpAroundSpikesAloneIsNoise)
{
  shape::Mesh scan = shapetest::Icosphere(4); // 2562 points
  for (int point = 0; point < 2000; point += 100)
  {
    scan.Points.row(point) *= 1.1;
  }
  const shape::SurfaceFeatures none = shape::FindFeatures(scan, 40.0, 0.0);
  EXPECT_GT(none.CreaseLength, 0.0);
  EXPECT_EQ(none.CurveShare(), 0.0);
  EXPECT_EQ(none.Patches, 1);
  EXPECT_TRUE(none.Curves.empty());
  // A rim that is longer than all of these together is none.
  shape::Mesh half = shapetest::Icosphere(4);
  half.Points.col(2) = half.Points.col(2).cwiseMax(0.0);
  const shape::SurfaceFeatures loop = shape::FindFeatures(half, 40.0, 1.0);
  EXPECT_EQ(loop.Patches, 2);
  EXPECT_EQ(loop.Curves.size(), 1U);
}

TEST(SurfaceFeatures, ACreaseThatFadesOutGoesOnToTheNextOne)
{
  const shape::Mesh fading = MakeRoof(30.0, 15.0);
  ASSERT_GT(shape::ComputeEnclosedVolume(fading), 0.0);
  const shape::SurfaceFeatures features = shape::FindFeatures(fading, 40.0, 0.0);
  EXPECT_EQ(features.Patches, 5); // two sides, the floor, two gables
  EXPECT_EQ(features.Corners.size(), 6U);
  EXPECT_EQ(features.CurveShare(), 1.0);
  // One that fades out altogether parts nothing, and the share tells.
  const shape::SurfaceFeatures lost = shape::FindFeatures(MakeRoof(30.0, 2.0), 40.0, 0.0);
  EXPECT_EQ(lost.Patches, 4);
  EXPECT_LT(lost.CurveShare(), 0.95);
  EXPECT_GT(lost.CurveShare(), 0.8);
}

TEST(SurfaceFeatures, GivenPatchesAreBoundedByTheirBordersHoweverSmooth)
{
  const shape::Surface sphere = shapetest::Icosphere(3);
  const Eigen::VectorXd heights = shape::ComputeCentroids(sphere).col(2);
  // Both caps have the same number, but they are not connected.
  Eigen::VectorXi given = (heights.array().abs() > 0.5).cast<int>();
  const shape::SurfaceFeatures features = shape::FindFeatures(sphere, given, 0.0);
  EXPECT_EQ(features.Patches, 3);
  ASSERT_EQ(features.Curves.size(), 2U);
  double length = 0.0;
  for (const shape::FeatureCurve& curve : features.Curves)
  {
    EXPECT_TRUE(curve.Closed);
    EXPECT_NEAR(curve.Angle, 180.0, 15.0);
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      length += (sphere.Points().row(curve.Points[i]) -
        sphere.Points().row(curve.Points[(i + 1) % curve.Points.size()]))
                  .norm();
    }
  }
  EXPECT_NEAR(features.CurveLength, length, 1e-12);
  EXPECT_EQ(features.CurveLength, features.CreaseLength);
  // A patch of a single triangle is too small for cells.
  given(0) = 7;
  EXPECT_EQ(shape::FindFeatures(sphere, given, 0.0).Patches, 4);
  EXPECT_EQ(shape::FindFeatures(sphere, given, 0.1).Patches, 3);
}
