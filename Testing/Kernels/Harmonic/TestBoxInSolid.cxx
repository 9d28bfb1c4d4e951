#include "Distance/SignedDistance.h"
#include "Harmonic/Private/BoxInSolid.h"
#include "Mesh/Surface.h"
#include "Mesh/UsedPoints.h"
#include "Support/RandomPoints.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace
{

using shapetest::RandomPoints;

using shape::Mesh;

} // namespace

// The volumes of a sphere's part in cubes sum to the sphere's.
TEST(BoxInSolid, VolumesSumToTheSolid)
{
  const Mesh mesh = shapetest::Icosphere(2);
  const shape::SignedDistance inside{ shape::Surface(mesh) };
  std::vector<int> all(mesh.Triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  double sum = 0.0;
  constexpr int count = 7;
  for (int i = 0; i < count * count * count; ++i)
  {
    shape::BoxCube cube;
    cube.Half = 1.1 / count;
    cube.Centre =
      Eigen::Vector3d(i % count, i / count % count, i / count / count) * 2.0 * cube.Half;
    cube.Centre.array() -= 1.1 - cube.Half + 0.0123;
    const double volume =
      shape::ComputeVolumeInCube(mesh, shape::FindTrianglesInCube(mesh, all, cube), cube,
        inside.Evaluate(cube.Corner().transpose()).Distances(0) < 0.0);
    sum += volume;
  }
  EXPECT_NEAR(sum, shape::ComputeEnclosedVolume(mesh), 1e-12);
}

// The box around the sphere's part of a cube contains all of it, and no face is farther away than
// the part reaches.
TEST(BoxInSolid, BoundsTheSolidInACube)
{
  const Mesh mesh = shapetest::Icosphere(2);
  const shape::SignedDistance inside{ shape::Surface(mesh) };
  const auto isInside = [&](const Eigen::Vector3d& position)
  { return inside.Evaluate(position.transpose()).Distances(0) <= 0.0; };
  std::vector<int> all(mesh.Triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  std::mt19937 random(5);
  int cut = 0, smaller = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    shape::BoxCube cube;
    cube.Half = trial % 3 == 0 ? 0.6 : 0.1;
    cube.Centre = RandomPoints(1, random).transpose();
    Eigen::AlignedBox3d bounds;
    if (shape::FindTrianglesInCube(mesh, all, cube, &bounds).empty())
    {
      continue;
    }
    ++cut;
    const Eigen::AlignedBox3d box = shape::BoundSolidInCube(cube, bounds, isInside);
    smaller += box.volume() < 4.0 * std::pow(cube.Half, 3);
    Eigen::AlignedBox3d sampled;
    Eigen::MatrixXd samples = cube.Half * RandomPoints(1000, random);
    samples.rowwise() += cube.Centre.transpose();
    const Eigen::VectorXd distances = inside.Evaluate(samples).Distances;
    for (Eigen::Index i = 0; i < samples.rows(); ++i)
    {
      if (distances(i) <= 0.0)
      {
        sampled.extend(samples.row(i).transpose());
      }
    }
    EXPECT_TRUE(sampled.isEmpty() || box.contains(sampled));
  }
  EXPECT_GT(cut, 50);
  EXPECT_GT(smaller, 20);
}

// The part of a cuboid in a cube is the intersection of two boxes.
TEST(BoxInSolid, BoundsACuboidExactly)
{
  const Eigen::RowVector3d low(-0.9, -0.5, -0.7), high(0.6, 0.8, 0.4);
  const Mesh mesh = shapetest::Box(low, high);
  const Eigen::AlignedBox3d solid(low.transpose(), high.transpose());
  const auto isInside = [&](const Eigen::Vector3d& position) { return solid.contains(position); };
  std::vector<int> all(mesh.Triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  std::mt19937 random(7);
  int cut = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const shape::BoxCube cube{ RandomPoints(1, random).transpose(), trial % 3 == 0 ? 0.6 : 0.15 };
    Eigen::AlignedBox3d bounds;
    if (shape::FindTrianglesInCube(mesh, all, cube, &bounds).empty())
    {
      continue;
    }
    ++cut;
    const Eigen::AlignedBox3d box = shape::BoundSolidInCube(cube, bounds, isInside);
    const Eigen::AlignedBox3d exact = cube.Box().intersection(solid);
    EXPECT_LE((box.min() - exact.min()).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LE((box.max() - exact.max()).cwiseAbs().maxCoeff(), 1e-6);
  }
  EXPECT_GT(cut, 50);
}
