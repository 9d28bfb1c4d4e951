#include "Untangle/Private/BoundaryFaults.h"
#include "Untangle/Private/ConeExpansion.h"
#include "Untangle/Private/InscribedBall.h"
#include "Untangle/Untangle.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace
{

/// A cube [-1, 1]^3 of n^3 cubes of six tetrahedra each.
shape::Cells TetrahedralCube(int n)
{
  const int side = n + 1, count = 6 * n * n * n;
  shape::Cells solid{ Eigen::MatrixXd(side * side * side, 3), Eigen::VectorXi::Constant(count, 10),
    Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), Eigen::VectorXi(4 * count) };
  const auto at = [&](int i, int j, int k) { return (k * side + j) * side + i; };
  int corner = 0;
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        solid.Points.row(at(i, j, k)) =
          Eigen::RowVector3d(i, j, k) * (2.0 / n) - Eigen::RowVector3d::Ones();
        if (i == n || j == n || k == n)
        {
          continue;
        }
        const int h[8] = { at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) };
        const int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
        for (int t = 0; t < 6; ++t)
        {
          for (const int point : { h[0], h[around[t]], h[around[t + 1]], h[6] })
          {
            solid.Corners(corner++) = point;
          }
        }
      }
    }
  }
  return solid;
}

/// Puts the boundary of such a cube on a random star-shaped surface, and all inner points at one
/// position outside of it.
void MakeStar(shape::Cells& cube, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.3, 1.0);
  for (Eigen::Index i = 0; i < cube.Points.rows(); ++i)
  {
    const bool isInner = cube.Points.row(i).cwiseAbs().maxCoeff() < 1.0 - 1e-9;
    cube.Points.row(i) = isInner ? Eigen::RowVector3d(2.0, 1.0, 0.5)
                                 : Eigen::RowVector3d(cube.Points.row(i) * uniform(random));
  }
}

int CountInverted(shape::SolidCells& solid)
{
  int count = 0;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    count += solid.Inverted(cell);
  }
  return count;
}

TEST(InscribedBall, IsThatOfATetrahedronAndTellsAnEmptyIntersection)
{
  // x, y, z >= 0 and x + y + z <= 1: the inscribed ball has the radius 1 / (3 + sqrt 3).
  std::vector<shape::HalfSpace> half;
  for (int axis = 0; axis < 3; ++axis)
  {
    half.push_back({ Eigen::Vector3d::Unit(axis), 0.0 });
  }
  half.push_back({ -Eigen::Vector3d::Ones() / std::sqrt(3.0), 1.0 / std::sqrt(3.0) });
  const double radius = 1.0 / (3.0 + std::sqrt(3.0));
  const shape::InscribedBall ball = shape::FindInscribedBall(half, 2.0);
  EXPECT_NEAR(ball.Radius, radius, 1e-14);
  EXPECT_LT((ball.Centre.array() - radius).abs().maxCoeff(), 1e-14);
  // x >= 1 and x <= 0 are missed by 1/2 each at x = 1/2.
  half = { { Eigen::Vector3d::UnitX(), -1.0 }, { -Eigen::Vector3d::UnitX(), 0.0 } };
  const shape::InscribedBall none = shape::FindInscribedBall(half, 2.0);
  EXPECT_NEAR(none.Radius, -0.5, 1e-14);
  EXPECT_NEAR(none.Centre(0), 0.5, 1e-14);
}

/// Splits random inner edges of tetrahedra, and moves the new points.
void SplitAtRandom(shape::SolidCells& solid, int count, std::mt19937& random)
{
  for (int split = 0; split < count;)
  {
    const int cell = static_cast<int>(random() % static_cast<unsigned int>(solid.CellCount()));
    std::vector<int> edge = solid.PointsOf(cell);
    std::shuffle(edge.begin(), edge.end(), random);
    edge.resize(2);
    if (solid.CanSplit(edge))
    {
      solid.Points.row(solid.Split(edge)).setConstant(0.1 * split++);
    }
  }
}

void ExpectEqual(const shape::SolidCells& solid, const shape::SolidCells& kept)
{
  const shape::Cells cells = solid.Result(), expected = kept.Result();
  EXPECT_EQ(cells.Points, expected.Points);
  EXPECT_EQ(cells.Corners, expected.Corners);
  EXPECT_EQ(solid.OriginalCells, kept.OriginalCells);
  EXPECT_EQ(solid.Parents, kept.Parents);
  for (int point = 0; point < kept.PointCount(); ++point)
  {
    EXPECT_EQ(solid.CellsOf(point), kept.CellsOf(point)) << point;
  }
}

TEST(SolidCells, RestoresTheStateThatWasKept)
{
  const shape::Cells cube = TetrahedralCube(3);
  shape::SolidCells solid(cube, cube.Points, "the cube");
  std::mt19937 random(31);
  SplitAtRandom(solid, 20, random);
  const shape::SolidCells kept = solid;
  solid.KeepState();
  for (int trial = 0; trial < 2; ++trial)
  {
    solid.KeepPositions({ 21, 22 });
    solid.Points.row(22).setConstant(7.0);
    SplitAtRandom(solid, 100, random);
    ASSERT_EQ(solid.PointCount(), kept.PointCount() + 100);
    solid.RestoreState();
    ExpectEqual(solid, kept);
  }
}

/// Expands the inverted tetrahedra with a limit of the work.
shape::SolidCells ExpandWithin(
  double work, const shape::Cells& cells, const shape::Progress& progress = {})
{
  shape::SolidCells solid(cells, {}, "the cube");
  shape::ConeExpansionOptions options;
  options.MaximumWork = work;
  shape::ExpandInverted(solid, options, progress);
  return solid;
}

TEST(ConeExpansion, RestoresTheSolidIfTheWorkExceedsItsLimit)
{
  shape::Cells cells = TetrahedralCube(4);
  MakeStar(cells, 11);
  const shape::SolidCells untouched = ExpandWithin(0.0, cells);
  bool isDone = false;
  int exceeded = 0;
  for (double work = 1e4; !isDone; work *= 2.0)
  {
    ASSERT_LT(work, 1e9);
    double reports = 0.0;
    shape::SolidCells solid = ExpandWithin(work, cells,
      shape::Progress(
        [&](double)
        {
          ++reports;
          return true;
        }));
    isDone = CountInverted(solid) == 0;
    if (!isDone)
    {
      ++exceeded;
      ExpectEqual(solid, untouched);
      EXPECT_GT(reports, work / 2000.0);
    }
  }
  EXPECT_GT(exceeded, 0);
}

TEST(ConeExpansion, WorksAroundTheInvertedTetrahedraAlone)
{
  double works[2] = { 0.0, 0.0 };
  for (const int n : { 12, 18 })
  {
    // Cubes of the same size. One inner point is pushed through the tetrahedra around it.
    shape::Cells cells = TetrahedralCube(n);
    cells.Points = (0.5 * n * (cells.Points.array() + 1.0)).round();
    cells.Points.row(6 * (n + 1) * (n + 1) + 6 * (n + 1) + 6) << 7.5, 6.25, 6.5;
    // The work is the least limit that is sufficient.
    double least = 0.0, most = 1e6;
    while (most - least > 1.0)
    {
      const double middle = std::floor((least + most) / 2.0);
      shape::SolidCells solid = ExpandWithin(middle, cells);
      (CountInverted(solid) > 0 ? least : most) = middle;
    }
    works[n / 18] = most;
  }
  EXPECT_GT(works[0], 1.0);
  EXPECT_EQ(works[0], works[1]);
}

TEST(ConeExpansion, MakesEveryTetrahedronOfAStarPositive)
{
  for (const int n : { 2, 3, 4 })
  {
    for (const unsigned int seed : { 11U, 12U, 13U })
    {
      const shape::Cells rest = TetrahedralCube(n);
      shape::Cells cells = rest;
      MakeStar(cells, seed);
      shape::SolidCells solid(cells, rest.Points, "the cube");
      ASSERT_GT(CountInverted(solid), 0);
      const shape::ConeExpansionResult result = shape::ExpandInverted(solid);
      EXPECT_EQ(CountInverted(solid), 0) << n << ' ' << seed;
      if (n > 2) // else one inner point, which only has to be placed
      {
        EXPECT_GT(result.Expansions, 0);
      }
      double volume = 0.0, before = 0.0;
      for (int cell = 0; cell < solid.CellCount(); ++cell)
      {
        const auto sum = [&](const Eigen::MatrixXd& x)
        {
          const std::vector<int>& c = solid.PointsOf(cell);
          Eigen::Matrix3d edges;
          edges << x.row(c[1]) - x.row(c[0]), x.row(c[2]) - x.row(c[0]), x.row(c[3]) - x.row(c[0]);
          return edges.determinant() / 6.0;
        };
        volume += sum(solid.Rest);
        before = std::min(before, sum(solid.Rest));
      }
      EXPECT_NEAR(volume, 8.0, 1e-12) << "the parts at rest fill the cube";
      EXPECT_GE(before, 0.0) << "and none of them is inverted";
      for (Eigen::Index i = 0; i < rest.Points.rows(); ++i)
      {
        if (solid.OnBoundary(static_cast<int>(i)))
        {
          EXPECT_EQ(solid.Points.row(i), cells.Points.row(i)) << "the boundary stays";
        }
      }
    }
  }
}

/// Bends a cube around the z axis by three quarters of a turn: no position sees both ends.
void Bend(shape::Cells& cube)
{
  for (Eigen::Index i = 0; i < cube.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = cube.Points.row(i);
    const double angle = 0.75 * M_PI * p(2), radius = 3.0 - p(0);
    cube.Points.row(i) << radius * std::cos(angle), radius * std::sin(angle), p(1);
  }
}

TEST(ConeExpansion, MakesSpaceInABoundaryThatIsNotStarShaped)
{
  shape::ConeExpansionOptions options;
  options.SplitCells = false;
  shape::Cells regular = TetrahedralCube(6);
  Bend(regular);
  shape::SolidCells valid(regular, {}, "the cube");
  ASSERT_EQ(CountInverted(valid), 0) << "there are positions for the points";
  for (const unsigned int seed : { 1U, 2U, 3U, 4U, 5U, 6U })
  {
    shape::Cells cells = TetrahedralCube(6);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-0.07, 0.07);
    for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
    {
      if (cells.Points.row(i).cwiseAbs().maxCoeff() < 1.0 - 1e-9)
      {
        cells.Points.row(i) +=
          Eigen::RowVector3d(uniform(random), uniform(random), uniform(random));
      }
    }
    Bend(cells);
    shape::SolidCells solid(cells, {}, "the cube");
    const int before = CountInverted(solid);
    EXPECT_GT(before, 0);
    shape::ExpandInverted(solid, options);
    EXPECT_EQ(CountInverted(solid), 0) << seed << ", of " << before;
  }
}

TEST(ConeExpansion, KeepsTheCellsIfTheyMayNotBeSplit)
{
  shape::Cells cells = TetrahedralCube(3);
  const Eigen::MatrixXd rest = cells.Points;
  MakeStar(cells, 21);
  shape::UntangleOptions options;
  options.SplitCells = false;
  const shape::UntangleResult result = shape::Untangle(cells, rest, options);
  EXPECT_EQ(result.Solid.Corners, cells.Corners);
  EXPECT_EQ(result.SplitCells, 0);
  EXPECT_EQ(shape::Untangle(cells, rest).InvertedAfter, 0) << "with splits";
}

TEST(ConeExpansion, EndsAndFindsWhereABoundaryCrossesItself)
{
  shape::Cells cells = TetrahedralCube(3);
  const Eigen::MatrixXd rest = cells.Points;
  // The corner (-1, -1, -1) is pushed out through the opposite side.
  cells.Points.row(0) << 1.5, 1.6, 1.7;
  const shape::UntangleResult result = shape::Untangle(cells, rest);
  EXPECT_GT(result.InvertedAfter, 0);
  ASSERT_GT(result.BoundaryCrossings, 0);
  EXPECT_LE(result.FirstCrossing.cwiseAbs().maxCoeff(), 1.7);
}

/// Pushes a corner of a cube of 3^3 cubes through a tetrahedron whose four points are fixed. It
/// then is inverted wherever the inner points are.
shape::UntangleResult UntangleWithDent(shape::Cells cells, const Eigen::MatrixXd& rest)
{
  // The points (1, -1, -1), (1/3, -1, -1), (1, -1/3, -1) and (1, -1/3, -1/3) of the cube.
  const int corner = 3, face[3] = { 2, 7, 23 };
  const Eigen::RowVector3d middle =
    (cells.Points.row(face[0]) + cells.Points.row(face[1]) + cells.Points.row(face[2])) / 3.0;
  cells.Points.row(corner) = middle - 0.2 * (cells.Points.row(corner) - middle);
  shape::UntangleOptions options;
  options.SplitCells = false;
  return shape::Untangle(cells, rest, options);
}

TEST(ConeExpansion, TellsABoundaryThatIsNotStarShaped)
{
  const shape::Cells cube = TetrahedralCube(3);
  shape::UntangleResult result = UntangleWithDent(cube, cube.Points);
  EXPECT_GT(result.InvertedAfter, 0);
  EXPECT_EQ(result.HiddenTriangles, 0) << "the origin sees the boundary of a dented cube";
  EXPECT_GT(result.StarClearance, 0.01);
  EXPECT_LT(result.StarClearance, 1.0 / std::sqrt(3.0)) << "that of the cube without the dent";
  EXPECT_EQ(result.FoldedEdges, 0);

  shape::Cells bent = cube;
  Bend(bent);
  result = UntangleWithDent(bent, cube.Points);
  EXPECT_GT(result.InvertedAfter, 0);
  ASSERT_GT(result.HiddenTriangles, 0);
  EXPECT_EQ(result.StarClearance, 0.0);
  EXPECT_LE(result.FirstHidden.head<2>().norm(), 4.0) << "on the boundary";
  EXPECT_LE(std::abs(result.FirstHidden(2)), 1.0) << "on the boundary";
}

TEST(ConeExpansion, TellsWhereTheBoundaryFoldsBackOnItself)
{
  // A point of the side z = 1 moves within it, over the edge between two of its neighbours.
  shape::Cells cells = TetrahedralCube(3);
  const Eigen::MatrixXd rest = cells.Points;
  const shape::SolidCells solid(cells, rest, "the cube");
  int moved = -1;
  for (int point = 0; point < rest.rows(); ++point)
  {
    const bool isInSide =
      rest(point, 2) == 1.0 && rest.row(point).head<2>().cwiseAbs().maxCoeff() < 1.0;
    moved = isInSide && moved < 0 ? point : moved;
  }
  ASSERT_GE(moved, 0);
  Eigen::RowVector3d first, second;
  for (const std::array<int, 3>& triangle : solid.BoundaryTriangles())
  {
    const auto at = std::find(triangle.begin(), triangle.end(), moved) - triangle.begin();
    if (at < 3)
    {
      first = rest.row(triangle[(at + 1) % 3]);
      second = rest.row(triangle[(at + 2) % 3]);
    }
  }
  const Eigen::RowVector3d middle = (first + second) / 2.0;
  cells.Points.row(moved) = middle - 0.2 * (rest.row(moved) - middle);
  EXPECT_EQ(shape::FindBoundaryFaults(solid, {}).FoldedEdges, 0);
  for (const bool isApart : { false, true })
  {
    // By one unit in the last place, the triangles do not touch each other.
    cells.Points(moved, 2) = isApart ? std::nextafter(1.0, 2.0) : 1.0;
    const shape::BoundaryFaults faults =
      shape::FindBoundaryFaults(shape::SolidCells(cells, rest, "the cube"), {});
    EXPECT_EQ(faults.BoundaryCrossings > 0, !isApart);
    ASSERT_GT(faults.FoldedEdges, 0);
    EXPECT_LT((faults.FirstFolded - middle).norm(), 1.0);
  }
  // Farther apart, this is a dent like any other.
  cells.Points(moved, 2) = 1.0 + 1e-10;
  EXPECT_EQ(
    shape::FindBoundaryFaults(shape::SolidCells(cells, rest, "the cube"), {}).FoldedEdges, 0);
}

} // namespace
