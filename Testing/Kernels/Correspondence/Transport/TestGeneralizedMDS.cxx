#include "Base/Errors.h"
#include "Correspondence/Transport/GeneralizedMDS.h"
#include "Correspondence/Transport/GromovHausdorff.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace
{

shape::GromovHausdorffResult Compare(
  const shape::Surface& a, const shape::Surface& b, int samples, int starts = 8)
{
  shape::GeneralizedMDSOptions options;
  options.Samples = samples;
  options.Starts = starts;
  const shape::GeneralizedMDSResult found = shape::ComputeGeneralizedMDS(a, b, {}, options);
  const auto result = shape::MeasureGromovHausdorff(a, b, found.Maps);
  EXPECT_LE(result.Lower, result.Upper + 1e-12);
  EXPECT_NEAR(result.Upper, 0.5 * result.Maximum, 1e-15);
  EXPECT_LE(result.RootMeanSquare, result.Maximum);
  return result;
}

/// A strip of length x width, flat or rolled up with this curvature along its length.
shape::Mesh Strip(double length, double width, int along, int across, double curvature)
{
  shape::Mesh mesh{ Eigen::MatrixXd((along + 1) * (across + 1), 3),
    Eigen::MatrixXi(2 * along * across, 3) };
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j <= across; ++j)
    {
      const double u = length * i / along, v = width * j / across;
      mesh.Points.row(i * (across + 1) + j) = curvature > 0.0
        ? Eigen::RowVector3d(
            std::sin(curvature * u) / curvature, v, (1.0 - std::cos(curvature * u)) / curvature)
        : Eigen::RowVector3d(u, v, 0.0);
    }
  }
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const int p = i * (across + 1) + j, q = p + across + 1;
      mesh.Triangles.row(2 * (i * across + j)) << p, q, q + 1;
      mesh.Triangles.row(2 * (i * across + j) + 1) << p, q + 1, p + 1;
    }
  }
  return mesh;
}

Eigen::MatrixXd DistancesOf(const Eigen::MatrixXd& positions)
{
  Eigen::MatrixXd distances(positions.rows(), positions.rows());
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    distances.col(i) = (positions.rowwise() - positions.row(i)).rowwise().norm();
  }
  return distances;
}

} // namespace

TEST(GromovHausdorff, LowerBoundIsExactForTwoPointsAndOne)
{
  Eigen::MatrixXd two(2, 2), other(2, 2);
  two << 0, 3, 3, 0;
  other << 0, 5, 5, 0;
  EXPECT_DOUBLE_EQ(shape::BoundGromovHausdorff(two, other), 1.0);
  EXPECT_DOUBLE_EQ(shape::BoundGromovHausdorff(two, Eigen::MatrixXd::Zero(1, 1)), 1.5);
}

TEST(GromovHausdorff, LowerBoundIsBelowEveryMapAndAboveTheDiameters)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto draw = [&](double size)
  {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(
      6, 3, [&](Eigen::Index, Eigen::Index) { return size * uniform(random); }));
  };
  for (int trial = 0; trial < 20; ++trial)
  {
    const Eigen::MatrixXd a = DistancesOf(draw(1.0)), b = DistancesOf(draw(1.5));
    std::vector<int> order(6);
    std::iota(order.begin(), order.end(), 0);
    double least = 10.0;
    do
    {
      least = std::min(least, 0.5 * (a - b(order, order)).cwiseAbs().maxCoeff());
    } while (std::next_permutation(order.begin(), order.end()));
    const double bound = shape::BoundGromovHausdorff(a, b);
    EXPECT_LE(bound, least + 1e-15);
    EXPECT_GE(bound, 0.5 * std::abs(a.maxCoeff() - b.maxCoeff()) - 1e-15);
    // The other way round, and in another order.
    EXPECT_DOUBLE_EQ(bound, shape::BoundGromovHausdorff(b(order, order), a));
  }
}

TEST(GromovHausdorff, OfSpheresIsHalfTheDifferenceOfTheirDiameters)
{
  const double truth = 0.5 * 0.1 * M_PI;
  double before = 1.0;
  for (const int level : { 1, 2, 3 })
  {
    const auto found = Compare(shapetest::Sphere(level, 1.0), shapetest::Sphere(level, 1.1), 24, 2);
    const double error =
      std::max(std::abs(found.Upper - truth), std::abs(found.Lower - truth)) / truth;
    EXPECT_LT(error, 0.7 * before);
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

TEST(GromovHausdorff, OfABentStripIsZero)
{
  const double diameter = std::hypot(6.0, 1.0);
  double before = 1.0;
  for (const int finer : { 1, 2 })
  {
    // Triangles of another size, so that no point has its like.
    const auto found = Compare(
      Strip(6.0, 1.0, 22 * finer, 4 * finer, 0.0), Strip(6.0, 1.0, 27 * finer, 3 * finer, 0.7), 24);
    const double error = found.Upper / diameter;
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

TEST(GromovHausdorff, OfStripsOfTwoLengthsIsHalfTheDifference)
{
  // Stretching one into the other changes no distance by more than 1, and the diameters differ by
  // sqrt(7^2 + w^2) - sqrt(6^2 + w^2).
  const double truth = 0.5, width = 0.25;
  const double least = 0.5 * (std::hypot(7.0, width) - std::hypot(6.0, width));
  ASSERT_GT(least, 0.998 * truth);
  const auto found = Compare(Strip(6.0, width, 60, 2, 0.0), Strip(7.0, width, 66, 3, 0.0), 24);
  EXPECT_NEAR(found.Upper, truth, 0.01 * truth);
  EXPECT_NEAR(found.Lower, truth, 0.01 * truth);
}

TEST(GeneralizedMDS, FindsTheSameSurfaceInOtherTriangles)
{
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  shape::Mesh b = shapetest::BumpySphere(3, shapetest::Rotation(0.7, { 3, -1, 1 }));
  const Eigen::MatrixXd onA = b.Points;
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  b.Points = 3.0 * b.Points * turn.transpose();
  const Eigen::MatrixXd onB = 3.0 * a.Points * turn.transpose();
  shape::GeneralizedMDSOptions options;
  options.Samples = 60;
  const auto found = shape::ComputeGeneralizedMDS(a, b, {}, options);
  EXPECT_FALSE(found.Reversed);
  EXPECT_LT(found.Stress, 0.02);
  EXPECT_LT(shapetest::MapErrors(found.Maps.AToB, b, onB).mean(), 0.02);
  EXPECT_LT(shapetest::MapErrors(found.Maps.BToA, a, onA).mean(), 0.02);
}

// The upper and the lower face of a flat shape are alike, so exchanging them changes no distance.
// The outline has no symmetry: only that exchange is a reflection.
TEST(GeneralizedMDS, KeepsTheOrientationOfFlatShapes)
{
  const auto flat = [](const Eigen::Matrix3d& turn, double bend)
  {
    shape::Mesh mesh = shapetest::Icosphere(2);
    for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
    {
      const Eigen::RowVector3d p = mesh.Points.row(i) * turn.transpose();
      const auto lobe = [&](double x, double y)
      { return std::exp(3.0 * (p.x() * x + p.y() * y - 1.0)); };
      const double r = 1.0 + lobe(1.0, 0.0) + 0.5 * lobe(-0.6, 0.8);
      const double x = r * p.x();
      mesh.Points.row(i) << x, r * p.y(), 0.3 * p.z() + bend * x * x;
    }
    return mesh;
  };
  const auto turned = [](int k) {
    return shapetest::Rotation(0.7 + 0.9 * k, { 3.0, -1.0 + k, 1.0 });
  };
  for (int k = 0; k < 8; ++k)
  {
    const shape::Mesh a = flat(turned(k), 0.0), b = flat(turned(k + 1), 0.15);
    shape::GeneralizedMDSOptions options;
    options.Samples = 24;
    const auto found = shape::ComputeGeneralizedMDS(a, b, {}, options);
    EXPECT_FALSE(found.Reversed) << k;
    EXPECT_LT(shapetest::MapErrors(found.Maps.AToB, b, flat(turned(k), 0.15).Points).mean(), 0.1)
      << k;
  }
}

TEST(GeneralizedMDS, KeepsLandmarksAndNamesWhatIsWrong)
{
  const shape::Mesh mesh = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  const shapetest::Renumbered copy = shapetest::Renumber(mesh, 3);
  shape::GeneralizedMDSOptions options;
  options.Samples = 20;
  for (const std::vector<int>& points :
    { std::vector<int>{ 12 }, std::vector<int>{ 12, 100 }, std::vector<int>{ 12, 100, 60 } })
  {
    shape::Landmarks landmarks;
    for (const int point : points)
    {
      landmarks.push_back({ point, copy.NewOf(point) });
    }
    const auto found = shape::ComputeGeneralizedMDS(mesh, copy.Mesh, landmarks, options);
    // The same points are there, so no distance must change at all.
    EXPECT_LT(found.Stress, 1e-9);
    EXPECT_LT(shapetest::MapErrors(found.Maps.AToB, copy.Mesh, mesh.Points).maxCoeff(), 1e-6);
  }
  options.Samples = 7;
  EXPECT_REFUSED(shape::ComputeGeneralizedMDS(mesh, copy.Mesh, {}, options), "ScalingSamples");
  EXPECT_REFUSED(shape::ComputeGeneralizedMDS(mesh, shapetest::Twice(mesh), {}), "surface B");
}
