#include "Hex/SurfaceFeatures.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{

/// A prism over a polygon in the plane z = 0, 1 high, its polygons as fans around point 0.
shape::Mesh Prism(const std::vector<Eigen::RowVector2d>& outline)
{
  const auto n = static_cast<int>(outline.size());
  shape::Mesh prism{ Eigen::MatrixXd(2 * n, 3), Eigen::MatrixXi(4 * n - 4, 3) };
  int t = 0;
  for (int i = 0; i < n; ++i)
  {
    const int next = (i + 1) % n;
    prism.Points.row(i) << outline[i], 0.0;
    prism.Points.row(n + i) << outline[i], 1.0;
    prism.Triangles.row(t++) << i, next, n + next;
    prism.Triangles.row(t++) << i, n + next, n + i;
    if (i > 0 && i + 1 < n)
    {
      prism.Triangles.row(t++) << 0, i + 1, i;
      prism.Triangles.row(t++) << n, n + i, n + i + 1;
    }
  }
  return prism;
}

} // namespace

TEST(SurfaceFeatures, OfAnLAreItsSidesEdgesAndCorners)
{
  // Its inner corner is point 0, so that the fans are right.
  const shape::Mesh bracket = Prism({ { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 }, { 2, 0 }, { 2, 1 } });
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
  const shape::SurfaceFeatures features = shape::FindFeatures(Prism(circle), 40.0, 0.0);
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
  const shape::Mesh plate = Prism(square);
  EXPECT_EQ(shape::FindFeatures(plate, 40.0, 3.9).Patches, 6);
  const shape::SurfaceFeatures united = shape::FindFeatures(plate, 40.0, 4.1);
  EXPECT_LT(united.Patches, 6);
  EXPECT_LT(united.CurveLength, united.CreaseLength);
  const shape::SurfaceFeatures none = shape::FindFeatures(plate, 40.0, 1000.0);
  EXPECT_EQ(none.Patches, 1);
  EXPECT_TRUE(none.Curves.empty());
  EXPECT_EQ(shape::WithoutCurves(united).Patches, 1);
  const std::vector<shape::Mesh> patches =
    shape::PatchMeshes(plate, shape::FindFeatures(plate, 40.0, 0.0));
  ASSERT_EQ(patches.size(), 6U);
  double area = 0.0;
  for (const shape::Mesh& patch : patches)
  {
    EXPECT_EQ(patch.Points.rows(), 4);
    area += 0.5 * shape::AreaVectors(patch).rowwise().norm().sum();
  }
  EXPECT_DOUBLE_EQ(area, 2.0 * 16.0 + 4.0 * 4.0);
}
