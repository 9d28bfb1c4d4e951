#include "Base/Errors.h"
#include "Distortion/SimplexElements.h"
#include "Geometry/Orientation.h"
#include "Parameterize/ConformalFlattening.h"
#include "Parameterize/FreeBoundaryMap.h"
#include "Quality/ConformalDistortion.h"
#include "Support/FlatMaps.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

/// The part of the unit sphere within `angle` of the north pole.
shape::Mesh Cap(int rings, double angle)
{
  shape::Mesh mesh = shapetest::FlatDisk(rings);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = mesh.Points.row(i);
    const double polar = angle * p.norm();
    mesh.Points.row(i) =
      p.norm() > 0.0 ? Eigen::RowVector3d(std::sin(polar) * p / p.norm()) : Eigen::RowVector3d(p);
    mesh.Points(i, 2) = std::cos(polar);
  }
  return mesh;
}

double Area(const shape::Mesh& mesh)
{
  return 0.5 * shape::ComputeAreaVectors(mesh).rowwise().norm().sum();
}

/// The mesh without the triangles at a point.
shape::Mesh WithoutFan(const shape::Mesh& mesh, int point)
{
  shape::Mesh open = mesh;
  int kept = 0;
  for (const auto& corners : mesh.Triangles.rowwise())
  {
    if ((corners.array() != point).all())
    {
      open.Triangles.row(kept++) = corners;
    }
  }
  open.Triangles.conservativeResize(kept, 3);
  open.Points.row(point) = open.Points.row(open.Points.rows() - 1);
  const int last = static_cast<int>(open.Points.rows()) - 1;
  open.Triangles = open.Triangles.unaryExpr([&](int i) { return i == last ? point : i; }).eval();
  open.Points.conservativeResize(last, 3);
  return open;
}

} // namespace

TEST(ConformalFlattening, OfASphericalCapIsTheStereographicProjection)
{
  // Conformal, and by symmetry the rim becomes a circle of the rim's own length: the map is
  // tan(polar / 2) / tan(angle / 2) sin(angle) in polar coordinates. The error falls with h^2.
  const double angle = 1.2;
  double before = 1.0;
  for (const int rings : { 6, 12, 24 })
  {
    const shape::Mesh cap = Cap(rings, angle);
    const Eigen::MatrixXd image = shape::FlattenConformally(cap);
    const Eigen::RowVector2d middle = image.row(0);
    double worst = 0.0;
    for (Eigen::Index i = 0; i < cap.Points.rows(); ++i)
    {
      const double polar = std::acos(std::min(1.0, cap.Points(i, 2)));
      const double radius = std::sin(angle) * std::tan(0.5 * polar) / std::tan(0.5 * angle);
      worst = std::max(worst, std::abs((image.row(i) - middle).norm() - radius));
    }
    EXPECT_LT(worst, 0.35 * before) << rings;
    before = worst;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(ConformalFlattening, DevelopableSurfacesAreUnrolled)
{
  // A square rolled to three quarters of a cylinder: flat inside, so every edge keeps its length.
  shape::Mesh roll = shapetest::FlatSquare(12, 0.0);
  for (Eigen::Index i = 0; i < roll.Points.rows(); ++i)
  {
    const double x = roll.Points(i, 0);
    roll.Points(i, 0) = std::cos(2.3 * x) / 2.3;
    roll.Points(i, 2) = std::sin(2.3 * x) / 2.3;
  }
  roll.Triangles = roll.Triangles.rowwise().reverse().eval();
  const Eigen::MatrixXd image = shape::FlattenConformally(roll);
  for (const auto& corners : roll.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners(k), b = corners((k + 1) % 3);
      EXPECT_NEAR((image.row(a) - image.row(b)).norm(),
        (roll.Points.row(a) - roll.Points.row(b)).norm(), 1e-9);
    }
  }
}

TEST(FreeBoundaryMap, KeepsAnglesBetterThanTheDiskAndAreaExactly)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(20, 0.3);
  const shape::FreeBoundaryMapResult map = shape::MapWithFreeBoundary(mesh);
  EXPECT_TRUE(map.IsConformal);
  EXPECT_EQ(map.Iterations, 0);
  EXPECT_EQ(shapetest::CountFlips(mesh.Triangles, map.Points), 0);
  EXPECT_LT(shapetest::MeanDistortion(mesh, map.Points), 1.02);
  EXPECT_NEAR(Area({ map.Points, mesh.Triangles }) / Area(mesh), 1.0, 1e-12);
  EXPECT_EQ(map.Points.col(2).cwiseAbs().maxCoeff(), 0.0);
  const Eigen::VectorXd weights = shape::ComputePointAreas({ map.Points, mesh.Triangles });
  EXPECT_LT((weights.transpose() * map.Points).norm(), 1e-12);
  // x is the longer principal axis.
  const Eigen::Matrix2d moments =
    map.Points.leftCols(2).transpose() * weights.asDiagonal() * map.Points.leftCols(2);
  EXPECT_NEAR(moments(0, 1), 0.0, 1e-12 * moments.trace());
  EXPECT_GT(moments(0, 0), moments(1, 1));
}

TEST(FreeBoundaryMap, DoesNotDependOnWhereTheSurfaceLies)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(9, 0.3);
  shape::Mesh moved = mesh;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  moved.Points = 3.0 * mesh.Points * turn.transpose();
  moved.Points.rowwise() += Eigen::RowVector3d(5.0, -7.0, 2.0);
  for (const bool refine : { false, true })
  {
    shape::FreeBoundaryMapOptions options;
    options.Refine = refine;
    const Eigen::MatrixXd one = shape::MapWithFreeBoundary(mesh, options).Points;
    const Eigen::MatrixXd other = shape::MapWithFreeBoundary(moved, options).Points;
    EXPECT_LT((other - 3.0 * one).cwiseAbs().maxCoeff(), 1e-6) << refine;
  }
}

TEST(FreeBoundaryMap, RefineLowersTheDistortionAndFlipsNothingWhereTheConformalMapDoes)
{
  // Most of a sphere, with coarse triangles: the conformal image of the far side is tiny.
  const shape::Mesh cap = Cap(8, 2.9);
  shape::FreeBoundaryMapOptions options;
  options.Refine = true;
  const shape::FreeBoundaryMapResult map = shape::MapWithFreeBoundary(cap, options);
  EXPECT_EQ(shapetest::CountFlips(cap.Triangles, map.Points), 0);
  EXPECT_GT(map.Iterations, 0);
  // At its own size: larger or smaller is worse.
  const shape::SimplexElements<2> elements = shape::BuildTriangleElements(cap, 1.0);
  const Eigen::MatrixXd image = map.Points.leftCols(2);
  const double energy = elements.Energy(image, shape::Distortion::SymmetricDirichlet, 1.0);
  for (const double scale : { 0.98, 1.02 })
  {
    EXPECT_LT(energy, elements.Energy(scale * image, shape::Distortion::SymmetricDirichlet, 1.0));
  }
}

TEST(FreeBoundaryMap, FlipsAreAnErrorThatNamesTheRemedyAndRefineMendsThem)
{
  shape::Mesh mesh = shapetest::BumpyDisk(10, 0.3);
  mesh.Points.col(2) *= 12.0;
  EXPECT_UNSOLVED(shape::MapWithFreeBoundary(mesh), "the conformal map flips ",
    "set Refine to SymmetricDirichlet");
  shape::FreeBoundaryMapOptions options;
  options.Refine = true;
  const shape::FreeBoundaryMapResult map = shape::MapWithFreeBoundary(mesh, options);
  EXPECT_FALSE(map.IsConformal);
  EXPECT_EQ(shapetest::CountFlips(mesh.Triangles, map.Points), 0);
}

TEST(FreeBoundaryMap, HolesStayHolesAndOtherTopologiesAreRefused)
{
  const shape::Mesh mesh = shapetest::BumpyDisk(8, 0.3);
  const shape::Mesh holed = WithoutFan(mesh, 40);
  for (const bool refine : { false, true })
  {
    shape::FreeBoundaryMapOptions options;
    options.Refine = refine;
    const shape::FreeBoundaryMapResult map = shape::MapWithFreeBoundary(holed, options);
    EXPECT_EQ(shapetest::CountFlips(holed.Triangles, map.Points), 0);
    EXPECT_LT(shapetest::MeanDistortion(holed, map.Points), 1.1);
  }
  EXPECT_REFUSED(
    shape::MapWithFreeBoundary(shapetest::Icosphere(2)), "the surface is closed; cut it");
  EXPECT_REFUSED(
    shape::MapWithFreeBoundary(WithoutFan(shapetest::Torus(1.0, 0.3, 12, 8), 5)), "(genus 1)");
}
