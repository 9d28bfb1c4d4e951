// Facts checked: the mean tilt is the angle to the rim's plane, whatever leans as much inwards as
// outwards; the cap over a circle of a sphere is that sphere, by stereographic projection from its
// pole; what a rim differs is spread by the harmonics of the disk; it goes through any rim, turns
// over with the normals, and moves and scales with the rim.

#include "Fill/Private/FairPatch.h"

#include "Support/DeformShapes.h"
#include "Support/HoleShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace
{

using shapetest::Degree;

/// A circle of the unit sphere at an angle from its pole, and the sphere's normals there. Its
/// points are denser on one side where `uneven` is not 0.
shape::BoundaryLoop CircleOfSphere(int points, double angle, double uneven = 0.0)
{
  shape::BoundaryLoop loop;
  loop.Points.resize(points, 3);
  for (int i = 0; i < points; ++i)
  {
    const double even = 2.0 * M_PI * i / points, along = even + uneven * std::sin(even);
    loop.Points.row(i) << std::sin(angle) * std::cos(along), std::sin(angle) * std::sin(along),
      std::cos(angle);
  }
  loop.Normals = loop.Points;
  return loop;
}

shape::HolePatch PatchOf(const shape::BoundaryLoop& loop)
{
  shape::PatchSizes sizes;
  sizes.Loop = shape::ComputeBoundarySizes(loop.Points);
  return shape::BuildMembranePatch(loop.Points, sizes);
}

/// A circle pulled out of its plane and out of round, as are its normals.
shape::BoundaryLoop Wavy(int points, double angle)
{
  shape::BoundaryLoop loop = CircleOfSphere(points, angle);
  for (int i = 0; i < points; ++i)
  {
    const double along = 2.0 * M_PI * i / points;
    loop.Points.row(i).head<2>() *= 1.0 + 0.2 * std::cos(2.0 * along);
    loop.Points(i, 2) += 0.15 * std::sin(3.0 * along);
  }
  return loop;
}

shape::BoundaryLoop Moved(const shape::BoundaryLoop& loop, const Eigen::Matrix3d& turn,
  double scale, const Eigen::RowVector3d& shift)
{
  return { shapetest::Moved(loop.Points, turn, scale, shift), loop.Normals * turn.transpose() };
}

TEST(SphericalCap, TheMeanTilt)
{
  for (const double tilt : { -170.0, -60.0, 0.0, 30.0, 90.0, 140.0 })
  {
    shape::BoundaryLoop loop = CircleOfSphere(40, 1.0);
    for (Eigen::Index i = 0; i < 40; ++i)
    {
      // As much outwards as inwards, in the mean; along the rim it is no tilt.
      const Eigen::RowVector3d outwards(loop.Points(i, 0), loop.Points(i, 1), 0.0);
      const double own = tilt * Degree + 0.15 * (i % 2 == 0 ? 1.0 : -1.0);
      const Eigen::RowVector3d normal = std::cos(own) * Eigen::RowVector3d::UnitZ() +
        std::sin(own) * outwards.normalized() +
        0.1 * i / 40.0 * Eigen::RowVector3d::UnitZ().cross(outwards);
      loop.Normals.row(i) = normal.normalized();
    }
    EXPECT_NEAR(shape::ComputeMeanTilt(loop), tilt * Degree, 1e-14);
    const shape::BoundaryLoop moved = Moved(loop, shapetest::SomeRotation(), 1e-3, { 4, -1, 2 });
    EXPECT_NEAR(shape::ComputeMeanTilt(moved), tilt * Degree, 1e-11);
    // The other way around, the surface is on its other side.
    const shape::BoundaryLoop other{ loop.Points.colwise().reverse(),
      -loop.Normals.colwise().reverse() };
    EXPECT_NEAR(shape::ComputeMeanTilt(other), -tilt * Degree, 1e-14);
  }
}

TEST(SphericalCap, OverACircleOfASphereIsTheSphere)
{
  for (const double angle : { 0.2, 45.0, 90.0, 120.0, 145.0 })
  {
    const shape::BoundaryLoop loop = CircleOfSphere(48, angle * Degree);
    const shape::HolePatch patch = PatchOf(loop);
    const Eigen::MatrixXd cap = shape::BuildSphericalCap(patch, loop);
    ASSERT_EQ(cap.rows(), patch.Flat.rows());
    EXPECT_LT((cap.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-10) << angle;
    EXPECT_LT(shapetest::Largest(cap.topRows(48) - loop.Points), 1e-13);
    // Tangents of half the angles from the pole are the distances from the layout's middle.
    const double radius = patch.Flat.topRows(48).rowwise().norm().mean();
    double wrong = 0.0;
    for (Eigen::Index i = 0; i < cap.rows(); ++i)
    {
      const Eigen::RowVector2d image = cap.row(i).head<2>() / (1.0 + cap(i, 2));
      const Eigen::RowVector2d flat = std::tan(0.5 * angle * Degree) / radius * patch.Flat.row(i);
      wrong = std::max(wrong, (image - flat).norm() / std::tan(0.5 * angle * Degree));
    }
    EXPECT_LT(wrong, 1e-9) << angle;
  }
}

TEST(SphericalCap, HoweverTheRimIsSpaced)
{
  for (const double uneven : { 0.2, 0.5, 0.8 })
  {
    const shape::BoundaryLoop loop = CircleOfSphere(60, 1.2, uneven);
    const Eigen::MatrixXd cap = shape::BuildSphericalCap(PatchOf(loop), loop);
    EXPECT_LT((cap.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-3) << uneven;
  }
}

TEST(SphericalCap, ThroughAnyRimAndMovedWithIt)
{
  const shape::BoundaryLoop loop = Wavy(60, 80.0 * Degree);
  const shape::HolePatch patch = PatchOf(loop);
  const Eigen::MatrixXd cap = shape::BuildSphericalCap(patch, loop);
  EXPECT_LT(shapetest::Largest(cap.topRows(60) - loop.Points), 1e-14);
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const Eigen::RowVector3d shift(20, -7, 3);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    // The layout of the patch may have any size.
    shape::HolePatch same = patch;
    same.Flat *= 3.0;
    const Eigen::MatrixXd moved =
      shape::BuildSphericalCap(same, Moved(loop, turn, scale, scale * shift));
    EXPECT_LT(
      shapetest::Largest(moved - shapetest::Moved(cap, turn, scale, scale * shift)), 1e-11 * scale);
  }
  // Normals mirrored in the plane of the rim's middle: so is the cap.
  const Eigen::RowVector3d mirror(1, 1, -1);
  const shape::BoundaryLoop below{ loop.Points * mirror.asDiagonal(),
    loop.Normals * Eigen::RowVector3d(-1, -1, 1).asDiagonal() };
  EXPECT_NEAR(shape::ComputeMeanTilt(below), -shape::ComputeMeanTilt(loop), 1e-14);
  EXPECT_LT(
    shapetest::Largest(shape::BuildSphericalCap(patch, below) - cap * mirror.asDiagonal()), 1e-12);
}

TEST(SphericalCap, AWaveOfTheRimGoesInAsHarmonicsOfTheDisk)
{
  // The sphere is a conformal image of the layout: what is harmonic on one is on the other.
  const shape::BoundaryLoop loop = CircleOfSphere(96, 70.0 * Degree);
  const shape::HolePatch patch = PatchOf(loop);
  const Eigen::MatrixXd cap = shape::BuildSphericalCap(patch, loop);
  const double radius = patch.Flat.topRows(96).rowwise().norm().mean();
  for (const int waves : { 2, 3, 4 })
  {
    shape::BoundaryLoop wavy = loop;
    for (int i = 0; i < 96; ++i)
    {
      wavy.Points(i, 2) += 0.1 * std::cos(2.0 * M_PI * waves * i / 96);
    }
    const Eigen::MatrixXd bent = shape::BuildSphericalCap(patch, wavy);
    for (Eigen::Index i = 0; i < bent.rows(); ++i)
    {
      const std::complex<double> position(patch.Flat(i, 0) / radius, patch.Flat(i, 1) / radius);
      const double height = 0.1 * std::pow(position, waves).real();
      EXPECT_LT((bent.row(i) - cap.row(i) - Eigen::RowVector3d(0, 0, height)).norm(), 2e-3);
    }
  }
}

TEST(SphericalCap, FlatWithoutTiltAndNoSteeperThanItMayBe)
{
  shape::BoundaryLoop loop = CircleOfSphere(48, 90.0 * Degree);
  const shape::HolePatch patch = PatchOf(loop);
  const auto capOf = [&](double tilt)
  {
    loop.Normals = loop.Points * std::sin(tilt * Degree);
    loop.Normals.col(2).setConstant(std::cos(tilt * Degree));
    return shape::BuildSphericalCap(patch, loop);
  };
  EXPECT_LT(capOf(0.0).col(2).cwiseAbs().maxCoeff(), 1e-3);
  // The sphere that leaves the unit circle by 150 degrees.
  const Eigen::RowVector3d middle(0, 0, std::sqrt(3.0));
  for (const double tilt : { 150.0, 151.0, 175.0 })
  {
    EXPECT_LT(
      ((capOf(tilt).rowwise() - middle).rowwise().norm().array() - 2.0).abs().maxCoeff(), 1e-12)
      << tilt;
    EXPECT_LT(
      ((capOf(-tilt).rowwise() + middle).rowwise().norm().array() - 2.0).abs().maxCoeff(), 1e-12)
      << tilt;
  }
  EXPECT_LT(capOf(149.0).col(2).maxCoeff(), capOf(150.0).col(2).maxCoeff());
}

} // namespace
