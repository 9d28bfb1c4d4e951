#include "CutPaste/CutPoints.h"
#include "CutPaste/PasteFeature.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using Eigen::RowVector3d;

/// Points of the unit sphere with a bump of height 0.4 at (0, 0, 1).
Eigen::MatrixXd BumpySphere(int level)
{
  Eigen::MatrixXd points = shapetest::Icosphere(level).Points;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> by(-0.2, 0.2);
  const double edge = 1.1 / std::pow(2.0, level);
  for (auto point : points.rowwise())
  {
    const RowVector3d moved =
      (point + edge * RowVector3d(by(random), by(random), by(random))).normalized();
    const double t = (moved - RowVector3d(0, 0, 1)).squaredNorm() / 0.2;
    point = moved * (1.0 + 0.4 * std::pow(std::max(0.0, 1.0 - t), 3));
  }
  return points;
}

/// A circle of the sphere, at an angle from +z, counter-clockwise.
Eigen::MatrixXd CircleAroundTop(double angle, int count)
{
  Eigen::MatrixXd circle(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double turn = 2.0 * M_PI * i / count;
    circle.row(i) << std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
      std::cos(angle);
  }
  return circle;
}

struct Clouds
{
  shape::CutPointsResult Cut;
  shape::SampledSurface All, Feature, Rest;
};

Clouds CutBump(const Eigen::MatrixXd& points, const Eigen::MatrixXd& circle)
{
  Clouds clouds;
  shape::PointCutter cutter(shape::ConnectSamples(points));
  clouds.All = cutter.Sampled();
  clouds.Cut = cutter.Cut(circle);
  const Eigen::MatrixXd& normals = clouds.All.Normals;
  clouds.Feature = shape::ConnectSamples(
    points(clouds.Cut.Feature, Eigen::all), normals(clouds.Cut.Feature, Eigen::all));
  const Eigen::Index added = clouds.Cut.FillNormals.rows();
  Eigen::MatrixXd rest(clouds.Cut.Rest.size() + added, 3), restNormals(rest.rows(), 3);
  rest << points(clouds.Cut.Rest, Eigen::all), clouds.Cut.Fill.Points.bottomRows(added);
  restNormals << normals(clouds.Cut.Rest, Eigen::all), clouds.Cut.FillNormals;
  clouds.Rest = shape::ConnectSamples(rest, restNormals);
  return clouds;
}

double LargestDistance(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to)
{
  double largest = 0.0;
  for (const auto& point : from.rowwise())
  {
    largest = std::max(largest, (to.rowwise() - point).rowwise().norm().minCoeff());
  }
  return largest;
}

} // namespace

TEST(CutPoints, DividesASphereAlongACircle)
{
  const Eigen::MatrixXd points = BumpySphere(5);
  const double angle = 0.7;
  const Clouds clouds = CutBump(points, CircleAroundTop(angle, 12));
  const shape::PointCutter cutter(shape::ConnectSamples(points));
  // Points farther from the circle than a few spacings are on their side of it.
  std::vector<char> isFeature(points.rows(), 0);
  for (const int point : clouds.Cut.Feature)
  {
    isFeature[point] = 1;
  }
  double farthest = 0.0;
  for (const int point : clouds.Cut.Loop)
  {
    farthest = std::max(
      farthest, std::abs(std::atan2(points.row(point).head<2>().norm(), points(point, 2)) - angle));
  }
  // The path stays within about one link of the geodesic between the circle's 12 points, which are
  // 0.34 apart; the geodesic leaves the circle by at most 0.34^2 / 8 / tan(angle).
  EXPECT_LT(farthest, 1.5 * cutter.Spacing() + 0.34 * 0.34 / 8.0 / std::tan(angle));
  EXPECT_NEAR(clouds.Cut.CutLength / (2.0 * M_PI * std::sin(angle)), 1.0, 0.15);
  int wrong = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const double at = std::atan2(points.row(i).head<2>().norm(), points(i, 2));
    wrong += std::abs(at - angle) > farthest && (at < angle) != (isFeature[i] != 0) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  // The fill continues the sphere.
  const Eigen::MatrixXd added = clouds.Cut.Fill.Points.bottomRows(clouds.Cut.FillNormals.rows());
  EXPECT_LT((added.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-4);
  EXPECT_LT(
    (added.rowwise().normalized() - clouds.Cut.FillNormals).rowwise().norm().maxCoeff(), 1e-3);
  // As dense as the sphere's own points, of which each has the area 4 pi / n.
  const double cap = 2.0 * M_PI * (1.0 - std::cos(angle));
  EXPECT_NEAR(static_cast<double>(added.rows() + clouds.Cut.Loop.size()) /
      (cap / 4.0 / M_PI * static_cast<double>(points.rows())),
    1.0, 0.25);
}

TEST(CutPoints, ReturnsWhenPastedInPlace)
{
  const Eigen::MatrixXd points = BumpySphere(4);
  const Clouds clouds = CutBump(points, CircleAroundTop(0.7, 12));
  const shape::FeatureFootprint& base = clouds.Cut.Bases.front();
  EXPECT_TRUE(base.ReturnsInPlace);
  const shape::FeatureToPaste feature(clouds.Feature.Surface, base);
  shape::PointTarget target(clouds.Rest);
  const shape::PastedFeature back =
    feature.PasteOn(target, clouds.Feature.Normals, { base.Origin, 0.0, 1.0 });
  EXPECT_EQ(back.Surface.Points.rows(), points.rows());
  EXPECT_LT(LargestDistance(points, back.Surface.Points), 1e-12);
  EXPECT_LT(LargestDistance(back.Surface.Points, points), 1e-12);
  EXPECT_EQ(back.AddedPoints, 0);
  const Eigen::Index ofFeature = clouds.Feature.Normals.rows();
  EXPECT_LT(
    (back.Normals.bottomRows(ofFeature) - clouds.Feature.Normals).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CutPoints, PastesOnAnotherCloud)
{
  const Clouds clouds = CutBump(BumpySphere(5), CircleAroundTop(0.7, 12));
  const shape::FeatureFootprint& base = clouds.Cut.Bases.front();
  const shape::FeatureToPaste feature(clouds.Feature.Surface, base);
  shape::PointTarget target(shape::ConnectSamples(1.5 * BumpySphere(5)));
  for (const RowVector3d& seed : { RowVector3d(1, 0, 0), RowVector3d(0, 1, -1),
         RowVector3d(-1, 0.3, 0.2), RowVector3d(0.3, 0.2, -1) })
  {
    const shape::PastedFeature pasted =
      feature.PasteOn(target, clouds.Feature.Normals, { 1.5 * seed.normalized(), 30.0, 1.0 });
    EXPECT_LE(pasted.LargestGap, pasted.Spacing);
    EXPECT_GT(pasted.AddedPoints, 0);
    EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.5), 1.0);
    // The bump stands on the sphere of radius 1.5, as high as on its own.
    const double top = pasted.Surface.Points.bottomRows(feature.Surface().Points().rows())
                         .rowwise()
                         .norm()
                         .maxCoeff();
    EXPECT_NEAR(top, 1.9, 0.01);
  }
}

TEST(CutPoints, FollowsRigidMotionsAndNumbers)
{
  const Eigen::MatrixXd points = BumpySphere(4);
  const Eigen::MatrixXd normals = points.rowwise().normalized();
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.4).normalized()).toRotationMatrix();
  const RowVector3d shift(0.3, -2.0, 5.0);
  const auto move = [&](const Eigen::MatrixXd& places) -> Eigen::MatrixXd
  { return (places * turn.transpose()).rowwise() + shift; };
  std::vector<int> order(points.rows());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(11));
  const Eigen::MatrixXd circle = CircleAroundTop(0.7, 12);
  const shape::CutPointsResult cut =
    shape::PointCutter(shape::ConnectSamples(points, normals)).Cut(circle);
  const shape::CutPointsResult moved =
    shape::PointCutter(shape::ConnectSamples(move(points), normals * turn.transpose()))
      .Cut(move(circle));
  EXPECT_EQ(moved.Feature, cut.Feature);
  EXPECT_EQ(moved.Loop, cut.Loop);
  ASSERT_EQ(moved.Fill.Points.rows(), cut.Fill.Points.rows());
  EXPECT_LT(LargestDistance(move(cut.Fill.Points), moved.Fill.Points), 1e-9);
  const Eigen::MatrixXd other = points(order, Eigen::all);
  const shape::CutPointsResult renumbered =
    shape::PointCutter(shape::ConnectSamples(other, normals(order, Eigen::all))).Cut(circle);
  std::vector<int> given;
  for (const int point : renumbered.Feature)
  {
    given.push_back(order[point]);
  }
  std::sort(given.begin(), given.end());
  EXPECT_EQ(given, cut.Feature);
  EXPECT_LT(LargestDistance(cut.Fill.Points, renumbered.Fill.Points), 1e-9);
}

TEST(CutPoints, PastesOnAPlaneAsItIs)
{
  // A bump on a plane, moved to another place of it: a translation.
  const int side = 60;
  Eigen::MatrixXd points(side * side, 3);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> by(-0.3, 0.3);
  for (int i = 0; i < side * side; ++i)
  {
    points.row(i) << i % side + by(random), i / side + by(random), 0.0;
  }
  const Eigen::MatrixXd flat = points;
  for (auto point : points.rowwise())
  {
    const double t = (point - RowVector3d(20, 20, 0)).squaredNorm() / 64.0;
    point.z() = 5.0 * std::pow(std::max(0.0, 1.0 - t), 3);
  }
  Eigen::MatrixXd circle(16, 3);
  for (int i = 0; i < 16; ++i)
  {
    circle.row(i) << 20 + 13 * std::cos(M_PI * i / 8), 20 + 13 * std::sin(M_PI * i / 8), 0;
  }
  const Clouds clouds = CutBump(points, circle);
  const shape::FeatureFootprint& base = clouds.Cut.Bases.front();
  EXPECT_LT(clouds.Cut.Fill.Points.col(2).cwiseAbs().maxCoeff(), 1e-9);
  const shape::FeatureToPaste feature(clouds.Feature.Surface, base);
  shape::PointTarget target(
    shape::ConnectSamples(flat, RowVector3d(base.Normal).replicate(flat.rows(), 1)));
  const RowVector3d offset(15.3, 16.7, 0.0);
  const shape::PastedFeature pasted =
    feature.PasteOn(target, clouds.Feature.Normals, { base.Origin + offset, 0.0, 1.0 });
  const Eigen::MatrixXd expected = feature.Surface().Points().rowwise() + offset;
  EXPECT_LT(
    (pasted.Surface.Points.bottomRows(expected.rows()) - expected).rowwise().norm().maxCoeff(),
    1e-9);
  EXPECT_LE(pasted.LargestGap, pasted.Spacing);
  EXPECT_LT(
    (pasted.Normals.bottomRows(expected.rows()) - clouds.Feature.Normals).cwiseAbs().maxCoeff(),
    1e-9);
  EXPECT_LT((pasted.Normals.topRows(pasted.Normals.rows() - expected.rows()).rowwise() -
              RowVector3d(base.Normal))
              .cwiseAbs()
              .maxCoeff(),
    1e-12);
}

TEST(CutPoints, RefusesWhatCannotBeCut)
{
  const Eigen::MatrixXd torus = shapetest::Torus(1.0, 0.4, 60, 30).Points;
  shape::PointCutter cutter(shape::ConnectSamples(torus));
  Eigen::MatrixXd around(6, 3), spot = RowVector3d(1.4, 0, 0).replicate(4, 1);
  for (int i = 0; i < 6; ++i)
  {
    around.row(i) << 1.0 + 0.4 * std::cos(M_PI * i / 3), 0.0, 0.4 * std::sin(M_PI * i / 3);
  }
  EXPECT_REFUSED(cutter.Cut(around), "does not divide the points");
  EXPECT_REFUSED(cutter.Cut(spot), "draw a wider loop");
  Eigen::MatrixXd two(2 * torus.rows(), 3);
  two << torus, torus.rowwise() + RowVector3d(5, 0, 0);
  shape::PointCutter far(shape::ConnectSamples(two));
  around.bottomRows(3).rowwise() += RowVector3d(5, 0, 0);
  EXPECT_REFUSED(far.Cut(around), "gap between them is wider");
}
