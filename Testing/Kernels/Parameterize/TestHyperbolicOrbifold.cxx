#include "Base/Errors.h"
#include "Parameterize/HyperbolicOrbifold.h"
#include "Parameterize/Private/HyperbolicEnergy.h"
#include "Support/FlatMaps.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

double Minkowski(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return p(0) * q(0) + p(1) * q(1) - p(2) * q(2);
}

/// The angle at p between the geodesics to q and r.
double AngleAt(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
{
  const Eigen::Vector3d u = q + Minkowski(p, q) * p, v = r + Minkowski(p, r) * p;
  return std::acos(Minkowski(u, v) / std::sqrt(Minkowski(u, u) * Minkowski(v, v)));
}

int Flips(const shape::HyperbolicImage& image)
{
  return shapetest::CountFlips(image.Cut.Surface.Triangles, shape::ProjectToKlein(image.Points));
}

double AreaOf(const shape::HyperbolicImage& image)
{
  double area = 0.0;
  for (const auto& corners : image.Cut.Surface.Triangles.rowwise())
  {
    area += M_PI;
    for (int k = 0; k < 3; ++k)
    {
      area -= AngleAt(image.Points.row(corners(k)), image.Points.row(corners((k + 1) % 3)),
        image.Points.row(corners((k + 2) % 3)));
    }
  }
  return area;
}

std::vector<int> FirstPoints(int count)
{
  std::vector<int> points(count);
  for (int i = 0; i < count; ++i)
  {
    points[i] = i;
  }
  return points;
}

} // namespace

TEST(HyperbolicTile, IsARightAngledPolygonWhoseLegsMeet)
{
  for (const int cones : { 5, 6, 9, 20 })
  {
    const shape::HyperbolicTile tile = shape::BuildHyperbolicTile(cones);
    ASSERT_EQ(tile.Legs.size(), static_cast<std::size_t>(cones - 1));
    const double side = shape::ComputeHyperbolicDistance(tile.There[0], tile.There[1]);
    for (int i = 0; i < cones; ++i)
    {
      const Eigen::Vector3d &own = tile.There[i], &next = tile.There[(i + 1) % cones];
      EXPECT_NEAR(Minkowski(own, own), -1.0, 1e-9);
      EXPECT_NEAR(shape::ComputeHyperbolicDistance(own, next), side, 1e-9);
      EXPECT_NEAR(AngleAt(next, own, tile.There[(i + 2) % cones]), 0.5 * M_PI, 1e-9);
    }
    for (int i = 0; i + 1 < cones; ++i)
    {
      const shape::HyperbolicMotion& leg = tile.Legs[i];
      EXPECT_LT((shape::MoveHyperbolic(leg, tile.There[i]) - tile.Back[i]).norm(), 1e-8);
      EXPECT_LT((shape::MoveHyperbolic(leg, tile.There[i + 1]) - tile.Back[i + 1]).norm(), 1e-8);
      // Products of such numbers have fewer digits.
      EXPECT_GT(leg.determinant(), 0.0);
      EXPECT_LT(
        (leg * shape::InvertHyperbolic(leg) - shape::HyperbolicMotion::Identity()).norm(), 1e-9);
    }
  }
  EXPECT_REFUSED(shape::BuildHyperbolicTile(4), "at least 5 cones");
}

TEST(HyperbolicTile, AFullTurnAroundEachInnerConeIsMadeOfTwoTiles)
{
  // Around an inner cone of angle pi, the two legs there and back lead to the half turn about it.
  const shape::HyperbolicTile tile = shape::BuildHyperbolicTile(7);
  for (int i = 1; i + 1 < 7; ++i)
  {
    const shape::HyperbolicMotion around = shape::InvertHyperbolic(tile.Legs[i - 1]) * tile.Legs[i];
    EXPECT_LT((shape::MoveHyperbolic(around, tile.There[i]) - tile.There[i]).norm(), 1e-9);
    EXPECT_LT((around * around - shape::HyperbolicMotion::Identity()).norm(), 1e-9);
    EXPECT_NEAR(static_cast<double>(around.trace()), -1.0,
      1e-9); // a half turn has the eigenvalues 1, -1 and -1
  }
}

TEST(HyperbolicEnergy, DerivativesAgreeWithFiniteDifferences)
{
  // Three unknowns, one of which is also seen through an isometry, and a given position.
  const shape::HyperbolicTile tile = shape::BuildHyperbolicTile(5);
  std::vector<shape::HyperbolicPosition> positions(5);
  positions[0].Unknown = 0;
  positions[1].Unknown = 1;
  positions[2].Unknown = 2;
  positions[3].Unknown = 0;
  positions[3].Motion = 1;
  positions[4].Given = tile.There[2];
  const shape::HyperbolicEnergy energy(positions, tile.Legs,
    { { 0, 1, 0.7 }, { 1, 2, 1.3 }, { 2, 3, 0.4 }, { 3, 4, 2.0 }, { 4, 1, 0.9 } }, 3);
  Eigen::MatrixXd points(3, 3);
  points.row(0) = shape::LiftFromKlein({ 0.3, -0.2 });
  points.row(1) = shape::LiftFromKlein({ -0.5, 0.6 });
  points.row(2) = shape::LiftFromKlein({ 0.1, 0.85 });
  const auto at = energy.Differentiate(points);
  const double h = 1e-4;
  const Eigen::MatrixXd hessian = at.Hessian;
  EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues()(0), 0.0);
  const auto along = [&](const Eigen::VectorXd& step)
  { return energy.Value(shape::HyperbolicEnergy::Move(points, step)); };
  const double here = energy.Value(points);
  for (int i = 0; i < 6; ++i)
  {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(6, i);
    EXPECT_NEAR(at.Gradient(i), (along(step) - along(-step)) / (2.0 * h), 1e-6);
    for (int j = 0; j <= i; ++j)
    {
      // Along geodesics, the second difference is the Hessian.
      const Eigen::VectorXd other = h * Eigen::VectorXd::Unit(6, j);
      const double both = (along(step + other) + along(-step - other) - 2.0 * here) / (h * h);
      EXPECT_NEAR(both, hessian(i, i) + hessian(j, j) + 2.0 * hessian(i, j), 1e-5);
    }
  }
}

TEST(HyperbolicOrbifold, CoversTheOrbifoldOnceWithoutAFlip)
{
  for (const int cones : { 5, 8, 12 })
  {
    const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(4));
    const auto image = shape::MapToHyperbolicOrbifold(mesh, FirstPoints(cones));
    EXPECT_EQ(Flips(image), 0);
    // By the theorem of Gauss and Bonnet, two right-angled n-gons have the area (n - 4) pi.
    EXPECT_NEAR(AreaOf(image), (cones - 4) * M_PI, 1e-7);
    EXPECT_LT(image.Iterations, 12);
  }
}

TEST(HyperbolicOrbifold, AMirroredSurfaceHasTheMirroredImage)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(3));
  const shape::EdgePath path = shape::FindEdgePathThrough(mesh, FirstPoints(7));
  const auto image = shape::MapToHyperbolicOrbifold(mesh, path),
             mirrored = shape::MapToHyperbolicOrbifold(shapetest::Mirrored(mesh), path);
  Eigen::MatrixXd expected = image.Points;
  expected.col(1) *= -1.0;
  std::vector<char> onPath(mesh.Points.rows(), 0);
  for (const int point : path.Points)
  {
    onPath[point] = 1; // its copies change sides
  }
  double worst = 0.0;
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    if (onPath[i] == 0)
    {
      worst =
        std::max(worst, shape::ComputeHyperbolicDistance(expected.row(i), mirrored.Points.row(i)));
    }
  }
  EXPECT_LT(worst, 1e-7);
  EXPECT_NEAR(image.Energy, mirrored.Energy, 1e-9 * image.Energy);
}

TEST(HyperbolicOrbifold, WhatItCannotMapIsRefusedWithTheFact)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(2));
  EXPECT_REFUSED(shape::MapToHyperbolicOrbifold(mesh, FirstPoints(4)), "at least 5 cones");
  EXPECT_REFUSED(shape::MapToHyperbolicOrbifold(mesh, std::vector<int>{ 0, 1, 2, 3, 1 }),
    "are the same point, 1");
  EXPECT_REFUSED(shape::MapToHyperbolicOrbifold(shapetest::Torus(1.0, 0.3, 20, 10), FirstPoints(5)),
    "(genus 1)");
}
