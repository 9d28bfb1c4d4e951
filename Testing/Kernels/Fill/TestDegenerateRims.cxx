#include "Fill/FillHoles.h"
#include "Mesh/Topology.h"
#include "Support/HoleShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

constexpr std::array<shape::FillMethod, 4> AllMethods = { shape::FillMethod::Automatic,
  shape::FillMethod::Deformation, shape::FillMethod::Fair, shape::FillMethod::Membrane };

/// Points on the unit circle (n x 3).
Eigen::MatrixXd Circle(int count)
{
  Eigen::MatrixXd circle(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    circle.row(i) << std::cos(angle), std::sin(angle), 0.0;
  }
  return circle;
}

/// A ribbon's inner border with the ribbon to the left; also where points coincide.
std::vector<int> InnerBoundary(int count)
{
  std::vector<int> loop;
  for (int i = 0; i < count; ++i)
  {
    loop.push_back((count - i) % count);
  }
  return loop;
}

shape::FilledSurface Filled(const shape::Mesh& ribbon, shape::FillMethod method)
{
  shape::FillHolesOptions options;
  options.Method = method;
  return shape::FillLoops(
    ribbon, { InnerBoundary(static_cast<int>(ribbon.Points.rows()) / 3) }, options);
}

} // namespace

TEST(DegenerateRims, LoopsOfOneAndOfTwoPlacesAreClosedByNumber)
{
  for (const int count : { 3, 4, 7 })
  {
    for (const int positions : { 1, 2 })
    {
      const Eigen::MatrixXd circle = Circle(count);
      Eigen::MatrixXd curve = Eigen::MatrixXd::Zero(count, 3);
      curve.bottomRows(positions == 1 ? 0 : count / 2).col(0).setOnes();
      const shape::Mesh ribbon = shapetest::Ribbon(curve, circle);
      for (const shape::FillMethod method : AllMethods)
      {
        const shape::FilledSurface filled = Filled(ribbon, method);
        EXPECT_EQ(filled.Holes[0].Points, 0);
        EXPECT_EQ(filled.Holes[0].Triangles, count - 2);
        EXPECT_EQ(shapetest::Crossings(filled), 0);
        shapetest::ExpectSound(ribbon, filled, 1, 1);
      }
    }
  }
}

TEST(DegenerateRims, SidesWithoutLengthChangeNothingElse)
{
  constexpr int count = 40;
  const Eigen::MatrixXd circle = Circle(count);
  Eigen::MatrixXd curve = circle;
  curve.col(2) = 0.2 * (2.0 * curve.col(0).array()).sin();
  // Each place three times.
  Eigen::MatrixXd tripled(3 * count, 3);
  for (int i = 0; i < 3 * count; ++i)
  {
    tripled.row(i) = curve.row(i / 3);
  }
  const shape::Mesh plain = shapetest::Ribbon(curve, 0.1 * circle);
  const shape::Mesh ribbon = shapetest::Ribbon(tripled, 0.1 * Circle(3 * count));
  for (const shape::FillMethod method : AllMethods)
  {
    const shape::FilledSurface filled = Filled(ribbon, method);
    shapetest::ExpectSound(ribbon, filled, 1, 1);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
    const shape::FilledHole own = Filled(plain, method).Holes[0];
    EXPECT_EQ(filled.Holes[0].Triangles, own.Triangles + 2 * count);
    EXPECT_EQ(filled.Holes[0].Points, own.Points);
  }
}

TEST(DegenerateRims, ThinSlits)
{
  constexpr int count = 60;
  const Eigen::MatrixXd circle = Circle(count);
  for (const double width : { 1e-2, 1e-6, 1e-10 })
  {
    Eigen::MatrixXd slit = circle;
    slit.col(1) *= width;
    const shape::Mesh ribbon = shapetest::Ribbon(slit, 0.1 * circle);
    for (const shape::FillMethod method : AllMethods)
    {
      const shape::FilledSurface filled = Filled(ribbon, method);
      shapetest::ExpectSound(ribbon, filled, 1, 1);
      const double height = filled.Surface.Points.col(2).cwiseAbs().maxCoeff();
      const bool isMembrane = method == shape::FillMethod::Membrane;
      if (width == 1e-2 || isMembrane)
      {
        EXPECT_EQ(height, 0.0);
      }
      EXPECT_LT(height, 1e-3);
      if (width == 1e-2)
      {
        const shape::Mesh patch{ filled.Surface.Points,
          filled.Surface.Triangles.bottomRows(filled.Holes[0].Triangles) };
        EXPECT_NEAR(0.5 * shape::ComputeAreaVectors(patch).rowwise().norm().sum(),
          0.5 * count * std::sin(2.0 * M_PI / count) * width, 1e-14);
      }
      if (isMembrane || method == shape::FillMethod::Automatic)
      {
        EXPECT_EQ(shapetest::Crossings(filled), 0);
      }
    }
  }
}

TEST(DegenerateRims, FarFromTheOrigin)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 50);
  shape::Mesh far = open;
  far.Points.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
  for (const shape::FillMethod method : AllMethods)
  {
    shape::FillHolesOptions options;
    options.Method = method;
    const shape::FilledSurface here = shape::FillHoles(open, options);
    const shape::FilledSurface there = shape::FillHoles(far, options);
    shapetest::ExpectSound(far, there, 0, 2);
    EXPECT_EQ(shapetest::Crossings(there), 0);
    EXPECT_NEAR(there.Holes[0].DeviationAfter, here.Holes[0].DeviationAfter, 1e-4);
    ASSERT_EQ(there.Surface.Points.rows(), here.Surface.Points.rows());
    // Coordinates are rounded to 1e-10 there.
    const Eigen::MatrixXd back =
      there.Surface.Points.rowwise() - Eigen::RowVector3d(1e6, -1e6, 1e6);
    EXPECT_LT((back - here.Surface.Points).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(DegenerateRims, TinyHolesBesideALargeOne)
{
  // In the middle of some triangles a small one, joined to the corners, is missing.
  const shape::Mesh open = shapetest::SphereWithoutCap(3, 40);
  constexpr int tiny = 5;
  shape::Mesh pierced = open;
  pierced.Points.conservativeResize(open.Points.rows() + 3 * tiny, 3);
  pierced.Triangles.conservativeResize(open.Triangles.rows() + 6 * tiny, 3);
  for (int hole = 0; hole < tiny; ++hole)
  {
    const Eigen::RowVector3i corners = open.Triangles.row(7 * hole);
    const Eigen::RowVector3d middle = open.Points(corners, Eigen::all).colwise().mean();
    const double size = std::pow(10.0, -2 - 2 * hole);
    const auto first = static_cast<int>(open.Points.rows()) + 3 * hole;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      pierced.Points.row(first + k) = middle + size * (open.Points.row(corners(k)) - middle);
      pierced.Triangles.middleRows(open.Triangles.rows() + 6 * hole + 2 * k, 2) << corners(k),
        corners(next), first + next, corners(k), first + next, first + k;
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < pierced.Triangles.rows(); ++t)
  {
    if (t >= 7 * tiny || t % 7 != 0)
    {
      kept.push_back(t);
    }
  }
  pierced.Triangles = Eigen::MatrixXi(pierced.Triangles(kept, Eigen::all));
  for (const shape::FillMethod method : AllMethods)
  {
    shape::FillHolesOptions options;
    options.Method = method;
    const shape::FilledSurface filled = shape::FillHoles(pierced, options);
    EXPECT_EQ(filled.Holes.size(), 6u);
    shapetest::ExpectSound(pierced, filled, 0, 2);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
  }
}

TEST(DegenerateRims, WhateverTheRimTheFillIsAManifold)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 60; ++round)
  {
    const int count = 3 + static_cast<int>(random() % 50);
    const Eigen::MatrixXd circle = Circle(count);
    Eigen::MatrixXd curve = circle;
    for (int i = 0; i < count; ++i)
    {
      const double along = 2.0 * M_PI * i / count;
      switch (round % 6)
      {
        case 0: // rough
          curve.row(i) +=
            0.3 * Eigen::RowVector3d(uniform(random), uniform(random), uniform(random));
          break;
        case 1: // to and fro on one line
          curve.row(i) << std::min(i, count - i), 0.0, 0.0;
          break;
        case 2: // an eight that crosses itself
          curve.row(i) << std::cos(along), std::sin(2.0 * along), 0.0;
          break;
        case 3: // anywhere
          curve.row(i) << uniform(random), uniform(random), uniform(random);
          break;
        case 4: // from one place to another and back
          curve.row(i) << i % 2, 0.0, 0.0;
          break;
        default: // up and down
          curve(i, 2) = 2.0 * std::sin(5.0 * along);
      }
    }
    const shape::Mesh ribbon =
      shapetest::Ribbon(curve, round % 4 == 0 ? Eigen::MatrixXd(0.0 * circle) : 0.1 * circle);
    for (const shape::FillMethod method : AllMethods)
    {
      shapetest::ExpectSound(ribbon, Filled(ribbon, method), 1, 1);
    }
  }
}
