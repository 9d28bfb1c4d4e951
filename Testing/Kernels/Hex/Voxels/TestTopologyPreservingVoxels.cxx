#include "Distance/HausdorffDistance.h"
#include "Hex/Voxels/GridDensity.h"
#include "Hex/Voxels/TopologyPreservingVoxels.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/GridWinding.h"
#include "Solids/Nesting.h"
#include "Solids/SolidBoundary.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

namespace
{

shape::SampledGrid GridAround(double half, int count)
{
  shape::SampledGrid grid;
  grid.Spacing = 2.0 * half / (count - 1);
  grid.Counts.setConstant(count);
  grid.Origin.setConstant(-half);
  return grid;
}

/// Two unit spheres, the second one moved along x.
shape::Mesh TwoSpheres(double apart)
{
  return shapetest::Twice(shapetest::Icosphere(3), { apart, 0, 0 });
}

} // namespace

TEST(GridWinding, IsTheWindingNumberAtEveryPoint)
{
  // Lines through points and edges of the surface included: those of a grid through its points.
  shape::Mesh surface = TwoSpheres(0.9);
  surface.Points.col(0).array() -= 0.45;
  const shape::SampledGrid grid = GridAround(2.0, 33);
  const Eigen::VectorXi numbers = shape::ComputeGridWindingNumbers(surface, grid);
  int two = 0;
  for (int z = 0; z < 33; ++z)
  {
    for (int y = 0; y < 33; ++y)
    {
      for (int x = 0; x < 33; ++x)
      {
        const double exact =
          shape::ComputeWindingNumber(surface.Points, surface.Triangles, grid.Point(x, y, z));
        if (std::abs(exact - std::round(exact)) < 1e-6) // not on the surface
        {
          ASSERT_EQ(numbers(grid.Index(x, y, z)), std::lround(exact)) << x << " " << y << " " << z;
          two += numbers(grid.Index(x, y, z)) == 2;
        }
      }
    }
  }
  EXPECT_GT(two, 100);
}

TEST(SolidBoundary, LeavesOutWhatLiesInside)
{
  const shape::SolidBoundaryResult apart = shape::ExtractSolidBoundary(TwoSpheres(3.0));
  EXPECT_EQ(apart.Crossings, 0);
  EXPECT_EQ(apart.Surface.Triangles().rows(), 2 * 1280);
  const shape::Mesh surface = TwoSpheres(1.0);
  const shape::SolidBoundaryResult result = shape::ExtractSolidBoundary(surface);
  EXPECT_GT(result.Crossings, 0);
  EXPECT_LT(result.Surface.Triangles().rows(), surface.Triangles.rows());
  // Kept whole at the most: triangles that cross, which are near the plane between the spheres.
  const Eigen::MatrixXd centroids = shape::ComputeCentroids(result.Surface);
  double inside = 0.0;
  for (const Eigen::RowVector3d& centroid : centroids.rowwise())
  {
    const Eigen::RowVector3d other = centroid - Eigen::RowVector3d(1.0, 0.0, 0.0);
    inside = std::max(inside, 1.0 - std::max(centroid.norm(), other.norm()));
  }
  EXPECT_LT(inside, 0.1);
}

TEST(TopologyPreservingVoxels, ASurfaceThatFacesOutwardsIsNotCopied)
{
  // Then all who ask for its topology or its search tree share them.
  const shape::Surface surface = TwoSpheres(3.0);
  const shape::TopologyPreservingVoxels voxels(surface);
  EXPECT_EQ(&voxels.GetSurface().AsMesh(), &surface.AsMesh());
  EXPECT_EQ(&voxels.Boundary().Surface.AsMesh(), &surface.AsMesh());
  EXPECT_EQ(&shape::OrientByNesting(surface, "it").AsMesh(), &surface.AsMesh());
  // One that faces inwards is turned once.
  const shape::Surface inwards(surface.Points(), surface.Triangles().rowwise().reverse());
  EXPECT_EQ(&shape::OrientOutwards(inwards).AsMesh(), &shape::OrientOutwards(inwards).AsMesh());
  EXPECT_NEAR(shape::ComputeEnclosedVolume(shape::OrientOutwards(inwards)),
    shape::ComputeEnclosedVolume(surface), 1e-12);
  // What bounds a solid is found once, too.
  const shape::Surface crossing = TwoSpheres(1.0);
  EXPECT_EQ(&shape::ExtractSolidBoundary(crossing).Surface.AsMesh(),
    &shape::ExtractSolidBoundary(crossing).Surface.AsMesh());
}

TEST(SolidLevels, AreSignedDistancesNearTheSurface)
{
  const shape::Mesh sphere = shapetest::Icosphere(5);
  const shape::SampledGrid levels =
    shape::SampleSolidDistances(sphere, shape::SurfaceLocator(sphere), 0.1);
  for (int z = 0; z < levels.Counts(2); ++z)
  {
    for (int y = 0; y < levels.Counts(1); ++y)
    {
      for (int x = 0; x < levels.Counts(0); ++x)
      {
        const double exact = levels.Point(x, y, z).norm() - 1.0,
                     level = levels.Values(levels.Index(x, y, z));
        ASSERT_NEAR(level, std::clamp(exact, -0.2, 0.2), 2e-3);
      }
    }
  }
}

TEST(GridDensity, IsOneToOneAndMagnifies)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<shape::RefinementSeed> magnifiers;
  for (int i = 0; i < 20; ++i)
  {
    const Eigen::RowVector3d centre(uniform(generator), uniform(generator), uniform(generator));
    magnifiers.push_back({ centre, 0.3, 0.4 });
  }
  const shape::GridDensity warp(magnifiers);
  const Eigen::MatrixXd positions = Eigen::MatrixXd::NullaryExpr(
    500, 3, [&](Eigen::Index, Eigen::Index) { return uniform(generator); });
  EXPECT_LT((warp.Backward(warp.Forward(positions)) - positions).cwiseAbs().maxCoeff(), 1e-4);
  constexpr double step = 1e-5;
  for (const Eigen::RowVector3d& position : positions.rowwise())
  {
    Eigen::Matrix3d jacobian;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::RowVector3d off = step * Eigen::RowVector3d::Unit(axis);
      jacobian.col(axis) =
        (warp.Forward(position + off) - warp.Forward(position - off)).transpose() / (2.0 * step);
    }
    ASSERT_GT(jacobian.determinant(), 0.0);
  }
  // One alone magnifies its centre by exp(Strength), and leaves what is far away.
  const shape::GridDensity one({ { Eigen::RowVector3d::Zero(), 1.0, 0.4 } });
  EXPECT_NEAR(one.Forward(Eigen::RowVector3d(1e-6, 0.0, 0.0))(0) / 1e-6, std::exp(0.4), 1e-5);
  EXPECT_EQ(one.Forward(Eigen::RowVector3d(10.0, 0.0, 0.0))(0), 10.0);
}

TEST(CoverSurface, AddsCellsAtTipsAndKeepsTheTopology)
{
  // A row of cells, and places of a surface that goes on for three more.
  shape::SampledGrid grid{ Eigen::RowVector3d::Zero(), 1.0, Eigen::RowVector3i(12, 5, 5),
    Eigen::VectorXd::Constant(300, 1.0) };
  std::vector<char> inside(300, 0);
  for (int x = 2; x < 6; ++x)
  {
    inside[grid.Index(x, 2, 2)] = 1;
  }
  Eigen::MatrixXd positions(30, 3);
  for (int i = 0; i < 30; ++i)
  {
    positions.row(i) << 5.5 + 0.1 * i, 2.05, 1.95;
  }
  const int changed = shape::CoverSurface(grid, positions, 0.7, inside);
  EXPECT_EQ(changed, 3);
  EXPECT_TRUE(inside[grid.Index(6, 2, 2)] && inside[grid.Index(8, 2, 2)]);
  const shape::HexMesh cubes = shape::BuildVoxelHexahedra(grid, inside);
  EXPECT_EQ(shape::RequireClosedSurface(
              { cubes.Points, shape::SplitQuads(shape::FindBoundaryQuads(cubes)) }, "the boundary")
              .EulerNumber,
    2);
}

TEST(HausdorffDistance, OfTwoSpheresIsTheDifferenceOfTheirRadii)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const shape::HausdorffDistances distances =
    shape::ComputeHausdorffDistance(sphere, { 1.1 * sphere.Points, sphere.Triangles });
  EXPECT_NEAR(distances.FromFirst, 0.1, 1e-3);
  EXPECT_NEAR(distances.FromSecond, 0.1, 1e-3);
  // A part is near the whole, but the whole is not near the part.
  const shape::Mesh part{ sphere.Points, sphere.Triangles.topRows(100) };
  const shape::HausdorffDistances sided = shape::ComputeHausdorffDistance(part, sphere);
  EXPECT_LT(sided.FromFirst, 1e-12);
  EXPECT_GT(sided.FromSecond, 1.0);
}
