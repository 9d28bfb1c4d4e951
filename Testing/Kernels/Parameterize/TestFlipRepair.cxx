#include "Base/Errors.h"
#include "ExponentialMap/PatchLayout.h"
#include "Geometry/Orientation.h"
#include "Parameterize/FlipRepair.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

std::vector<int> Flipped(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& positions)
{
  std::vector<int> flipped;
  for (int t = 0; t < triangles.rows(); ++t)
  {
    if (shape::EvaluateOrientation(positions.row(triangles(t, 0)), positions.row(triangles(t, 1)),
          positions.row(triangles(t, 2))) <= 0)
    {
      flipped.push_back(t);
    }
  }
  return flipped;
}

/// A patch with one triangle for each row of corners, all sound.
shape::ExponentialPatch Patch(const Eigen::MatrixXd& positions, const Eigen::MatrixXi& corners)
{
  shape::ExponentialPatch patch;
  patch.Positions = positions;
  patch.Corners = corners;
  for (int row = 0; row < corners.rows(); ++row)
  {
    patch.Triangles.push_back(row);
  }
  for (int row = 0; row < positions.rows(); ++row)
  {
    patch.Points.push_back(row);
  }
  return patch;
}

} // namespace

TEST(FlipMending, PutsPointsBack)
{
  const shape::Mesh square = shapetest::FlatSquare(20, 0.2);
  const Eigen::MatrixXd flat = square.Points.leftCols(2);
  Eigen::MatrixXd positions = flat;
  // One point across its ring, and three neighbours in a heap far from it.
  positions.row(220) += RowVector2d(0.17, 0.03);
  for (const int point : { 100, 101, 121 })
  {
    positions.row(point) += RowVector2d(-0.2, 0.21);
  }
  const auto before = static_cast<int>(Flipped(square.Triangles, positions).size());
  ASSERT_GT(before, 5);
  Eigen::MatrixXd mended = positions;
  EXPECT_EQ(shape::RepairFlips(square, mended), before);
  EXPECT_TRUE(Flipped(square.Triangles, mended).empty());
  // The square itself is what its mean value combinations are.
  EXPECT_LT((mended - flat).rowwise().norm().maxCoeff(), 1e-9);
  // What was sound is not moved: far points by no bit.
  EXPECT_EQ(mended.topRows(40), positions.topRows(40));
  EXPECT_EQ(mended.bottomRows(150), positions.bottomRows(150));

  // Nothing to do: no bit changes.
  Eigen::MatrixXd sound = flat;
  EXPECT_EQ(shape::RepairFlips(square, sound), 0);
  EXPECT_EQ(sound, flat);
}

TEST(FlipMending, LeavesTheRimAndWhatIsLeftOut)
{
  const shape::Mesh square = shapetest::FlatSquare(8, 0.0);
  Eigen::MatrixXd positions = square.Points.leftCols(2);
  positions.row(4) = RowVector2d(0.0, 0.3); // in the middle of the lower side
  const std::vector<int> flipped = Flipped(square.Triangles, positions);
  ASSERT_FALSE(flipped.empty());
  Eigen::MatrixXd mended = positions;
  EXPECT_LE(shape::RepairFlips(square, mended), static_cast<int>(flipped.size()));
  EXPECT_EQ(mended.topRows(9), positions.topRows(9));
  // Triangles that do not count are neither mended nor mourned.
  positions = square.Points.leftCols(2);
  positions.row(40) += RowVector2d(0.5, 0.0);
  const std::vector<int> folded = Flipped(square.Triangles, positions);
  ASSERT_FALSE(folded.empty());
  mended = positions;
  EXPECT_EQ(shape::RepairFlips(square, mended, folded), 0);
  EXPECT_EQ(mended, positions);
}

TEST(FlipMending, MendsMostOfARoughSurface)
{
  shape::Mesh mesh = shapetest::ReadModel("bunny00");
  const double diagonal = shape::ComputeBoxDiagonal(mesh.Points);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.0012, 0.0012);
  mesh.Points = mesh.Points.unaryExpr([&](double x) { return x + diagonal * uniform(random); });
  shape::ExponentialMap map(mesh);
  shape::PatchLayoutOptions options;
  options.Radius = 0.05 * diagonal;
  double before = 0.0, after = 0.0;
  const Eigen::MatrixXd seeds = shape::SampleRandomly(mesh, 30, 1);
  for (const auto& seed : seeds.rowwise())
  {
    options.MendFlips = false;
    const shape::PatchLayout raw = FlattenPatch(map, seed, RowVector3d::Zero(), options);
    options.MendFlips = true;
    const shape::PatchLayout mended = FlattenPatch(map, seed, RowVector3d::Zero(), options);
    EXPECT_EQ(raw.Patch.Flipped.size(), mended.Patch.Flipped.size() + mended.Mended);
    EXPECT_EQ(raw.Mended, 0);
    before += static_cast<double>(raw.Patch.Flipped.size());
    after += static_cast<double>(mended.Patch.Flipped.size());
  }
  EXPECT_GT(before, 30.0);
  EXPECT_LT(after, 0.2 * before);
}

TEST(ExponentialFacts, OfAnIsometryAreThoseOfOne)
{
  const shape::Mesh square = shapetest::FlatSquare(60, 0.3);
  shape::ExponentialMap map(square);
  shape::PatchLayoutOptions options;
  options.Radius = 0.7;
  const shape::PatchLayout layout =
    FlattenPatch(map, { 0.01, 0.02, 0.5 }, RowVector3d::Zero(), options);
  EXPECT_NEAR(layout.SeedDistance, 0.5, 1e-12);
  EXPECT_EQ(layout.Facts.FlipRate, 0.0);
  EXPECT_NEAR(layout.Facts.ConformalDistortion.Median, 1.0, 1e-9);
  EXPECT_NEAR(layout.Facts.ConformalDistortion.Percentile95, 1.0, 1e-9);
  EXPECT_NEAR(layout.Facts.SymmetricDirichlet.Median, 4.0, 1e-9);
  EXPECT_NEAR(layout.Facts.SymmetricDirichlet.Percentile95, 4.0, 1e-9);
  EXPECT_FALSE(layout.Facts.Overlaps);
  // The triangles that the circle crosses are not in the patch: the rim is half an edge inside.
  EXPECT_LT(layout.Facts.Coverage, 1.0);
  EXPECT_GT(layout.Facts.Coverage, 0.92);
  // A tenth of the diagonal.
  options.Radius = 0.0;
  EXPECT_NEAR(FlattenPatch(map, { 0, 0, 0 }, RowVector3d::Zero(), options).Radius,
    0.1 * shape::ComputeBoxDiagonal(square.Points), 1e-15);
  options.Radius = -1.0;
  EXPECT_THROW(FlattenPatch(map, { 0, 0, 0 }, RowVector3d::Zero(), options), shape::InvalidInput);
  options.Radius = 0.1;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FlattenPatch(map, { 0, nan, 0 }, RowVector3d::Zero(), options), shape::InvalidInput);
  EXPECT_THROW(FlattenPatch(map, { 0, 0, 0 }, { 0, nan, 0 }, options), shape::InvalidInput);
}

TEST(ExponentialFacts, SayWherePartsLieOverOneAnother)
{
  // A strip along an arc of a ring: three quarters of a turn, then more than one.
  const auto strip = [](double turns)
  {
    constexpr int steps = 40;
    Eigen::MatrixXd positions(2 * steps + 2, 2);
    Eigen::MatrixXi corners(2 * steps, 3);
    for (int i = 0; i <= steps; ++i)
    {
      const double angle = 2.0 * M_PI * turns * i / steps;
      const RowVector2d way(std::cos(angle), std::sin(angle));
      positions.row(2 * i) = way;
      positions.row(2 * i + 1) = 1.5 * way;
      if (i < steps)
      {
        corners.row(2 * i) << 2 * i, 2 * i + 1, 2 * i + 3;
        corners.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 2;
      }
    }
    return Patch(positions, corners);
  };
  EXPECT_FALSE(IsOverlappingItself(strip(0.75)));
  EXPECT_FALSE(IsOverlappingItself(strip(0.99)));
  EXPECT_TRUE(IsOverlappingItself(strip(1.03)));
  EXPECT_TRUE(IsOverlappingItself(strip(1.5)));

  // Two triangles in a star: no corner of one is in the other.
  Eigen::MatrixXd positions(6, 2);
  positions << 0, 2, -2, -1, 2, -1, 0, -2, 2, 1, -2, 1;
  Eigen::MatrixXi corners(2, 3);
  corners << 0, 1, 2, 3, 4, 5;
  EXPECT_TRUE(IsOverlappingItself(Patch(positions, corners)));
  // Side by side, with a side in common but not its points.
  positions << 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1;
  EXPECT_FALSE(IsOverlappingItself(Patch(positions, corners)));
  EXPECT_FALSE(IsOverlappingItself(Patch(Eigen::MatrixXd(0, 2), Eigen::MatrixXi(0, 3))));
}
