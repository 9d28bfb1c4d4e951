#include "Fill/CloudHoles.h"
#include "Fill/FillHoles.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using Eigen::RowVector3d;

/// Points of the unit sphere without caps of these angles around these directions, moved at random
/// by up to `noise` spacings along the sphere.
Eigen::MatrixXd SphereWithout(
  const std::vector<std::pair<RowVector3d, double>>& caps, int level, double noise, int seed)
{
  const Eigen::MatrixXd points = shapetest::Icosphere(level).Points;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-noise, noise);
  std::vector<RowVector3d> kept;
  for (const auto& point : points.rowwise())
  {
    const RowVector3d moved =
      (point + 1.1 / (1 << level) * RowVector3d(by(random), by(random), by(random))).normalized();
    bool isOut = false;
    for (const auto& [direction, angle] : caps)
    {
      isOut = isOut || moved.dot(direction.normalized()) > std::cos(angle);
    }
    if (!isOut)
    {
      kept.push_back(moved);
    }
  }
  Eigen::MatrixXd rest(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    rest.row(static_cast<Eigen::Index>(i)) = kept[i];
  }
  return rest;
}

Eigen::MatrixXd Sheet(int side, double noise)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> by(-noise, noise);
  std::vector<RowVector3d> kept;
  for (int i = 0; i < side * side; ++i)
  {
    const RowVector3d point(i % side + by(random), i / side + by(random), 0.0);
    if ((point - RowVector3d(0.5 * side, 0.4 * side, 0.0)).norm() > 0.15 * side)
    {
      kept.push_back(point);
    }
  }
  Eigen::MatrixXd points(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    points.row(static_cast<Eigen::Index>(i)) = kept[i];
  }
  return points;
}

RowVector3d AreaVector(const Eigen::MatrixXd& points, const std::vector<int>& loop)
{
  RowVector3d area = RowVector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const RowVector3d here = points.row(loop[i]), next = points.row(loop[(i + 1) % loop.size()]);
    area += 0.5 * here.cross(next);
  }
  return area;
}

} // namespace

TEST(CloudHoles, FindsTheCapsThatAreMissing)
{
  const std::vector<std::pair<RowVector3d, double>> caps = { { RowVector3d(0, 0, 1), 0.6 },
    { RowVector3d(1, -1, -0.5), 0.35 } };
  for (const double noise : { 0.0, 0.15, 0.3 })
  {
    const shape::SampledSurface samples = shape::ConnectSamples(SphereWithout(caps, 5, noise, 1));
    const double spacing = shape::ComputeSpacing(samples);
    const shape::CloudBoundary boundary = shape::FindCloudBoundary(samples);
    ASSERT_EQ(boundary.Holes.size(), 2U) << noise;
    EXPECT_EQ(boundary.Outer.size(), 0U);
    for (std::size_t k = 0; k < 2; ++k)
    {
      const RowVector3d direction = caps[k].first.normalized();
      const std::vector<int>& loop = boundary.Holes[k];
      const RowVector3d area = AreaVector(samples.Surface.Points, loop);
      for (const int point : loop)
      {
        const RowVector3d here = samples.Surface.Points.row(point);
        // The loop passes through the first points outside the cap.
        const double angle = std::acos(here.dot(direction));
        EXPECT_GE(angle, caps[k].second - 1e-9);
        EXPECT_LE(angle, caps[k].second + 2.0 * spacing);
      }
      // Once around, with the hole to the left.
      const double radius = std::sin(caps[k].second);
      EXPECT_GE(area.dot(direction), 0.95 * M_PI * radius * radius);
      EXPECT_LE(area.dot(direction), M_PI * std::pow(radius + 2.0 * spacing, 2));
    }
    // Filled, each new point is within the mean spacing of the sphere.
    shape::SurfaceFiller filler(shape::Surface(samples.Surface.Points, Eigen::MatrixXi(0, 3)),
      boundary.Holes, samples.Normals);
    const shape::FilledSurface filled = filler.Fill({});
    const Eigen::Index added = filled.Surface.Points.rows() - samples.Surface.Points.rows();
    EXPECT_GT(added, 100);
    EXPECT_LT(
      (filled.Surface.Points.bottomRows(added).rowwise().norm().array() - 1.0).abs().maxCoeff(),
      spacing);
  }
}

TEST(CloudHoles, FindsNoneInClosedClouds)
{
  for (const double noise : { 0.0, 0.15, 0.3 })
  {
    const shape::CloudBoundary sphere =
      shape::FindCloudBoundary(shape::ConnectSamples(SphereWithout({}, 5, noise, 4)));
    EXPECT_EQ(sphere.Holes.size() + sphere.Outer.size(), 0U);
  }
  const shape::CloudBoundary torus =
    shape::FindCloudBoundary(shape::ConnectSamples(shapetest::Torus(1.0, 0.4, 60, 30).Points));
  EXPECT_EQ(torus.Holes.size() + torus.Outer.size(), 0U);
}

TEST(CloudHoles, TellsOuterBoundariesFromHoles)
{
  for (const double noise : { 0.0, 0.3 })
  {
    const shape::SampledSurface samples = shape::ConnectSamples(Sheet(50, noise));
    const shape::CloudBoundary sheet = shape::FindCloudBoundary(samples);
    ASSERT_EQ(sheet.Outer.size(), 1U) << noise;
    ASSERT_EQ(sheet.Holes.size(), 1U) << noise;
    // Points at random leave out less than a spacing on each side.
    EXPECT_GT(AreaVector(samples.Surface.Points, sheet.Outer[0]).z(), 48.0 * 48.0);
    EXPECT_LT(AreaVector(samples.Surface.Points, sheet.Outer[0]).z(), 50.0 * 50.0);
  }
  // A bowl with a hole in its bottom.
  const shape::CloudBoundary bowl = shape::FindCloudBoundary(shape::ConnectSamples(
    SphereWithout({ { RowVector3d(0, 0, 1), 2.0 }, { RowVector3d(0, 0, -1), 0.4 } }, 5, 0.15, 6)));
  EXPECT_EQ(bowl.Outer.size(), 1U);
  EXPECT_EQ(bowl.Holes.size(), 1U);
}
