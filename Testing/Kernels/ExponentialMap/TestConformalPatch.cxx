// Facts checked: what can be laid out without distortion is, a plane as by the exponential map and
// a tube cut open where it meets itself; a spherical cap becomes its stereographic image, as far
// from the seed in the mean as along the surface and turned as the exponential map; it turns with
// the x axis and follows similarities of the surface; the refined layout flips no triangle; what
// has no area is refused.

#include "ExponentialMap/ConformalPatch.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3d;

shape::ExponentialPatch PatchOf(const shape::Mesh& surface, const RowVector3d& seed, double radius,
  const RowVector3d& xAxis = RowVector3d(1, 0, 0))
{
  return shape::ExponentialMap(surface).Around(seed, radius, xAxis);
}

/// The image of a patch.
shape::Mesh ImageOf(const shape::ExponentialPatch& patch)
{
  shape::Mesh image{ MatrixXd::Zero(patch.Positions.rows(), 3), patch.Corners };
  image.Points.leftCols(2) = patch.Positions;
  return image;
}

/// That a layout is a disk of the surface's triangles.
void ExpectDisk(const shape::Mesh& surface, const shape::ExponentialPatch& layout)
{
  const shape::Topology topology = shape::RequireManifold(ImageOf(layout), "the layout");
  EXPECT_EQ(topology.EulerNumber, 1);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  ASSERT_EQ(static_cast<Eigen::Index>(layout.Triangles.size()), layout.Corners.rows());
  ASSERT_EQ(static_cast<Eigen::Index>(layout.Points.size()), layout.Positions.rows());
  for (Eigen::Index row = 0; row < layout.Corners.rows(); ++row)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(layout.Points[layout.Corners(row, k)], surface.Triangles(layout.Triangles[row], k));
    }
  }
}

/// The largest difference between the lengths of edges in the plane and on the surface.
double Stretch(const shape::Mesh& surface, const shape::ExponentialPatch& layout)
{
  double largest = 0.0;
  const shape::Mesh image = ImageOf(layout);
  for (Eigen::Index row = 0; row < layout.Corners.rows(); ++row)
  {
    const Eigen::Matrix3d flat = shape::GetCorners(image, row);
    const Eigen::Matrix3d bent = shape::GetCorners(surface, layout.Triangles[row]);
    for (int k = 0; k < 3; ++k)
    {
      largest = std::max(largest,
        std::abs((flat.row(k) - flat.row((k + 1) % 3)).norm() -
          (bent.row(k) - bent.row((k + 1) % 3)).norm()));
    }
  }
  return largest;
}

TEST(ConformalPatch, WhatCanBeLaidOutWithoutDistortionIs)
{
  shape::Mesh plane = shapetest::FlatSquare(20, 0.3);
  plane.Points = shapetest::Moved(plane.Points, shapetest::SomeRotation(), 1.0, { 3, -7, 2 });
  const shape::ExponentialPatch patch = PatchOf(plane, plane.Points.row(213), 0.45);
  const shape::Mesh tube = shapetest::Tube(24, 40, 10.0);
  const shape::ExponentialPatch around = PatchOf(tube, RowVector3d(1, 0, 5), 4.2, { 0, 1, 0 });
  EXPECT_NE(shape::ComputeTopology(ImageOf(around)).EulerNumber, 1);
  for (const bool refine : { false, true })
  {
    const shape::ExponentialPatch flat = shape::FlattenPatchConformally(plane, patch, refine);
    ExpectDisk(plane, flat);
    ASSERT_EQ(flat.Points, patch.Points);
    EXPECT_LT((flat.Positions - patch.Positions).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_EQ(flat.Distances, patch.Distances);
    // A tube meets itself behind the seed: unrolled, it is open there.
    const shape::ExponentialPatch open = shape::FlattenPatchConformally(tube, around, refine);
    ExpectDisk(tube, open);
    EXPECT_LT(open.Triangles.size(), around.Triangles.size());
    EXPECT_GT(open.Triangles.size(), around.Triangles.size() * 9 / 10);
    EXPECT_LT(Stretch(tube, open), 0.03);
  }
}

TEST(ConformalPatch, ASphericalCapBecomesItsStereographicImage)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const RowVector3d seed = RowVector3d(0.3, -0.2, 0.9).normalized();
  const shape::ExponentialPatch patch = PatchOf(sphere, seed, 1.2);
  const shape::ExponentialPatch flat = shape::FlattenPatchConformally(sphere, patch, false);
  ExpectDisk(sphere, flat);
  EXPECT_NEAR(
    flat.Positions.rowwise().norm().sum(), flat.Distances.sum(), 1e-12 * flat.Distances.sum());
  double scale = 0.0;
  for (Eigen::Index i = 0; i < flat.Positions.rows(); ++i)
  {
    const double angle = std::acos(sphere.Points.row(flat.Points[i]).dot(seed));
    const double expected = 2.0 * std::tan(angle / 2.0);
    scale += expected / static_cast<double>(flat.Positions.rows());
  }
  scale = flat.Positions.rowwise().norm().mean() / scale;
  for (Eigen::Index i = 0; i < flat.Positions.rows(); ++i)
  {
    const RowVector3d position = sphere.Points.row(flat.Points[i]);
    const double angle = std::acos(position.dot(seed));
    const Eigen::RowVector2d direction(
      position.dot(patch.Seed.XAxis), position.dot(patch.Seed.YAxis));
    EXPECT_LT(
      (flat.Positions.row(i) - 2.0 * scale * std::tan(angle / 2.0) * direction.normalized()).norm(),
      0.02);
  }
}

TEST(ConformalPatch, FollowsTheFrameAndSimilarities)
{
  const shape::Mesh cap = shapetest::Cap(10);
  const RowVector3d seed = cap.Points.row(20), axis(1, 0, 0);
  const shape::ExponentialPatch patch = PatchOf(cap, seed, 0.4, axis);
  const MatrixXd positions = shape::FlattenPatchConformally(cap, patch, false).Positions;
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const RowVector3d shift(3e-3, -7e-3, 2e-3);
  const shape::Mesh small{ shapetest::Moved(cap.Points, turn, 1e-3, shift), cap.Triangles };
  const shape::ExponentialPatch moved =
    PatchOf(small, shapetest::Moved(seed, turn, 1e-3, shift), 4e-4, axis * turn.transpose());
  const shape::ExponentialPatch other = shape::FlattenPatchConformally(small, moved, false);
  ASSERT_EQ(moved.Points, patch.Points);
  EXPECT_LT((1e3 * other.Positions - positions).cwiseAbs().maxCoeff(), 1e-9);
  // The frame turned to the left, what is seen in it turns to the right.
  const double angle = 0.7;
  const RowVector3d left = std::cos(angle) * patch.Seed.XAxis + std::sin(angle) * patch.Seed.YAxis;
  const MatrixXd turned =
    shape::FlattenPatchConformally(cap, PatchOf(cap, seed, 0.4, left), false).Positions;
  EXPECT_LT((turned * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose() - positions)
              .cwiseAbs()
              .maxCoeff(),
    1e-9);
}

TEST(ConformalPatch, RefinedNoTriangleIsFlippedElseItIsSaid)
{
  // A finger on a plane: behind it the exponential map folds.
  shape::Mesh finger = shapetest::FlatSquare(40, 0.2);
  for (auto point : finger.Points.rowwise())
  {
    point(2) = 3.0 * std::exp(-point.squaredNorm() / 0.04);
  }
  const shape::ExponentialPatch patch = PatchOf(finger, { -0.2, 0.0, 0.0 }, 1.4);
  EXPECT_LT(shape::ComputeAreaVectors(ImageOf(patch)).col(2).minCoeff(), 0.0);
  const shape::ExponentialPatch flat = shape::FlattenPatchConformally(finger, patch, true);
  ExpectDisk(finger, flat);
  EXPECT_GT(shape::ComputeAreaVectors(ImageOf(flat)).col(2).minCoeff(), 0.0);
  EXPECT_TRUE(flat.Flipped.empty());
  EXPECT_EQ(flat.Triangles.front(), patch.Triangles.front()); // it grows from the seed
  // The quick way folds it, and says where.
  const shape::ExponentialPatch quick = shape::FlattenPatchConformally(finger, patch, false);
  const Eigen::VectorXd areas = shape::ComputeAreaVectors(ImageOf(quick)).col(2);
  ASSERT_FALSE(quick.Flipped.empty());
  for (int row = 0; row < areas.size(); ++row)
  {
    EXPECT_EQ(std::count(quick.Flipped.begin(), quick.Flipped.end(), row), areas(row) > 0.0 ? 0 : 1)
      << row;
  }
}

TEST(ConformalPatch, RefusesWhatHasNoArea)
{
  shape::Mesh line{ MatrixXd::Zero(5, 3), Eigen::MatrixXi(3, 3) };
  line.Points.col(0) << 0, 1, 2, 3, 4;
  line.Triangles << 0, 1, 2, 1, 3, 2, 2, 3, 4;
  const shape::ExponentialPatch patch = PatchOf(line, { 0.5, 0.0, 0.0 }, 9.0);
  ASSERT_EQ(patch.Triangles.size(), 3U);
  shape::Mesh point = line;
  point.Points.setOnes();
  const shape::ExponentialPatch one = PatchOf(point, { 1, 1, 1 }, 9.0);
  ASSERT_EQ(one.Triangles.size(), 3U);
  for (const bool refine : { false, true })
  {
    EXPECT_THROW(shape::FlattenPatchConformally(line, patch, refine), shape::InvalidInput);
    EXPECT_THROW(shape::FlattenPatchConformally(point, one, refine), shape::InvalidInput);
  }
  const shape::Mesh disk = shapetest::FlatDisk(5);
  EXPECT_THROW(shape::FlattenPatchConformally(disk, PatchOf(disk, { 0, 0, 0 }, 0.8), false,
                 shape::Progress([](double) { return false; })),
    shape::Aborted);
}

} // namespace
