#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/KernelMoves.h"
#include "Untangle/Private/PatchCollar.h"
#include "Untangle/Private/StarCollar.h"
#include "Untangle/Untangle.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

constexpr int Permutations[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 },
  { 2, 1, 0 }, { 1, 0, 2 } };

/// A cube [-1, 1]^3 of n^3 cubes, each of the six tetrahedra of Kuhn's subdivision.
shape::Cells KuhnCube(int n)
{
  const int side = n + 1, count = 6 * n * n * n;
  shape::Cells solid{ Eigen::MatrixXd(side * side * side, 3), Eigen::VectorXi::Constant(count, 10),
    Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), Eigen::VectorXi(4 * count) };
  const auto at = [&](const Eigen::Array3i& p) { return (p(2) * side + p(1)) * side + p(0); };
  int corner = 0;
  for (int index = 0; index < side * side * side; ++index)
  {
    const Eigen::Array3i p(index % side, index / side % side, index / side / side);
    solid.Points.row(index) =
      p.cast<double>().matrix().transpose() * (2.0 / n) - Eigen::RowVector3d::Ones();
    if (p.maxCoeff() == n)
    {
      continue;
    }
    for (int t = 0; t < 6; ++t)
    {
      Eigen::Array3i q = p;
      std::array<int, 4> path = { at(q) };
      for (int k = 0; k < 3; ++k)
      {
        ++q(Permutations[t][k]);
        path[k + 1] = at(q);
      }
      // Odd permutations are turned over.
      if (t >= 3)
      {
        std::swap(path[1], path[2]);
      }
      for (const int point : path)
      {
        solid.Corners(corner++) = point;
      }
    }
  }
  return solid;
}

/// Multiplies the points of the cube's boundary by random factors between 1 and `reach`, equally
/// distributed in their logarithms.
void MakeSpikes(shape::Cells& cube, double reach, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, std::log(reach));
  for (Eigen::Index i = 0; i < cube.Points.rows(); ++i)
  {
    const double factor = std::exp(uniform(random));
    if (cube.Points.row(i).cwiseAbs().maxCoeff() > 1.0 - 1e-9)
    {
      cube.Points.row(i) *= factor;
    }
  }
}

/// Puts the boundary of a cube on the rays of a sphere, at random distances of 1 to 8 from its
/// centre. The centre of a side and the points around it are as close to each other as `size` says.
void MakeWafers(shape::Cells& cube, double size, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(1.0, 8.0);
  const Eigen::RowVector3d middle = Eigen::RowVector3d(1.0, 0.3, 0.2).normalized();
  for (Eigen::Index i = 0; i < cube.Points.rows(); ++i)
  {
    const double distance = uniform(random);
    const Eigen::RowVector3d place = cube.Points.row(i);
    if (place.cwiseAbs().maxCoeff() > 1.0 - 1e-9)
    {
      const bool isClose = place(0) > 1.0 - 1e-9 && place.tail<2>().cwiseAbs().maxCoeff() < 0.6;
      const Eigen::RowVector3d ray =
        isClose ? Eigen::RowVector3d(middle + size * (place - Eigen::RowVector3d::UnitX())) : place;
      cube.Points.row(i) = distance * ray.normalized();
    }
  }
}

double ComputeVolumeAtRest(const shape::SolidCells& solid, double& least)
{
  double volume = 0.0;
  least = 1.0;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    const std::vector<int>& c = solid.PointsOf(cell);
    Eigen::Matrix3d edges;
    edges << solid.Rest.row(c[1]) - solid.Rest.row(c[0]),
      solid.Rest.row(c[2]) - solid.Rest.row(c[0]), solid.Rest.row(c[3]) - solid.Rest.row(c[0]);
    volume += edges.determinant() / 6.0;
    least = std::min(least, edges.determinant());
  }
  return volume;
}

TEST(StarCollar, FindsACentreOnlyIfThereIsOne)
{
  shape::Cells cube = KuhnCube(4);
  const Eigen::MatrixXd rest = cube.Points;
  MakeSpikes(cube, 10.0, 1);
  const auto find = [&]
  {
    const shape::SolidCells solid(cube, rest, "the cube");
    return shape::FindStarCentre(solid, shape::FindStarFaces(solid));
  };
  const shape::StarPlacement centre = find();
  ASSERT_TRUE(centre.IsValid);
  EXPECT_LT(centre.Position.cwiseAbs().maxCoeff(), 1.0);
  // A cube bent to three quarters of a ring is not star-shaped.
  cube.Points = rest;
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
  {
    const double angle = 2.3 * rest(i, 0), radius = 3.0 - rest(i, 1);
    cube.Points.row(i) << radius * std::sin(angle), -radius * std::cos(angle), rest(i, 2);
  }
  EXPECT_FALSE(find().IsValid);
}

TEST(StarKernel, TakesTheNormalOfATriangleOfAFewRoundings)
{
  // A corner of a cube, cut off by the plane x + y + z = 2.2 of a triangle of size 2^-48.
  Eigen::MatrixXd points(7, 3);
  points << 0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 3,                    //
    1, 0.6, 0.6,                                                   //
    1 + 0x1p-49 + 0x1p-52, 0.6 - 0x1p-49 + 0x1p-52, 0.6 - 0x1p-51, //
    1 + 0x1p-48, 0.6 - 0x1p-48, 0.6;
  std::vector<shape::StarFace> faces = { { 4, 5, 6 } };
  for (int k = 0; k < 4; ++k)
  {
    faces.push_back(shape::FindFaceOpposite({ 0, 1, 2, 3 }, k));
  }
  const shape::StarPlacement centre =
    shape::FindKernelCentre(points, faces, Eigen::RowVector3d::Constant(0.6));
  ASSERT_TRUE(centre.IsValid);
  // The ball that touches the planes of the axes and that one.
  const double radius = 2.2 / (3.0 + std::sqrt(3.0));
  EXPECT_NEAR((centre.Position.array() - radius).abs().maxCoeff(), 0.0, 1e-9);
}

TEST(StarCollar, SeparatesTheBoundary)
{
  const shape::Cells cube = KuhnCube(2);
  shape::SolidCells solid(cube, cube.Points, "the cube");
  // Cells whose corners on the boundary span what is inside: the cell itself, or a simplex of it.
  const auto countInner = [&]
  {
    int inner = 0;
    for (int cell = 0; cell < solid.CellCount(); ++cell)
    {
      std::vector<int> boundary = solid.PointsOf(cell);
      boundary.erase(std::remove_if(boundary.begin(), boundary.end(),
                       [&](int point) { return !solid.OnBoundary(point); }),
        boundary.end());
      const bool isSimplex = boundary.size() == 2 || boundary.size() == 3;
      inner += boundary.size() == 4 || (isSimplex && solid.CanSplit(boundary)) ? 1 : 0;
    }
    return inner;
  };
  EXPECT_GT(countInner(), 0);
  shape::SeparateBoundary(solid);
  EXPECT_EQ(countInner(), 0);
}

TEST(StarCollar, MovesTheBoundaryOutwardHoweverFar)
{
  for (const double reach : { 2.0, 30.0, 1000.0 })
  {
    for (const unsigned int seed : { 1U, 2U, 3U })
    {
      const shape::Cells rest = KuhnCube(5);
      shape::Cells ball = rest, spikes = rest;
      MakeSpikes(spikes, reach, seed);
      // A map of the cube onto a ball, with the boundary on the rays of the spikes.
      for (Eigen::Index i = 0; i < ball.Points.rows(); ++i)
      {
        const double largest = rest.Points.row(i).cwiseAbs().maxCoeff();
        if (largest > 0.0)
        {
          ball.Points.row(i) = 0.5 * largest * rest.Points.row(i).normalized();
        }
      }
      shape::UntangleResult valid = shape::Untangle(ball, rest.Points);
      ASSERT_EQ(valid.InvertedAfter, 0);
      shape::SolidCells solid(valid.Solid, valid.Provenance.Weights * rest.Points, "the ball");
      // Only for the splits: the ball stays as it is.
      shape::SeparateBoundary(solid);
      ASSERT_TRUE(shape::FindInverted(solid).empty());
      Eigen::MatrixXd targets = solid.Points.topRows(solid.PointCount());
      targets.topRows(spikes.Points.rows()) = spikes.Points;
      EXPECT_EQ(shape::MoveOutward(solid, Eigen::RowVector3d::Zero(), targets, {}), 0)
        << reach << ' ' << seed;
      EXPECT_TRUE(shape::FindInverted(solid).empty());
      for (Eigen::Index i = 0; i < spikes.Points.rows(); ++i)
      {
        if (solid.OnBoundary(static_cast<int>(i)))
        {
          EXPECT_EQ(solid.Points.row(i), spikes.Points.row(i)) << "the boundary is at the targets";
        }
      }
      double least = 0.0;
      EXPECT_NEAR(ComputeVolumeAtRest(solid, least), 8.0, 1e-10)
        << "the parts at rest fill the cube";
      EXPECT_GT(least, 0.0) << "and none of them is inverted";
    }
  }
}

TEST(StarCollar, LetsUntangleEndValidInSpikes)
{
  for (const unsigned int seed : { 4U, 5U, 6U })
  {
    const shape::Cells rest = KuhnCube(5);
    shape::Cells spikes = rest;
    MakeSpikes(spikes, 100.0, seed);
    const shape::UntangleResult result = shape::Untangle(spikes, rest.Points);
    EXPECT_GT(result.InvertedBefore, 0) << seed;
    EXPECT_EQ(result.InvertedAfter, 0) << seed;
  }
}

TEST(PatchCollar, IsPositiveAtTrianglesOfAFewRoundings)
{
  for (const unsigned int seed : { 1U, 2U, 3U })
  {
    const shape::Cells rest = KuhnCube(4);
    shape::Cells wafers = rest;
    MakeWafers(wafers, 1e-13, seed);
    shape::SolidCells solid(wafers, rest.Points, "the cube");
    const shape::StarPlacement centre = shape::FindStarCentre(solid, shape::FindStarFaces(solid));
    ASSERT_TRUE(centre.IsValid) << "though doubles cannot find it";
    shape::SeparateBoundary(solid);
    const Eigen::MatrixXd targets = solid.Points.topRows(solid.PointCount());
    shape::ProjectToSphere(solid, centre.Position);
    const shape::PatchCollar collar = shape::BuildPatchCollar(solid, centre.Position, targets, {});
    EXPECT_EQ(collar.Inverted, 0) << seed;
    int cells = 0;
    for (int cell = 0; cell < solid.CellCount(); ++cell)
    {
      const std::vector<int>& points = solid.PointsOf(cell);
      const bool isInCollar = std::any_of(
        points.begin(), points.end(), [&](int point) { return solid.OnBoundary(point); });
      cells += isInCollar;
      EXPECT_FALSE(isInCollar && solid.Inverted(cell)) << cell;
    }
    EXPECT_GT(cells, static_cast<int>(solid.BoundaryTriangles().size()));
    for (int point = 0; point < rest.Points.rows(); ++point)
    {
      if (solid.OnBoundary(point))
      {
        EXPECT_EQ(solid.Points.row(point), wafers.Points.row(point)) << "is where it was put";
      }
    }
    // The inner side is a closed surface: each edge belongs to two triangles, once in each
    // direction.
    std::set<std::pair<int, int>> edges;
    EXPECT_FALSE(collar.Inside.empty()) << seed;
    for (const std::array<int, 3>& triangle : collar.Inside)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_TRUE(edges.emplace(triangle[k], triangle[(k + 1) % 3]).second);
      }
    }
    for (const auto& [a, b] : edges)
    {
      EXPECT_EQ(edges.count({ b, a }), 1U);
    }
  }
}

TEST(PatchCollar, SufficesWithExactMovesAlone)
{
  // Newton's method makes no step. Without the collar, more than a hundred cells stay inverted.
  for (const unsigned int seed : { 1U, 3U, 4U, 5U, 6U })
  {
    const shape::Cells rest = KuhnCube(8);
    shape::Cells wafers = rest;
    MakeWafers(wafers, 1e-13, seed);
    shape::UntangleOptions options;
    options.MaximumWork = 1.0;
    const shape::UntangleResult result = shape::Untangle(wafers, rest.Points, options);
    EXPECT_GT(result.InvertedBefore, 0) << seed;
    EXPECT_EQ(result.Iterations, 0) << seed;
    EXPECT_EQ(result.InvertedAfter, 0) << seed;
  }
}

TEST(StarCollar, KeepsTheBoundaryToTheBitIfTheCollarIsTooThin)
{
  for (const double reach : { 1e3, 1e6 })
  {
    for (const unsigned int seed : { 1U, 2U, 3U, 4U, 5U, 6U })
    {
      // A triangle in the middle of a face is smaller than the collar can be for some seeds.
      const shape::Cells rest = KuhnCube(3);
      shape::Cells spikes = rest;
      const Eigen::RowVector3d corner = rest.Points.row(5);
      for (const int point : { 6, 9 })
      {
        spikes.Points.row(point) = corner + 1e-12 * (rest.Points.row(point) - corner);
      }
      MakeSpikes(spikes, reach, seed);
      const shape::UntangleResult result = shape::Untangle(spikes, rest.Points);
      const shape::SolidCells solid(rest, rest.Points, "the cube");
      for (int point = 0; point < solid.PointCount(); ++point)
      {
        if (solid.OnBoundary(point))
        {
          EXPECT_EQ(result.Solid.Points.row(point), spikes.Points.row(point)) << reach << seed;
        }
      }
    }
  }
}

} // namespace
