// Facts checked: a polygon knows on which side places and triangles lie, exactly; what a loop
// covers is a disk that contains it, whose points outside of it all stay; a loop along edges covers
// just what is within it; and each thing that is wrong with a place is told from the others.

#include "CutPaste/CoveredRegion.h"
#include "Planar/PlanarOutline.h"
#include "Support/CurveShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace
{

using shape::CoveredRegionFault;

/// A flat surface and its image: itself.
shape::ExponentialPatch FlatPatch(const shape::Mesh& flat)
{
  shape::ExponentialPatch patch;
  patch.Positions = flat.Points.leftCols(2);
  patch.Corners = flat.Triangles;
  patch.Points.resize(flat.Points.rows());
  patch.Triangles.resize(flat.Triangles.rows());
  std::iota(patch.Points.begin(), patch.Points.end(), 0);
  std::iota(patch.Triangles.begin(), patch.Triangles.end(), 0);
  return patch;
}

Eigen::MatrixXd Circle(double x, double y, double radius, int corners)
{
  Eigen::MatrixXd circle(corners, 2);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    circle.row(i) << x + radius * std::cos(angle), y + radius * std::sin(angle);
  }
  return circle;
}

/// The square [-0.5, 0.5]^2 along the edges of FlatSquare(8, 0), a corner at each point.
Eigen::MatrixXd SquareAlongEdges()
{
  Eigen::MatrixXd square(16, 2);
  for (int i = 0; i < 4; ++i)
  {
    square.row(i) << -0.5 + 0.25 * i, -0.5;
    square.row(4 + i) << 0.5, -0.5 + 0.25 * i;
    square.row(8 + i) << 0.5 - 0.25 * i, 0.5;
    square.row(12 + i) << -0.5, 0.5 - 0.25 * i;
  }
  return square;
}

TEST(CoveredRegion, AnOutlineKnowsItsSides)
{
  const Eigen::MatrixXd corners = SquareAlongEdges();
  const shape::PlanarOutline outline(corners);
  EXPECT_EQ(outline.Side({ 0.1, 0.3 }), 1);
  EXPECT_EQ(outline.Side({ 0.0, 0.25 }), 1); // level with corners
  EXPECT_EQ(outline.Side({ -0.75, 0.25 }), -1);
  EXPECT_EQ(outline.Side({ 0.1, 0.5 }), 0);
  EXPECT_EQ(outline.Side({ 0.5, 0.5 }), 0);
  EXPECT_EQ(outline.Side({ -0.75, 0.5 }), -1);
  EXPECT_EQ(outline.Side({ 0.5 + 1e-17, 0.1 }), 0); // the same number
  EXPECT_EQ(outline.Side({ std::nextafter(0.5, 1.0), 0.1 }), -1);
  const Eigen::MatrixXd circle = Circle(0.0, 0.0, 1.0, 1000);
  const shape::PlanarOutline round(circle);
  int inside = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Eigen::RowVector2d position = Eigen::RowVector2d::Random() * 1.2;
    if (std::abs(position.norm() - 1.0) > 1e-5)
    {
      EXPECT_EQ(round.Side(position), position.norm() < 1.0 ? 1 : -1);
      inside += position.norm() < 1.0;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(CoveredRegion, AnOutlineCoversTrianglesThatShareInsides)
{
  const shape::PlanarOutline outline(SquareAlongEdges());
  Eigen::Matrix<double, 3, 2> triangle;
  triangle << 0.1, 0.1, 0.2, 0.1, 0.1, 0.2; // inside
  EXPECT_TRUE(outline.Covers(triangle));
  triangle << 0.5, 0.0, 0.75, 0.0, 0.5, 0.25; // beside, with a common side
  EXPECT_FALSE(outline.Covers(triangle));
  triangle << 0.5, 0.0, 0.5, 0.25, 0.25, 0.0; // within, with a common side
  EXPECT_TRUE(outline.Covers(triangle));
  triangle << -2.0, -2.0, 2.0, -2.0, 0.0, 3.0; // around it all
  EXPECT_TRUE(outline.Covers(triangle));
  triangle << 0.5, 0.5, 1.0, 0.5, 0.5, 1.0; // a common corner
  EXPECT_FALSE(outline.Covers(triangle));
  triangle << 0.4999, 0.1, 0.8, 0.1, 0.8, 0.2; // a tip within
  EXPECT_TRUE(outline.Covers(triangle));
}

TEST(CoveredRegion, ALoopIsContainedAndPointsOutsideStay)
{
  const shape::Mesh flat = shapetest::FlatSquare(24, 0.3);
  shape::CoveredRegionFinder finder(flat);
  for (const int corners : { 3, 7, 40, 500 })
  {
    const Eigen::MatrixXd loop = Circle(0.05, -0.1, 0.5, corners);
    const shape::CoveredRegion footprint = finder.Find(FlatPatch(flat), loop, 0.0);
    ASSERT_EQ(footprint.Fault, CoveredRegionFault::None);
    double gone = 0.0;
    std::set<int> used;
    for (const int triangle : footprint.Triangles)
    {
      const Eigen::Matrix3d at = shape::GetCorners(flat, triangle);
      Eigen::MatrixXd flatTriangle = at.leftCols(2);
      gone += shapetest::PolygonArea(flatTriangle);
      used.insert(
        { flat.Triangles(triangle, 0), flat.Triangles(triangle, 1), flat.Triangles(triangle, 2) });
    }
    EXPECT_NEAR(gone, shapetest::PolygonArea(footprint.RingImage), 1e-12);
    EXPECT_GT(gone, shapetest::PolygonArea(loop));
    const shape::PlanarOutline outline(loop), ring(footprint.RingImage);
    for (Eigen::Index i = 0; i < loop.rows(); ++i)
    {
      EXPECT_GE(ring.Side(loop.row(i)), 0);
    }
    // Points that go with the triangles are within the loop: those of the ring stay.
    const std::set<int> stay(footprint.Ring.begin(), footprint.Ring.end());
    for (int point = 0; point < static_cast<int>(flat.Points.rows()); ++point)
    {
      const bool goes = used.count(point) > 0 && stay.count(point) == 0;
      EXPECT_EQ(goes, outline.Side(flat.Points.row(point).head<2>()) > 0);
    }
    const Eigen::MatrixXd positions =
      shape::PullBack(footprint.Positions, flat.Triangles, flat.Points).leftCols(2);
    EXPECT_LT((positions - loop).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(CoveredRegion, ALoopAlongEdgesCoversWhatIsWithin)
{
  const shape::Mesh flat = shapetest::FlatSquare(8, 0.0);
  shape::CoveredRegionFinder finder(flat);
  // Off by less than the snap, in either sense.
  for (const bool turned : { false, true })
  {
    Eigen::MatrixXd loop = SquareAlongEdges();
    loop += 1e-9 * Eigen::MatrixXd::Random(16, 2);
    if (turned)
    {
      loop = loop.colwise().reverse().eval();
    }
    const shape::CoveredRegion footprint = finder.Find(FlatPatch(flat), loop, 1e-7);
    ASSERT_EQ(footprint.Fault, CoveredRegionFault::None);
    EXPECT_EQ(footprint.Triangles.size(), 32U);
    EXPECT_EQ(footprint.Ring.size(), 16U);
    EXPECT_EQ(shapetest::PolygonArea(footprint.RingImage), 1.0);
    EXPECT_EQ(shapetest::PolygonArea(footprint.Loop), turned ? -1.0 : 1.0);
  }
}

TEST(CoveredRegion, NoPointLiesWithinASideOfTheOther)
{
  const shape::Mesh flat = shapetest::FlatSquare(8, 0.0);
  // Corners within edges of the surface, and sides through its points.
  Eigen::MatrixXd loop(4, 2);
  loop << -0.375, -0.5, 0.375, -0.5, 0.5, 0.375, -0.5, 0.5;
  const shape::CoveredRegion footprint =
    shape::CoveredRegionFinder(flat).Find(FlatPatch(flat), loop, 1e-9);
  ASSERT_EQ(footprint.Fault, CoveredRegionFault::None);
  const shape::PlanarOutline outline(loop), ring(footprint.RingImage);
  for (Eigen::Index i = 0; i < footprint.RingImage.rows(); ++i)
  {
    const Eigen::RowVector2d position = footprint.RingImage.row(i);
    const bool isCorner = ((loop.rowwise() - position).rowwise().norm().array() == 0.0).any();
    EXPECT_TRUE(isCorner || outline.Side(position) < 0);
  }
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const Eigen::RowVector2d position = loop.row(i);
    const bool isPoint =
      ((footprint.RingImage.rowwise() - position).rowwise().norm().array() == 0.0).any();
    EXPECT_TRUE(isPoint || ring.Side(position) > 0);
  }
}

TEST(CoveredRegion, WhatIsWrongIsSaid)
{
  shape::Mesh flat = shapetest::FlatSquare(12, 0.2);
  const Eigen::MatrixXd loop = Circle(0.0, 0.0, 0.4, 30);
  const auto fault = [&](const shape::ExponentialPatch& patch, const Eigen::MatrixXd& polygon)
  { return shape::CoveredRegionFinder(flat).Find(patch, polygon, 1e-9).Fault; };
  EXPECT_EQ(fault(FlatPatch(flat), loop), CoveredRegionFault::None);
  EXPECT_EQ(fault(FlatPatch(flat), Circle(0.8, 0.0, 0.4, 30)), CoveredRegionFault::LeavesSurface);
  EXPECT_EQ(fault(FlatPatch(flat), Circle(0.0, 0.0, 3.0, 30)), CoveredRegionFault::LeavesSurface);

  // A patch that ends before the surface does.
  shape::ExponentialPatch part = FlatPatch(flat);
  const Eigen::VectorXd reach = shape::ComputeCentroids(flat).rowwise().norm();
  std::vector<int> near;
  for (int t = 0; t < static_cast<int>(reach.size()); ++t)
  {
    if (reach(t) < 0.6)
    {
      near.push_back(t);
    }
  }
  part.Corners = Eigen::MatrixXi(flat.Triangles(near, Eigen::all));
  part.Triangles = near;
  EXPECT_EQ(fault(part, loop), CoveredRegionFault::None);
  EXPECT_EQ(fault(part, Circle(0.0, 0.0, 0.7, 30)), CoveredRegionFault::BeyondPatch);
  EXPECT_EQ(fault(part, Circle(3.0, 0.0, 0.7, 30)), CoveredRegionFault::BeyondPatch);

  // A point drawn over its neighbours flips triangles: within the loop they do no harm.
  int middle = 0;
  flat.Points.rowwise().norm().minCoeff(&middle);
  shape::ExponentialPatch folded = FlatPatch(flat);
  folded.Positions.row(middle) << 0.2, 0.15;
  const shape::CoveredRegion within = shape::CoveredRegionFinder(flat).Find(folded, loop, 1e-9);
  EXPECT_EQ(within.Fault, CoveredRegionFault::None);
  EXPECT_GT(within.Flipped, 0);
  EXPECT_EQ(within.FlippedAtLoop, 0);
  EXPECT_EQ(within.Ring, shape::CoveredRegionFinder(flat).Find(FlatPatch(flat), loop, 1e-9).Ring);
  folded.Positions.row(middle) << 0.5, 0.05;
  const shape::CoveredRegion across = shape::CoveredRegionFinder(flat).Find(folded, loop, 1e-9);
  EXPECT_EQ(across.Fault, CoveredRegionFault::Flipped);
  EXPECT_GT(across.FlippedAtLoop, 0);

  // A hole of the surface within the loop.
  std::vector<int> others;
  for (int t = 0; t < static_cast<int>(reach.size()); ++t)
  {
    if (reach(t) > 0.15)
    {
      others.push_back(t);
    }
  }
  ASSERT_LT(others.size(), flat.Triangles.rows());
  flat.Triangles = Eigen::MatrixXi(flat.Triangles(others, Eigen::all));
  EXPECT_EQ(fault(FlatPatch(flat), loop), CoveredRegionFault::LeavesSurface);
  EXPECT_EQ(fault(FlatPatch(flat), Circle(0.6, 0.0, 0.3, 30)), CoveredRegionFault::None);

  // Two sheets over each other.
  const shape::Mesh one = shapetest::FlatSquare(6, 0.1);
  flat.Points.resize(2 * one.Points.rows(), 3);
  flat.Points << one.Points, one.Points;
  flat.Triangles.resize(2 * one.Triangles.rows(), 3);
  flat.Triangles << one.Triangles, one.Triangles.array() + static_cast<int>(one.Points.rows());
  EXPECT_EQ(fault(FlatPatch(flat), loop), CoveredRegionFault::Overlaps);
}

} // namespace
