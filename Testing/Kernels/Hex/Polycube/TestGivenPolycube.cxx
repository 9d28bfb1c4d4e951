#include "Base/Errors.h"
#include "Hex/HexRemesh.h"
#include "Hex/Polycube/Polycube.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{

/// The surface of a cube of n^2 squares on each side, with its points on the unit sphere.
shape::GivenPolycube CubeOnSphere(int n)
{
  shape::HexMesh cells{ Eigen::MatrixXd((n + 1) * (n + 1) * (n + 1), 3),
    Eigen::MatrixXi(n * n * n, 8) };
  const auto point = [&](int x, int y, int z) { return x + (n + 1) * (y + (n + 1) * z); };
  for (int z = 0; z <= n; ++z)
  {
    for (int y = 0; y <= n; ++y)
    {
      for (int x = 0; x <= n; ++x)
      {
        cells.Points.row(point(x, y, z)) << x, y, z;
      }
    }
  }
  int hex = 0;
  for (int z = 0; z < n; ++z)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        cells.Hexahedra.row(hex++) << point(x, y, z), point(x + 1, y, z), point(x + 1, y + 1, z),
          point(x, y + 1, z), point(x, y, z + 1), point(x + 1, y, z + 1),
          point(x + 1, y + 1, z + 1), point(x, y + 1, z + 1);
      }
    }
  }
  shape::GivenPolycube cube;
  cube.Surface = { cells.Points, shape::SplitQuads(shape::FindBoundaryQuads(cells)) };
  cube.Surface = shape::SplitComponents(cube.Surface)[0];
  cube.Sources = (cube.Surface.Points.array() * (2.0 / n) - 1.0).matrix().rowwise().normalized();
  return cube;
}

} // namespace

TEST(GivenPolycube, ACubeGivesABallOfCubes)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  shape::HexRemeshGuides guides;
  guides.Polycube = CubeOnSphere(8);
  guides.Polycube.Surface.Points *= 3.0; // its scale does not matter
  shape::HexRemeshOptions options;
  options.CellSize = std::cbrt(shape::ComputeEnclosedVolume(sphere)) / 8.0;
  const shape::HexRemeshResult result = shape::RemeshHexahedra(sphere, options, {}, guides);
  EXPECT_EQ(result.Method, shape::HexRemeshOptions::MethodType::Polycube);
  EXPECT_NEAR(result.CellSize, options.CellSize, 1e-12);
  // The 512 cells of the cube, and a layer of one on each of its 384 squares.
  EXPECT_EQ(result.Fit.Solid.Hexahedra.rows(), 512 + 384);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  const shape::Mesh boundary{ result.Fit.Solid.Points, shape::SplitQuads(result.Fit.Quads) };
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), shape::ComputeEnclosedVolume(sphere),
    0.04 * shape::ComputeEnclosedVolume(sphere));
  // The layer aside, four cells of the cube come together in no edge of the ball's surface, but at
  // its eight corners three quads do.
  Eigen::VectorXi quads = Eigen::VectorXi::Zero(result.Fit.Solid.Points.rows());
  for (const int point : result.Fit.Quads.reshaped())
  {
    ++quads(point);
  }
  EXPECT_EQ((quads.array() == 3).count(), 8);
  EXPECT_EQ((quads.array() > 4).count(), 0);
  options.Method = shape::HexRemeshOptions::MethodType::Grid;
  EXPECT_THROW(shape::RemeshHexahedra(sphere, options, {}, guides), shape::InvalidInput);
}

TEST(GivenPolycube, WhatPolycubeMakesIsTaken)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.45, 60, 30);
  shape::PolycubeOptions polycubeOptions;
  polycubeOptions.TargetEdgeLength = 0.14;
  const shape::PolycubeResult polycube = shape::BuildPolycube(torus, polycubeOptions);
  shape::HexRemeshGuides guides;
  guides.Polycube = { { polycube.Positions, torus.Triangles }, torus.Points };
  shape::HexRemeshOptions options;
  options.CellSize = polycube.EdgeLength;
  const shape::HexRemeshResult result = shape::RemeshHexahedra(torus, options, {}, guides);
  const shape::Mesh boundary{ result.Fit.Solid.Points, shape::SplitQuads(result.Fit.Quads) };
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 0);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), shape::ComputeEnclosedVolume(torus),
    0.03 * shape::ComputeEnclosedVolume(torus));
}

TEST(GivenPolycube, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::GivenPolycube good = CubeOnSphere(4);
  const auto fill = [](const shape::GivenPolycube& polycube, const shape::Mesh& surface)
  { return shape::BuildPolycubeCells(polycube, surface, 0.2, 100000); };
  EXPECT_NO_THROW(fill(good, sphere));
  shape::GivenPolycube bad = good;
  bad.Surface.Triangles.conservativeResize(bad.Surface.Triangles.rows() - 1, 3);
  EXPECT_REFUSED(fill(bad, sphere), "open");
  EXPECT_REFUSED(fill({ sphere, sphere.Points }, sphere), "perpendicular to an axis");
  bad = good;
  bad.Sources.array() += 1.0;
  EXPECT_REFUSED(fill(bad, sphere), "away from the Surface");
  bad.Sources(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(fill(bad, sphere), "finite");
  bad = good;
  bad.Surface.Points.col(1) *= 1.0 + 0.1 / M_PI; // then no unit suits all axes
  EXPECT_REFUSED(fill(bad, sphere), "multiples");
  const shape::Mesh torus = shapetest::Torus(1.0, 0.45, 30, 20);
  bad = good;
  bad.Sources.rowwise() = torus.Points.row(0);
  EXPECT_REFUSED(fill(bad, torus), "Euler number");
}
