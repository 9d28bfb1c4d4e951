#include "Distance/HausdorffDistance.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/MultiMaterialVoxels.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// A box of 1.2 x 1 x 0.8, turned against the grid, so that its edges lie between the points of a
/// boundary that knows of no crease.
shape::Mesh TurnedBox()
{
  shape::Mesh box = shapetest::Prism({ { 0, 0 }, { 1.2, 0 }, { 1.2, 0.8 }, { 0, 0.8 } });
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  box.Points = (box.Points * turn.transpose()).eval();
  return box;
}

/// 1 high, twice as long as wide; its side turns by less than 40 degrees from edge to edge.
shape::Mesh EllipticDisk()
{
  constexpr int sides = 60;
  std::vector<Eigen::RowVector2d> outline;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * EIGEN_PI * i / sides;
    outline.emplace_back(std::cos(angle), 0.5 * std::sin(angle));
  }
  return shapetest::Prism(outline);
}

constexpr double CellSize = 0.12;

shape::HexFit Fit(const shape::Surface& box)
{
  shape::MultiMaterialVoxels cubes(box, {});
  constexpr double noCrease = 180.0;
  return shape::FitHexahedra(cubes.Fill(CellSize, shape::GridDensity()).value().Solid, box,
    shape::FindFeatures(box, noCrease, 0.0));
}

double DistanceOf(const shape::HexFit& fit, const shape::Surface& surface)
{
  return shape::ComputeHausdorffDistance(
    surface, { fit.Solid.Points, shape::SplitQuads(fit.Quads) })
    .Larger();
}

} // namespace

TEST(Snapping, CutOffEdgesAreReachedAndNoHexahedronFallsBelowTheFloor)
{
  const shape::Surface box = TurnedBox();
  shape::HexFit fit = Fit(box);
  const double before = fit.Distance, minimum = fit.MinimumScaledJacobian;
  ASSERT_GT(minimum, 0.0);
  shape::SnappingOptions options;
  options.WantedDistance = 0.1 * CellSize;
  ASSERT_GT(before, 2.0 * options.WantedDistance);
  shape::SnapToSurface(fit, box, options);
  EXPECT_LT(fit.Distance, 0.7 * before);
  EXPECT_GE(fit.MinimumScaledJacobian, std::min(minimum, options.ScaledJacobians.back()));
  EXPECT_EQ(fit.MinimumScaledJacobian, shape::ComputeScaledJacobians(fit.Solid).minCoeff());
  EXPECT_EQ(fit.Distance, DistanceOf(fit, box));
  Eigen::MatrixXd boundary(fit.Quads.size(), 3);
  for (Eigen::Index i = 0; i < fit.Quads.size(); ++i)
  {
    boundary.row(i) = fit.Solid.Points.row(fit.Quads.data()[i]);
  }
  EXPECT_LT(shape::SurfaceLocator(box).Find(boundary).Distances.maxCoeff(), 1e-12);
}

TEST(Snapping, WhatIsNearEnoughStaysAsItIs)
{
  const shape::Surface box = TurnedBox();
  shape::HexFit fit = Fit(box);
  const Eigen::MatrixXd before = fit.Solid.Points;
  shape::SnappingOptions options;
  options.WantedDistance = fit.Distance;
  shape::SnapToSurface(fit, box, options);
  EXPECT_EQ(fit.Solid.Points, before);
}

TEST(Snapping, AFloorThatCannotBeKeptUndoesAll)
{
  const shape::Surface box = TurnedBox();
  shape::HexFit fit = Fit(box);
  const double minimum = fit.MinimumScaledJacobian;
  shape::SnappingOptions options;
  options.WantedDistance = 0.1 * CellSize;
  options.ScaledJacobians = { 0.99 * minimum, 0.99 * minimum };
  shape::SnapToSurface(fit, box, options);
  EXPECT_GE(fit.MinimumScaledJacobian, 0.99 * minimum);
  EXPECT_EQ(fit.Inverted, 0);
}

TEST(Snapping, PointsOnCreasesStay)
{
  const shape::Surface disk = EllipticDisk();
  shape::MultiMaterialVoxels cubes(disk, {});
  constexpr double sharp = 40.0;
  shape::HexFit fit = shape::FitHexahedra(cubes.Fill(0.2, shape::GridDensity()).value().Solid, disk,
    shape::FindFeatures(disk, sharp, 0.0));
  ASSERT_TRUE(fit.CreasesKept);
  const Eigen::MatrixXd before = fit.Solid.Points;
  shape::SnappingOptions options;
  options.WantedDistance = 0.3 * fit.Distance;
  shape::SnapToSurface(fit, disk, options);
  EXPECT_NE(fit.Solid.Points, before);
  int onCreases = 0;
  for (Eigen::Index point = 0; point < before.rows(); ++point)
  {
    if (fit.Constraint->Freedom(static_cast<int>(point)) == 1)
    {
      ++onCreases;
      EXPECT_EQ(fit.Solid.Points.row(point), before.row(point));
    }
  }
  EXPECT_GT(onCreases, 0);
}
