#include "ExponentialMap/PatchLayout.h"
#include "Geometry/Private/PointNormals.h"
#include "Geometry/SampledSurface.h"
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

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// Points of the square [-1, 1]^2 at random places.
Eigen::MatrixXd RandomSquare(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(count, 3);
  for (auto point : points.rowwise())
  {
    point << place(random), place(random), 0.0;
  }
  return points;
}

/// The image of a point of the unit sphere, seed (0, 0, 1) and x axis (1, 0, 0).
RowVector2d ExactImage(const RowVector3d& point)
{
  const double flat = point.head<2>().norm();
  return std::atan2(flat, point.z()) / std::max(flat, 1e-300) * point.head<2>();
}

struct Errors
{
  double Mean = 0.0, Largest = 0.0;
};

Errors ErrorsOnSphere(shape::ExponentialMap map)
{
  const shape::ExponentialPatch patch = map.Around({ 0, 0, 1 }, 1.5, { 1, 0, 0 });
  Errors errors;
  for (std::size_t row = 0; row < patch.Points.size(); ++row)
  {
    const RowVector2d image = patch.Positions.row(static_cast<Eigen::Index>(row));
    const double error = (image - ExactImage(map.Surface().Points().row(patch.Points[row]))).norm();
    errors.Mean += error / static_cast<double>(patch.Points.size());
    errors.Largest = std::max(errors.Largest, error);
  }
  return errors;
}

/// A sphere whose points are moved along it, so that nothing is regular.
shape::Mesh ShakenSphere(int level)
{
  shape::Mesh sphere = shapetest::Icosphere(level);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> by(-0.25, 0.25);
  const double edge = 1.1 / std::pow(2.0, level);
  for (auto point : sphere.Points.rowwise())
  {
    const RowVector3d moved = point + edge * RowVector3d(by(random), by(random), by(random));
    point = moved.normalized();
  }
  return sphere;
}

} // namespace

TEST(SampledSurface, ConnectsAPlaneByItsDelaunayTriangulation)
{
  const Eigen::MatrixXd points = RandomSquare(2000);
  const shape::SampledSurface samples = shape::ConnectSamples(points);
  // Inside, each triangle is one of all its corners, and no point is in its circle.
  int whole = 0;
  for (Eigen::Index t = 0; t < samples.Shares.size(); ++t)
  {
    const Eigen::RowVector3i corners = samples.Surface.Triangles.row(t);
    const Eigen::Matrix<double, 3, 2> p = points(corners, Eigen::all).leftCols<2>();
    const RowVector2d u = p.row(1) - p.row(0), v = p.row(2) - p.row(0);
    EXPECT_GT(std::abs(u.x() * v.y() - u.y() * v.x()), 0.0);
    if (p.cwiseAbs().maxCoeff() > 0.8)
    {
      continue;
    }
    Eigen::Matrix2d sides;
    sides << u, v;
    const RowVector2d centre = p.row(0) +
      (0.5 * sides.inverse() * Eigen::Vector2d(u.squaredNorm(), v.squaredNorm())).transpose();
    const double radius = (centre - p.row(0)).norm();
    // A neighbourhood of 24 points is as large as 0.12; at some points it is smaller.
    if (radius < 0.07)
    {
      EXPECT_NEAR(samples.Shares(t), 1.0, 1e-12);
    }
    const double nearest = (points.leftCols(2).rowwise() - centre).rowwise().norm().minCoeff();
    EXPECT_GT(nearest, radius - 1e-6);
    ++whole;
  }
  EXPECT_GT(whole, 2000);
  int onRim = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    onRim += samples.OnRim[i] != 0 && points.row(i).cwiseAbs().maxCoeff() < 0.8 ? 1 : 0;
  }
  EXPECT_EQ(onRim, 0);
}

TEST(SampledSurface, SharesAddUpToTheArea)
{
  for (const shape::Mesh& mesh : { shapetest::Icosphere(4), ShakenSphere(4) })
  {
    const shape::SampledSurface samples = shape::ConnectSamples(mesh.Points);
    double area = 0.0;
    for (Eigen::Index t = 0; t < samples.Shares.size(); ++t)
    {
      const Eigen::Matrix3d p =
        samples.Surface.Points(samples.Surface.Triangles.row(t), Eigen::all);
      const RowVector3d u = p.row(1) - p.row(0), v = p.row(2) - p.row(0);
      area += 0.5 * samples.Shares(t) * u.cross(v).norm();
    }
    EXPECT_NEAR(area / (4.0 * M_PI), 1.0, 0.01);
    EXPECT_EQ(std::count(samples.OnRim.begin(), samples.OnRim.end(), 1), 0);
  }
}

TEST(SampledSurface, SeparatesSheetsWithOppositeNormals)
{
  // Two planes a hundredth apart, whose points are five times as far from each other.
  const Eigen::MatrixXd sheet = RandomSquare(1600);
  Eigen::MatrixXd points(2 * sheet.rows(), 3), normals(points.rows(), 3);
  points << sheet, (sheet * 0.99).rowwise() - RowVector3d(0, 0, 0.01);
  normals << RowVector3d(0, 0, 2).replicate(sheet.rows(), 1),
    RowVector3d(0, 0, -1).replicate(sheet.rows(), 1);
  const shape::SampledSurface samples = shape::ConnectSamples(points, normals);
  for (const auto& corners : samples.Surface.Triangles.rowwise())
  {
    const auto below = (corners.array() >= static_cast<int>(sheet.rows())).count();
    EXPECT_TRUE(below == 0 || below == 3);
  }
}

TEST(PointNormals, AreThoseOfATorusAndPointOutwards)
{
  const auto error = [](int around)
  {
    const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 2 * around, around);
    const Eigen::MatrixXd normals = shape::EstimatePointNormals(torus.Points);
    double largest = 0.0;
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
    {
      const RowVector3d point = torus.Points.row(i);
      const RowVector3d centre = RowVector3d(point.x(), point.y(), 0.0).normalized();
      largest = std::max(largest, (normals.row(i) - (point - centre).normalized()).norm());
    }
    return largest;
  };
  EXPECT_LT(error(20), 0.1);
  EXPECT_LT(error(40), 0.5 * error(20));
  EXPECT_LT(error(80), 0.5 * error(40));
}

TEST(SampledExponentialMap, LaysAPlaneOutAsItIs)
{
  // Tilted, with estimated normals: only rounding is left.
  const Eigen::MatrixXd flat = RandomSquare(3000);
  const Eigen::Matrix3d tilt =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
  shape::ExponentialMap map(shape::ConnectSamples(flat * tilt.transpose()));
  const RowVector2d seed(0.11, -0.07);
  const RowVector3d axis = tilt.col(0).transpose();
  const shape::ExponentialPatch patch =
    map.Around(RowVector3d(seed.x(), seed.y(), 0.0) * tilt.transpose(), 0.5, axis);
  EXPECT_GT(patch.Points.size(), 400U);
  double largest = 0.0;
  for (std::size_t row = 0; row < patch.Points.size(); ++row)
  {
    const RowVector2d image = patch.Positions.row(static_cast<Eigen::Index>(row));
    largest = std::max(largest, (image - (flat.row(patch.Points[row]).head(2) - seed)).norm());
  }
  EXPECT_LT(largest, 1e-13);
  const auto near = ((flat.leftCols(2).rowwise() - seed).rowwise().norm().array() <= 0.5).count();
  EXPECT_EQ(static_cast<Eigen::Index>(patch.Points.size()), near);
  EXPECT_TRUE(patch.Flipped.empty());
  EXPECT_FALSE(patch.ReachesBoundary);
  EXPECT_TRUE(map.Around(RowVector3d::Zero(), 0.98, axis).ReachesBoundary);
}

TEST(SampledExponentialMap, ConvergesOnASphereLikeTheMesh)
{
  Errors coarse;
  for (const int level : { 3, 4, 5 })
  {
    const shape::Mesh sphere = ShakenSphere(level);
    const Errors mesh = ErrorsOnSphere(shape::ExponentialMap(sphere));
    const Errors points =
      ErrorsOnSphere(shape::ExponentialMap(shape::ConnectSamples(sphere.Points)));
    // Without triangles, nothing is lost.
    EXPECT_LT(points.Mean, 1.1 * mesh.Mean);
    EXPECT_LT(points.Largest, 1.1 * mesh.Largest);
    if (level > 3)
    {
      EXPECT_LT(points.Mean, 0.6 * coarse.Mean);
    }
    coarse = points;
  }
}

TEST(SampledExponentialMap, ImagesDoNotDependOnCopiesNorOnThePlace)
{
  const shape::Mesh sphere = ShakenSphere(3);
  Eigen::MatrixXd twice(2 * sphere.Points.rows(), 3);
  twice << sphere.Points, sphere.Points;
  shape::ExponentialMap once(shape::ConnectSamples(sphere.Points));
  shape::ExponentialMap copies(shape::ConnectSamples(twice));
  const shape::ExponentialPatch a = once.Around({ 0, 0, 1 }, 0.8, { 1, 0, 0 });
  const shape::ExponentialPatch b = copies.Around({ 0, 0, 1 }, 0.8, { 1, 0, 0 });
  ASSERT_EQ(2 * a.Points.size(), b.Points.size());
  for (std::size_t row = 0; row < a.Points.size(); ++row)
  {
    const auto i = static_cast<Eigen::Index>(row);
    EXPECT_EQ(a.Positions.row(i), b.Positions.row(2 * i));
    EXPECT_EQ(a.Positions.row(i), b.Positions.row(2 * i + 1));
  }
  // Moved rigidly, all distances stay.
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 2).normalized()).toRotationMatrix();
  const Eigen::MatrixXd normals = sphere.Points;
  shape::ExponentialMap given(shape::ConnectSamples(sphere.Points, normals));
  shape::ExponentialMap moved(
    shape::ConnectSamples((sphere.Points * turn.transpose()).rowwise() + RowVector3d(3, 1, 2),
      normals * turn.transpose()));
  const Eigen::VectorXd before = given.Around({ 0, 0, 1 }, 0.8).Distances;
  const Eigen::VectorXd after =
    moved.Around(RowVector3d(0, 0, 1) * turn.transpose() + RowVector3d(3, 1, 2), 0.8).Distances;
  ASSERT_EQ(before.size(), after.size());
  EXPECT_LT((before - after).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SampledExponentialMap, FactsAreThoseOfTheSurface)
{
  // Two balls that touch at no point: a patch stays on one. Around a thin cylinder it overlaps.
  const auto facts = [](const Eigen::MatrixXd& points, const RowVector3d& seed, double radius)
  {
    shape::ExponentialMap map(shape::ConnectSamples(points));
    shape::PatchLayoutOptions options;
    options.Radius = radius;
    return shape::FlattenPatch(map, seed, RowVector3d::Zero(), options);
  };
  const shape::PatchLayout disk = facts(ShakenSphere(5).Points, { 0, 0, 1 }, 0.5);
  EXPECT_NEAR(disk.Facts.Coverage, 1.0, 0.15);
  EXPECT_LT(disk.Facts.Coverage, 1.0);
  EXPECT_EQ(disk.Facts.FlipRate, 0.0);
  EXPECT_FALSE(disk.Facts.Overlaps);
  EXPECT_NEAR(disk.Facts.SymmetricDirichlet.Median, 4.0, 0.05);
  EXPECT_FALSE(facts(ShakenSphere(4).Points, { 0, 0, 1 }, 2.5).Patch.ReachesBoundary);

  const int around = 24, along = 100;
  Eigen::MatrixXd tube(around * along, 3);
  for (int i = 0; i < around * along; ++i)
  {
    const double angle = 2.0 * M_PI * (i % around + 0.3 * std::sin(1.7 * i)) / around;
    tube.row(i) << 0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.05 * (i / around);
  }
  EXPECT_FALSE(facts(tube, { 0.2, 0, 2.5 }, 0.5).Facts.Overlaps);
  EXPECT_GT(facts(tube, { 0.2, 0, 2.5 }, 0.5).Patch.Points.size(), 100U);
}

TEST(SampledExponentialMap, RefusesWhatHasNoSurface)
{
  Eigen::MatrixXd line(10, 3);
  for (int i = 0; i < 10; ++i)
  {
    line.row(i) << i, 2.0 * i, 0.0;
  }
  EXPECT_REFUSED(shape::ConnectSamples(line), "span no surface", "at least 3 points");
  EXPECT_REFUSED(shape::ConnectSamples(line.topRows(1)), "span no surface");
  Eigen::MatrixXd points = RandomSquare(50), normals = points;
  normals.rowwise() = RowVector3d(0, 0, 1);
  normals.row(17).setZero();
  EXPECT_REFUSED(shape::ConnectSamples(points, normals), "point 17", "remove the array Normals");
  points(3, 1) = std::nan("");
  EXPECT_REFUSED(shape::ConnectSamples(points), "the points");

  shape::ExponentialMap map(shape::ConnectSamples(RandomSquare(200)));
  shape::PatchLayoutOptions options;
  options.MendFlips = true;
  EXPECT_REFUSED(FlattenPatch(map, { 0, 0, 0 }, RowVector3d::Zero(), options), "MendFlips",
    "surface reconstruction");
}
