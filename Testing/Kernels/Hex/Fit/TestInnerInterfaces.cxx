#include "Base/Errors.h"
#include "Hex/Fit/InnerInterfaces.h"
#include "Hex/Grid/GridHexes.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

shape::Mesh Ball(double radius, const Eigen::RowVector3d& centre, int level = 4)
{
  return shapetest::Sphere(level, radius, centre);
}

/// The hexahedra of one region.
shape::HexMesh Region(const shape::HexFit& fit, int region)
{
  std::vector<int> rows;
  for (int hex = 0; hex < static_cast<int>(fit.RegionOf.size()); ++hex)
  {
    if (fit.RegionOf(hex) == region)
    {
      rows.push_back(hex);
    }
  }
  return { fit.Solid.Points, fit.Solid.Hexahedra(rows, Eigen::all) };
}

shape::Mesh Boundary(const shape::HexMesh& mesh)
{
  return { mesh.Points, shape::SplitQuads(shape::FindBoundaryQuads(mesh)) };
}

/// What a ball loses by quads of this size that have their corners on it: their middles lie
/// size^2 / (6 radius) inside on average.
double Loss(double size, double volume)
{
  const double radius = std::cbrt(0.75 * volume / M_PI);
  return volume * 0.5 * size * size / (radius * radius);
}

/// Checks what holds for every result, and returns the volume of each region. size: of the cells;
/// quads are no larger.
std::vector<double> Check(const shape::HexFit& fit, const std::vector<shape::Surface>& inner,
  const std::vector<int>& eulerNumbers, double size)
{
  EXPECT_EQ(fit.Inverted, 0);
  EXPECT_EQ(fit.MinimumScaledJacobian, shape::ComputeScaledJacobians(fit.Solid).minCoeff());
  EXPECT_EQ(fit.RegionOf.size(), fit.Solid.Hexahedra.rows());
  EXPECT_EQ(fit.RegionOf.maxCoeff(), static_cast<int>(inner.size()));
  std::vector<double> volumes;
  for (std::size_t region = 0; region <= inner.size(); ++region)
  {
    // A manifold: no two regions touch but where they share quads.
    const shape::Mesh boundary = Boundary(Region(fit, static_cast<int>(region)));
    EXPECT_EQ(
      shape::RequireClosedSurface(boundary, "the region").EulerNumber, eulerNumbers[region]);
    volumes.push_back(shape::ComputeEnclosedVolume(boundary));
  }
  // Hexahedra share the points of interfaces: only the outer boundary's quads are had by one.
  EXPECT_EQ(shape::FindBoundaryQuads(fit.Solid).rows(), fit.Quads.rows());
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const shape::SurfaceLocator locator(inner[i]);
    for (const int point : fit.Interfaces[i].reshaped())
    {
      EXPECT_LT(locator.Find(fit.Solid.Points.row(point)).Distances(0), 1e-9);
    }
    const shape::Mesh interface {
      fit.Solid.Points, shape::SplitQuads(fit.Interfaces[i])
    };
    EXPECT_EQ(shape::RequireClosedSurface(interface, "the interface").EulerNumber,
      shape::ComputeTopology(inner[i]).EulerNumber);
    const double ball = std::abs(shape::ComputeEnclosedVolume(inner[i]));
    EXPECT_LT(shape::ComputeEnclosedVolume(interface), ball);
    EXPECT_GT(shape::ComputeEnclosedVolume(interface), ball - Loss(size, ball));
  }
  return volumes;
}

} // namespace

TEST(InnerInterfaces, ABallInABallIsARegionOfItsOwn)
{
  const shape::Mesh outer = Ball(1.0, { 0.0, 0.0, 0.0 });
  const std::vector<shape::Surface> inner = { Ball(0.5, { 0.05, 0.0, 0.02 }) };
  shape::GridHexesOptions options;
  options.CellSize = 0.15;
  options.Rounds = 1;
  const shape::HexFit fit = shape::BuildGridHexahedra(outer, options, {}, inner).Fit;
  const std::vector<double> volumes = Check(fit, inner, { 4, 2 }, options.CellSize);
  const double ball = shape::ComputeEnclosedVolume(inner[0]),
               whole = shape::ComputeEnclosedVolume(outer);
  EXPECT_NEAR(volumes[1], ball, Loss(options.CellSize, ball));
  EXPECT_NEAR(volumes[0], whole - ball, Loss(options.CellSize, whole));
  EXPECT_GT(fit.MinimumScaledJacobian, 0.3);
  EXPECT_GT(fit.InnerDistance, 0.0);
  EXPECT_LT(fit.InnerDistance, 0.03);
}

TEST(InnerInterfaces, TheirDistanceIsThatAfterTheOuterSurfaceIsSnappedTo)
{
  // A tip sharper than the cells, above a ball that is not much larger than they are.
  shape::Mesh drop = Ball(1.0, { 0.0, 0.0, 0.0 });
  for (auto point : drop.Points.rowwise())
  {
    const double away = (point - Eigen::RowVector3d::UnitX()).norm();
    point *= 1.0 + 0.3 * std::exp(-away / 0.1);
  }
  const std::vector<shape::Surface> inner = { Ball(0.15, { 0.8, 0.0, 0.0 }, 3) };
  shape::GridHexesOptions options;
  options.CellSize = 0.12;
  options.Rounds = 1;
  const shape::HexFit snapped = shape::BuildGridHexahedra(drop, options, {}, inner).Fit;
  options.Snap = false;
  const shape::HexFit fit = shape::BuildGridHexahedra(drop, options, {}, inner).Fit;
  EXPECT_LT(snapped.Distance, fit.Distance);
  EXPECT_NE(snapped.InnerDistance, fit.InnerDistance);
  for (const shape::HexFit* each : { &snapped, &fit })
  {
    EXPECT_EQ(each->InnerDistance,
      shape::ComputeInterfaceDistance(each->Solid.Points, each->Interfaces, inner));
  }
}

TEST(InnerInterfaces, BallsSideBySideAndInOneAnother)
{
  const shape::Mesh outer = Ball(1.0, { 0.0, 0.0, 0.0 });
  std::vector<shape::Surface> inner = { Ball(0.3, { 0.0, 0.5, 0.0 }, 3),
    Ball(0.35, { 0.0, -0.4, 0.0 }, 3), Ball(0.15, { 0.0, -0.4, 0.0 }, 2) };
  // Either orientation is right.
  inner[1] = shape::Surface(inner[1].Points(), inner[1].Triangles().rowwise().reverse());
  shape::GridHexesOptions options;
  options.CellSize = 0.1;
  options.Rounds = 1;
  options.PaddingLayers = 2;
  const shape::HexFit fit = shape::BuildGridHexahedra(outer, options, {}, inner).Fit;
  const std::vector<double> volumes = Check(fit, inner, { 6, 2, 4, 2 }, options.CellSize);
  EXPECT_LT(volumes[3], volumes[1]);
}

TEST(InnerInterfaces, CreasesOfInnerSurfacesAreRounded)
{
  shape::HexMesh cell{ Eigen::MatrixXd(8, 3), Eigen::RowVectorXi::LinSpaced(8, 0, 7) };
  cell.Points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  cell.Points = 0.9 * (cell.Points.array() - 0.5).matrix();
  const shape::Mesh cube = Boundary(cell);
  shape::GridHexesOptions options;
  options.CellSize = 0.15;
  options.Rounds = 2;
  const std::vector<shape::Surface> inner = { cube };
  const shape::GridHexesResult result =
    shape::BuildGridHexahedra(Ball(1.0, { 0.0, 0.0, 0.0 }), options, {}, inner);
  EXPECT_FALSE(result.InnerCreasesKept);
  EXPECT_TRUE(result.Fit.CreasesKept);
  EXPECT_EQ(result.Fit.Inverted, 0);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  EXPECT_LT(result.Fit.InnerDistance, options.CellSize);
  const shape::SurfaceLocator locator(cube);
  for (const int point : result.Fit.Interfaces[0].reshaped())
  {
    EXPECT_LT(locator.Find(result.Fit.Solid.Points.row(point)).Distances(0), 1e-9);
  }
}

TEST(InnerInterfaces, WhatIsNotInsideOrCrossesIsNamed)
{
  const shape::Mesh outer = Ball(1.0, { 0.0, 0.0, 0.0 }, 2);
  shape::GridHexesOptions options;
  options.CellSize = 0.2;
  const auto fill = [&](const std::vector<shape::Surface>& inner)
  { return shape::BuildGridHexahedra(outer, options, {}, inner); };
  EXPECT_REFUSED(fill({ Ball(0.5, { 0.8, 0.0, 0.0 }, 2) }), "cross");
  EXPECT_REFUSED(fill({ Ball(0.5, { 2.0, 0.0, 0.0 }, 2) }), "outside");
  EXPECT_REFUSED(
    fill({ Ball(0.4, { 0.1, 0.0, 0.0 }, 2), Ball(0.4, { -0.1, 0.0, 0.0 }, 2) }), "cross");
  EXPECT_REFUSED(fill({ shapetest::WithoutLast(Ball(0.4, { 0.0, 0.0, 0.0 }, 2)) }), "open");
}
