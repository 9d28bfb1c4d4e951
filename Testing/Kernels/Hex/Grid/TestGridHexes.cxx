#include "Base/Errors.h"
#include "Hex/Fit/Private/Pillowing.h"
#include "Hex/Grid/GridHexes.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace
{

shape::Mesh Boundary(const shape::HexMesh& mesh)
{
  return { mesh.Points, shape::SplitQuads(shape::FindBoundaryQuads(mesh)) };
}

/// A grid of n^3 unit cells, all of them outside.
shape::SampledGrid Outside(int n)
{
  return { Eigen::RowVector3d::Zero(), 1.0, Eigen::RowVector3i::Constant(n),
    Eigen::VectorXd::Constant(n * n * n, 1.0) };
}

/// A block 4 x 4 x 1 with a round hole of radius 1 through its middle.
shape::Mesh BlockWithHole()
{
  constexpr int n = 48;
  shape::Mesh block{ Eigen::MatrixXd(4 * n, 3), Eigen::MatrixXi(8 * n, 3) };
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * M_PI * i / n;
    const Eigen::RowVector2d inner(std::cos(angle), std::sin(angle));
    const Eigen::RowVector2d outer = 2.0 / inner.cwiseAbs().maxCoeff() * inner;
    block.Points.row(i) << outer, 0.0;
    block.Points.row(n + i) << inner, 0.0;
    block.Points.row(2 * n + i) << inner, 1.0;
    block.Points.row(3 * n + i) << outer, 1.0;
    for (int k = 0; k < 4; ++k) // the bottom, the hole, the top, the sides
    {
      const int next = (i + 1) % n, a = k * n, b = (k + 1) % 4 * n;
      block.Triangles.row(2 * (4 * i + k)) << a + i, b + i, b + next;
      block.Triangles.row(2 * (4 * i + k) + 1) << a + i, b + next, a + next;
    }
  }
  return shape::OrientOutwards(block);
}

/// A pyramid on a square, whose apex has four sides; with another under it, an octahedron.
shape::Mesh Pyramid(bool isDouble)
{
  shape::Mesh pyramid{ Eigen::MatrixXd(isDouble ? 6 : 5, 3), Eigen::MatrixXi(isDouble ? 8 : 6, 3) };
  pyramid.Points.topRows(5) << 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1;
  pyramid.Triangles.topRows(4) << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  if (isDouble)
  {
    pyramid.Points.row(5) << 0, 0, -1;
    pyramid.Triangles.bottomRows(4) << 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5;
  }
  else
  {
    pyramid.Triangles.bottomRows(2) << 0, 3, 2, 0, 2, 1;
  }
  return pyramid;
}

} // namespace

TEST(HexMesh, TheBoundaryIsThatOfTheSolid)
{
  shape::SampledGrid grid = Outside(5);
  for (const int x : { 1, 2, 3 })
  {
    grid.Values(grid.Index(x, 2, 2)) = -1.0;
  }
  const shape::HexMesh mesh = shape::BuildVoxelHexahedra(grid, shape::FindVoxelSolid(grid).Inside);
  EXPECT_EQ(mesh.Hexahedra.rows(), 3);
  EXPECT_EQ(mesh.Points.rows(), 16);
  EXPECT_EQ(shape::ComputeScaledJacobians(mesh), Eigen::VectorXd::Ones(3));
  EXPECT_EQ(shape::FindBoundaryQuads(mesh).rows(), 14);
  const shape::Mesh boundary = Boundary(mesh);
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), 3.0, 1e-12);
  EXPECT_EQ(mesh.Points.row(mesh.Hexahedra(0, 0)), Eigen::RowVector3d(0.5, 1.5, 1.5));
}

TEST(WellComposedVoxels, CellsThatTouchInAnEdgeOrACornerAreMended)
{
  for (const Eigen::RowVector3i& other :
    { Eigen::RowVector3i(3, 3, 2), Eigen::RowVector3i(3, 3, 3) })
  {
    shape::SampledGrid grid = Outside(6);
    grid.Values(grid.Index(2, 2, 2)) = -1.0;
    grid.Values(grid.Index(other(0), other(1), other(2))) = -0.5;
    const shape::WellComposedVoxels solid = shape::FindVoxelSolid(grid);
    EXPECT_EQ(solid.Pinched, 0);
    // The cell that is nearest to the surface goes.
    EXPECT_EQ(solid.Changed, 1);
    EXPECT_EQ(std::count(solid.Inside.begin(), solid.Inside.end(), 1), 1);
    EXPECT_TRUE(solid.Inside[grid.Index(2, 2, 2)]);
  }
}

TEST(WellComposedVoxels, WhatIsNotPinchedIsAManifold)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int mended = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    shape::SampledGrid grid = Outside(12);
    const Eigen::MatrixXd waves = 2.0 *
      Eigen::MatrixXd::NullaryExpr(
        8, 4, [&](Eigen::Index, Eigen::Index) { return uniform(generator); });
    for (int z = 0; z < 12; ++z)
    {
      for (int y = 0; y < 12; ++y)
      {
        for (int x = 0; x < 12; ++x)
        {
          grid.Values(grid.Index(x, y, z)) =
            (waves * Eigen::Vector4d(x, y, z, 1.0)).array().sin().sum();
        }
      }
    }
    shape::WellComposedVoxels solid = shape::FindVoxelSolid(grid);
    if (solid.Pinched > 0)
    {
      continue;
    }
    ++mended;
    for (int side = 0; side < 12 * 12; ++side)
    {
      EXPECT_EQ(solid.Inside[grid.Index(0, side / 12, side % 12)], 0);
      EXPECT_EQ(solid.Inside[grid.Index(side / 12, side % 12, 11)], 0);
    }
    const auto topology =
      shape::ComputeTopology(Boundary(shape::BuildVoxelHexahedra(grid, solid.Inside)));
    EXPECT_EQ(topology.NonManifoldEdges, 0);
    EXPECT_EQ(topology.NonManifoldPoints, 0);
    EXPECT_EQ(topology.BoundaryLoops, 0);
    const auto before = std::count(solid.Inside.begin(), solid.Inside.end(), 1);
    shape::KeepLargestParts(grid, 1, solid.Inside);
    const auto largest = std::count(solid.Inside.begin(), solid.Inside.end(), 1);
    EXPECT_GT(largest, 0);
    EXPECT_LE(largest, before);
  }
  EXPECT_GT(mended, 10);
}

TEST(Padding, KeepsTheTopologyAndAddsAHexahedronForEachQuad)
{
  shape::SampledGrid grid = Outside(7);
  for (int z = 2; z < 5; ++z)
  {
    for (int x = 2; x < 5; ++x)
    {
      grid.Values(grid.Index(x, 3, z)) = x == 3 && z == 3 ? 1.0 : -1.0; // a ring
    }
  }
  shape::HexMesh mesh = shape::BuildVoxelHexahedra(grid, shape::FindVoxelSolid(grid).Inside);
  const Eigen::MatrixXi quads = shape::FindBoundaryQuads(mesh);
  const Eigen::Index points = mesh.Points.rows(), hexahedra = mesh.Hexahedra.rows();
  const std::vector<int> copyOf = shape::PadQuads(mesh, quads);
  EXPECT_EQ(mesh.Hexahedra.rows(), hexahedra + quads.rows());
  const auto copies =
    std::count_if(copyOf.begin(), copyOf.end(), [](int copy) { return copy >= 0; });
  EXPECT_EQ(mesh.Points.rows(), points + copies);
  // The boundary is the one there was.
  const Eigen::MatrixXi outer = shape::FindBoundaryQuads(mesh);
  EXPECT_EQ(outer.rows(), quads.rows());
  EXPECT_EQ(std::set<int>(outer.data(), outer.data() + outer.size()),
    std::set<int>(quads.data(), quads.data() + quads.size()));
  EXPECT_EQ(shape::RequireClosedSurface(Boundary(mesh), "the boundary").EulerNumber, 0);
}

TEST(Padding, FacesOutwardsAndEndsAtItsBorder)
{
  const Eigen::RowVector3d middle(0.5, 0.5, 0.5);
  shape::HexMesh cube{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(1, 8) };
  cube.Points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  cube.Hexahedra << 0, 1, 2, 3, 4, 5, 6, 7;
  shape::HexMesh whole = cube;
  for (const int copy : shape::PadQuads(whole, shape::FindBoundaryQuads(cube)))
  {
    whole.Points.row(copy) = middle + (whole.Points.row(copy) - middle) / 3.0;
  }
  EXPECT_EQ(whole.Hexahedra.rows(), 7);
  EXPECT_GT(shape::ComputeScaledJacobians(whole).minCoeff(), 0.5);
  // On one side only: a second box on the first, of which it takes the upper half.
  shape::HexMesh side = cube;
  const std::vector<int> copyOf = shape::PadQuads(side, Eigen::RowVector4i(4, 5, 6, 7));
  for (const int point : { 4, 5, 6, 7 })
  {
    side.Points(copyOf[point], 2) = 0.5;
  }
  EXPECT_EQ(side.Hexahedra.rows(), 2);
  EXPECT_EQ(shape::ComputeScaledJacobians(side), Eigen::VectorXd::Ones(2));
  EXPECT_EQ(shape::FindBoundaryQuads(side).rows(), 10);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Boundary(side)), 1.0, 1e-15);
}

TEST(GridHexes, FillASphereAndATorusWithGoodHexahedraOnTheirSurface)
{
  shape::GridHexesOptions options;
  options.CellSize = 0.2;
  options.Rounds = 1;
  for (const shape::Mesh& surface : { shapetest::Icosphere(4), shapetest::Torus(1.0, 0.4, 60, 30) })
  {
    const shape::GridHexesResult result = shape::BuildGridHexahedra(surface, options);
    EXPECT_EQ(result.Fit.Inverted, 0);
    EXPECT_EQ(
      result.Fit.MinimumScaledJacobian, shape::ComputeScaledJacobians(result.Fit.Solid).minCoeff());
    EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.6);
    EXPECT_GT(result.Fit.MeanScaledJacobian, 0.8);
    const shape::Mesh boundary = Boundary(result.Fit.Solid);
    EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber,
      shape::ComputeTopology(surface).EulerNumber);
    const std::set<int> points(
      boundary.Triangles.data(), boundary.Triangles.data() + boundary.Triangles.size());
    const shape::SurfaceLocator locator(surface);
    for (const int point : points)
    {
      EXPECT_LT(locator.Find(boundary.Points.row(point)).Distances(0), 1e-12);
    }
    EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), shape::ComputeEnclosedVolume(surface),
      0.03 * shape::ComputeEnclosedVolume(surface));
  }
}

TEST(GridHexes, FillSeveralSolidsAndLeaveVoids)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Mesh surface = shapetest::Joined({ sphere,
    shapetest::Reversed(shapetest::Sphere(3, 0.4)), shapetest::Sphere(3, 0.5, { 2, 0, 0 }) });
  shape::GridHexesOptions options;
  options.CellSize = 0.2;
  options.Rounds = 1;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(surface, options);
  const auto topology = shape::RequireClosedSurface(Boundary(result.Fit.Solid), "the boundary");
  EXPECT_EQ(topology.Components, 3);
  EXPECT_EQ(topology.EulerNumber, 6);
  EXPECT_EQ(result.Fit.Inverted, 0);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Boundary(result.Fit.Solid)),
    shape::ComputeEnclosedVolume(surface), 0.04 * shape::ComputeEnclosedVolume(surface));
}

TEST(GridHexes, SolidsAreApartHoweverNarrowTheGapIs)
{
  const shape::Mesh surface = shapetest::Twice(shapetest::Icosphere(3), { 2.01, 0.0, 0.0 });
  shape::GridHexesOptions options;
  options.CellSize = 0.2;
  options.Rounds = 1;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(surface, options);
  const auto topology = shape::RequireClosedSurface(Boundary(result.Fit.Solid), "the boundary");
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.EulerNumber, 4);
  EXPECT_EQ(result.CellSize, 0.2); // no smaller for the gap
  EXPECT_EQ(result.Fit.Inverted, 0);
}

TEST(GridHexes, CellsBecomeSmallerUntilTheTopologyIsTheSurfaces)
{
  // The hole is 0.02 wide.
  const shape::Mesh torus = shapetest::Torus(1.0, 0.99, 80, 60);
  shape::GridHexesOptions options;
  options.Rounds = 1;
  options.CellSize = 0.28; // four cells around the hole
  const shape::GridHexesResult result = shape::BuildGridHexahedra(torus, options);
  EXPECT_LT(result.CellSize, 0.28);
  EXPECT_EQ(shape::RequireClosedSurface(Boundary(result.Fit.Solid), "the boundary").EulerNumber, 0);
  options.MaximumHexahedra = 2000;
  EXPECT_THROW(shape::BuildGridHexahedra(torus, options), shape::SolveFailure);
}

TEST(GridHexes, MoreLayersAreMoreHexahedra)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  shape::GridHexesOptions options;
  options.CellSize = 0.25;
  options.Rounds = 1;
  const shape::HexFit one = shape::BuildGridHexahedra(sphere, options).Fit;
  options.PaddingLayers = 3;
  const shape::HexFit three = shape::BuildGridHexahedra(sphere, options).Fit;
  EXPECT_EQ(one.Quads.rows(), three.Quads.rows());
  EXPECT_EQ(three.Solid.Hexahedra.rows(), one.Solid.Hexahedra.rows() + 2 * one.Quads.rows());
  EXPECT_GT(three.MinimumScaledJacobian, 0.3);
}

TEST(GridHexes, ACubeIsItsOwnGrid)
{
  const shape::Mesh cube = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  shape::GridHexesOptions options;
  options.CellSize = 0.24;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(cube, options);
  EXPECT_TRUE(result.Fit.CreasesKept);
  EXPECT_EQ(result.Features.Patches, 6);
  EXPECT_EQ(result.Features.Corners.size(), 8U);
  // Each side has a layer of its own, so no corner has more than one hexahedron.
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.9999);
  EXPECT_LT(result.Fit.Distance, 1e-12);
  for (const Eigen::RowVector3d& corner : cube.Points.rowwise())
  {
    EXPECT_EQ((result.Fit.Solid.Points.rowwise() - corner).rowwise().norm().minCoeff(), 0.0);
  }
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Boundary(result.Fit.Solid)), 1.0, 1e-12);
}

TEST(GridHexes, CreasesAcrossTheGridAreKept)
{
  // No side of the turned box follows the grid.
  shape::Mesh box = shapetest::Box({ 0, 0, 0 }, { 1.0, 0.7, 0.5 });
  box.Points *=
    Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  shape::GridHexesOptions options;
  options.CellSize = 0.08;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(box, options);
  EXPECT_TRUE(result.Fit.CreasesKept);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  const double diagonal = std::sqrt(1.0 + 0.49 + 0.25);
  EXPECT_LT(result.Fit.Distance, 1e-3 * diagonal);
  for (const Eigen::RowVector3d& corner : box.Points.rowwise())
  {
    EXPECT_EQ((result.Fit.Solid.Points.rowwise() - corner).rowwise().norm().minCoeff(), 0.0);
  }
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Boundary(result.Fit.Solid)), 0.35, 1e-3);
}

TEST(GridHexes, CornersOfFourSidesAreKept)
{
  for (const bool isDouble : { false, true })
  {
    shape::Mesh pyramid = Pyramid(isDouble);
    pyramid.Points *=
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    shape::GridHexesOptions options;
    options.CellSize = 0.12;
    options.Rounds = 1;
    const shape::GridHexesResult result = shape::BuildGridHexahedra(pyramid, options);
    EXPECT_EQ(result.Features.Corners.size(), isDouble ? 6U : 5U);
    EXPECT_TRUE(result.Fit.CreasesKept);
    EXPECT_EQ(result.Fit.Creases.CornerPoints.size(), isDouble ? 6U : 5U);
    EXPECT_LT(result.Fit.Creases.Distance, 1e-9);
    EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
    EXPECT_LT(result.Fit.Distance, 1e-3 * shape::ComputeBoxDiagonal(pyramid.Points));
  }
}

TEST(GridHexes, CellsDoNotBecomeSmallerForCornersThatNoGridMakesBetter)
{
  shape::GridHexesOptions options;
  options.FirstHexahedra = 1000.0;
  options.MaximumHexahedra = 10000;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(Pyramid(false), options);
  EXPECT_LT(result.Fit.MinimumScaledJacobian, 0.55);
  EXPECT_EQ(result.Fit.Creases.CornerPoints.size(), 5U);
  EXPECT_GT(
    shape::FindMinimumScaledJacobianAwayFrom(result.Fit.Creases.CornerPoints, result.Fit.Solid),
    0.55);
  EXPECT_LE(result.Rounds, 3);
}

TEST(GridHexes, CreasesOfABracketAndOfARoundHoleAreNear)
{
  shape::GridHexesOptions options;
  options.Rounds = 1;
  options.CellSize = 0.15;
  const shape::Mesh block = BlockWithHole();
  const shape::HexFit hole = shape::BuildGridHexahedra(block, options).Fit;
  EXPECT_TRUE(hole.CreasesKept);
  EXPECT_EQ(hole.Creases.CornerPoints.size(), 8U);
  // The hole's edges are closed: no point of theirs is fixed, so chords are what keeps them apart.
  EXPECT_LT(hole.Creases.Distance, 1e-3 * shape::ComputeBoxDiagonal(block.Points));
  EXPECT_GT(hole.MinimumScaledJacobian, 0.55);
  options.CellSize = 0.1;
  const shape::Mesh bracket =
    shapetest::Prism({ { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 }, { 2, 0 }, { 2, 1 } });
  const shape::HexFit fit = shape::BuildGridHexahedra(bracket, options).Fit;
  EXPECT_TRUE(fit.CreasesKept);
  EXPECT_EQ(fit.Creases.CornerPoints.size(), 12U);
  EXPECT_LT(fit.Creases.Distance, 1e-9);
  EXPECT_GT(fit.MinimumScaledJacobian, 0.5);
}

TEST(GridHexes, TheSolidOfASurfaceThatCrossesItselfIsWhatItWindsAround)
{
  const shape::Mesh surface = shapetest::Twice(shapetest::Icosphere(3), { 1.01, 0.02, 0.03 });
  shape::GridHexesOptions options;
  options.CellSize = 0.15;
  options.Rounds = 1;
  const shape::GridHexesResult result = shape::BuildGridHexahedra(surface, options);
  EXPECT_GT(result.Crossings, 0);
  EXPECT_EQ(result.Fit.Inverted, 0);
  const auto topology = shape::RequireClosedSurface(Boundary(result.Fit.Solid), "the boundary");
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.EulerNumber, 2);
  // Two balls less the lens that they share: pi (4 + d) (2 - d)^2 / 12 at a distance d.
  const double d = Eigen::RowVector3d(1.01, 0.02, 0.03).norm();
  const double both = M_PI * (8.0 / 3.0 - (4.0 + d) * (2.0 - d) * (2.0 - d) / 12.0);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Boundary(result.Fit.Solid)), both, 0.03 * both);
}

TEST(GridHexes, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const auto refused = [&](const shape::Mesh& surface, double size, int maximum)
  {
    shape::GridHexesOptions options;
    options.CellSize = size;
    options.MaximumHexahedra = maximum;
    EXPECT_THROW(shape::BuildGridHexahedra(surface, options), shape::InvalidInput)
      << size << " " << maximum;
  };
  refused(sphere, -1.0, 1000);
  refused(sphere, std::numeric_limits<double>::quiet_NaN(), 1000);
  refused(sphere, 0.01, 1000);
  refused(sphere, 0.5, 0);
  refused(shapetest::WithoutLast(sphere), 0.5, 1000);
  EXPECT_THROW(shape::BuildGridHexahedra(
                 sphere, {}, shape::Progress([](double fraction) { return fraction < 0.5; })),
    shape::Aborted);
}
