#include "Base/Errors.h"
#include "Hex/Optimize/HexOptimization.h"
#include "Hex/Optimize/Private/HexSweeps.h"
#include "Hex/Optimize/Private/HexUntangling.h"
#include "Quality/ScaledJacobian.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

namespace
{

/// n^3 unit cubes around the origin.
shape::HexMesh Grid(int n)
{
  const auto id = [n](int x, int y, int z) { return x + (n + 1) * (y + (n + 1) * z); };
  shape::HexMesh mesh{ Eigen::MatrixXd((n + 1) * (n + 1) * (n + 1), 3),
    Eigen::MatrixXi(n * n * n, 8) };
  for (int z = 0; z <= n; ++z)
  {
    for (int y = 0; y <= n; ++y)
    {
      for (int x = 0; x <= n; ++x)
      {
        mesh.Points.row(id(x, y, z)) << x - 0.5 * n, y - 0.5 * n, z - 0.5 * n;
        if (x < n && y < n && z < n)
        {
          mesh.Hexahedra.row(x + n * (y + n * z)) << id(x, y, z), id(x + 1, y, z),
            id(x + 1, y + 1, z), id(x, y + 1, z), id(x, y, z + 1), id(x + 1, y, z + 1),
            id(x + 1, y + 1, z + 1), id(x, y + 1, z + 1);
        }
      }
    }
  }
  return mesh;
}

bool OnSide(const shape::HexMesh& mesh, int point, int n)
{
  return mesh.Points.row(point).cwiseAbs().maxCoeff() == 0.5 * n;
}

/// Points that stay where they are; the others are free.
class Fixed : public shape::PointConstraint
{
public:
  explicit Fixed(std::vector<char> fixed)
    : Stays(std::move(fixed))
  {
  }
  int Freedom(int point) const override { return this->Stays[point] ? 0 : 3; }
  shape::PointDirections Directions(int, const Eigen::RowVector3d&) const override
  {
    return Eigen::Matrix<double, 3, 0>();
  }
  Eigen::RowVector3d Nearest(int, const Eigen::RowVector3d& position) const override
  {
    return position;
  }

private:
  std::vector<char> Stays;
};

/// Points that stay on the unit sphere; the others are free.
class OnSphere : public shape::PointConstraint
{
public:
  explicit OnSphere(std::vector<char> on)
    : On(std::move(on))
  {
  }
  int Freedom(int point) const override { return this->On[point] ? 2 : 3; }
  shape::PointDirections Directions(int, const Eigen::RowVector3d& position) const override
  {
    const Eigen::Vector3d normal = position.transpose().normalized(), one = normal.unitOrthogonal();
    Eigen::Matrix<double, 3, 2> directions;
    directions << one, normal.cross(one);
    return directions;
  }
  Eigen::RowVector3d Nearest(int, const Eigen::RowVector3d& position) const override
  {
    return position.normalized();
  }

private:
  std::vector<char> On;
};

std::vector<char> Sides(const shape::HexMesh& mesh, int n)
{
  std::vector<char> sides;
  for (int point = 0; point < mesh.Points.rows(); ++point)
  {
    sides.push_back(OnSide(mesh, point, n));
  }
  return sides;
}

/// The grid with its points inside moved at random.
shape::HexMesh Shaken(int n, double maximum)
{
  shape::HexMesh mesh = Grid(n);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-maximum, maximum);
  for (int point = 0; point < mesh.Points.rows(); ++point)
  {
    if (!OnSide(mesh, point, n))
    {
      mesh.Points.row(point) +=
        Eigen::RowVector3d(uniform(generator), uniform(generator), uniform(generator));
    }
  }
  return mesh;
}

std::vector<std::array<int, 2>> Around(const shape::HexMesh& mesh, int point)
{
  std::vector<std::array<int, 2>> around;
  for (int hex = 0; hex < mesh.Hexahedra.rows(); ++hex)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      if (mesh.Hexahedra(hex, corner) == point)
      {
        around.push_back({ hex, corner });
      }
    }
  }
  return around;
}

shape::StarEnergy StarOf(const shape::HexMesh& mesh, const Eigen::VectorXd& leastSquares, int point)
{
  return { mesh.Points.transpose(), mesh.Hexahedra, leastSquares, Around(mesh, point) };
}

} // namespace

TEST(StarEnergy, IsTheSumOverTheCorners)
{
  // Stars of 1, 2, 4 and 8 hexahedra, some of them inverted; by the definition, corner by corner.
  shape::HexMesh mesh = Shaken(2, 0.9);
  mesh.Points.row(0) << 0.3, 0.2, 0.1;
  const Eigen::VectorXd minimumSquares = shape::StarEnergy::MinimumSquares(mesh);
  ASSERT_LT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.0);
  const double sharpness = 4.0;
  for (int point = 0; point < static_cast<int>(mesh.Points.rows()); ++point)
  {
    double sum = 0.0;
    for (const auto& [hex, own] : Around(mesh, point))
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const int* neighbours = shape::HexNeighbours[corner];
        if (corner != own && std::find(neighbours, neighbours + 3, own) == neighbours + 3)
        {
          continue;
        }
        Eigen::Matrix3d edges;
        for (int k = 0; k < 3; ++k)
        {
          edges.row(k) = mesh.Points.row(mesh.Hexahedra(hex, neighbours[k])) -
            mesh.Points.row(mesh.Hexahedra(hex, corner));
        }
        const double determinant = edges.determinant();
        const double added = determinant < 0.0 ? 0.0 : minimumSquares(hex);
        const double lengths = std::sqrt((edges.rowwise().squaredNorm().array() + added).prod());
        sum += std::exp(sharpness * (1.0 - determinant / lengths));
      }
    }
    EXPECT_NEAR(
      StarOf(mesh, minimumSquares, point).Value(mesh.Points.row(point).transpose(), sharpness), sum,
      1e-12 * sum);
  }
}

TEST(StarEnergy, ItsGradientIsTheDerivative)
{
  const shape::HexMesh mesh = Shaken(2, 0.6);
  const int middle = 13;
  const shape::StarEnergy star = StarOf(mesh, shape::StarEnergy::MinimumSquares(mesh), middle);
  const Eigen::Vector3d x(0.3, -0.2, 0.1);
  const auto here = star.Expand(x, 3.0);
  EXPECT_DOUBLE_EQ(here.Value, star.Value(x, 3.0));
  for (int c = 0; c < 3; ++c)
  {
    const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(c);
    const double slope = (star.Value(x + step, 3.0) - star.Value(x - step, 3.0)) / 2e-5;
    EXPECT_NEAR(here.Gradient(c), slope, 1e-7 * here.Gradient.norm());
  }
  EXPECT_GT(here.Curvature.ldlt().vectorD().minCoeff(), 0.0);
}

TEST(StarEnergy, TendsToTheWorstCorner)
{
  const shape::HexMesh mesh = Shaken(2, 0.3);
  const int middle = 13;
  const shape::StarEnergy star = StarOf(mesh, shape::StarEnergy::MinimumSquares(mesh), middle);
  // All eight hexahedra are around this point; corners of theirs that it does not touch are right.
  const double minimum = shape::ComputeScaledJacobians(mesh).minCoeff();
  const Eigen::Vector3d x = mesh.Points.row(middle).transpose();
  const double sharpness = 300.0;
  const double soft = std::log(star.Value(x, sharpness)) / sharpness;
  EXPECT_GE(soft, 1.0 - minimum - 1e-12);
  EXPECT_LE(soft, 1.0 - minimum + std::log(32.0) / sharpness);
}

TEST(StarEnergy, StarsArePartsOfOneEnergy)
{
  // Each corner of a hexahedron is in four stars. Long hexahedra beside short ones.
  shape::HexMesh mesh = Shaken(3, 0.2);
  mesh.Points.col(0) = mesh.Points.col(0).array().exp().eval();
  const Eigen::VectorXd leastSquares = shape::StarEnergy::MinimumSquares(mesh);
  const auto whole = [&]
  {
    double sum = 0.0;
    for (int point = 0; point < static_cast<int>(mesh.Points.rows()); ++point)
    {
      sum += StarOf(mesh, leastSquares, point).Value(mesh.Points.row(point).transpose(), 5.0);
    }
    return 0.25 * sum;
  };
  const int moved = 21;
  const shape::StarEnergy star = StarOf(mesh, leastSquares, moved);
  const double before = whole(), own = star.Value(mesh.Points.row(moved).transpose(), 5.0);
  mesh.Points.row(moved).array() += 0.1;
  const double change = star.Value(mesh.Points.row(moved).transpose(), 5.0) - own;
  EXPECT_GT(std::abs(change), 1e-3 * own);
  EXPECT_NEAR(whole() - before, change, 1e-9 * before);
}

TEST(HexOptimization, AGridIsFoundAgain)
{
  constexpr int n = 5;
  shape::HexMesh mesh = Shaken(n, 1.2);
  const Fixed constraint(Sides(Grid(n), n));
  const auto result = shape::OptimizeHexahedra(mesh, constraint);
  EXPECT_GT(result.InvertedBefore, 10);
  EXPECT_EQ(result.InvertedAfter, 0);
  EXPECT_GT(result.MinimumAfter, 0.99);
  EXPECT_EQ(result.MinimumAfter, shape::ComputeScaledJacobians(mesh).minCoeff());
  EXPECT_LT((mesh.Points - Grid(n).Points).cwiseAbs().maxCoeff(), 0.1);
}

TEST(HexOptimization, PointsOfTheBoundaryStayOnIt)
{
  constexpr int n = 6;
  shape::HexMesh mesh = Grid(n);
  const auto sides = Sides(mesh, n);
  for (int point = 0; point < mesh.Points.rows(); ++point)
  {
    if (sides[point])
    {
      mesh.Points.row(point).normalize();
    }
  }
  const auto result = shape::OptimizeHexahedra(mesh, OnSphere(sides));
  EXPECT_EQ(result.InvertedAfter, 0);
  // A corner's three edges dip into the sphere by half their length: at 120 degrees around it,
  // their determinant is 3 sqrt(3) / 2 cos^2 a sin a with sin a = length / 2. The edges beside a
  // corner cannot all be longer than a sixth of a great circle's quarter by much.
  const double dip = std::sin(M_PI / 24.0);
  EXPECT_GT(result.MinimumAfter, 1.5 * std::sqrt(3.0) * (1.0 - dip * dip) * dip);
  for (int point = 0; point < mesh.Points.rows(); ++point)
  {
    if (sides[point])
    {
      EXPECT_NEAR(mesh.Points.row(point).norm(), 1.0, 1e-15);
    }
  }
}

TEST(HexOptimization, TheWorstAreRaisedOnWhereTheyAreNotGoodEnough)
{
  // One point inside is held far from its place; what is near it is less than a tenth of all.
  constexpr int n = 20, side = n + 1;
  shape::HexMesh grid = Grid(n);
  auto fixed = Sides(grid, n);
  const int middle = 10 + side * (10 + side * 10);
  fixed[middle] = 1;
  grid.Points.row(middle) += Eigen::RowVector3d(2.2, 1.8, 1.2);
  const auto raised = [&](double to)
  {
    shape::HexMesh mesh = grid;
    shape::HexOptimizationOptions options;
    options.Sweeps = options.WorstSweeps = 1;
    options.RaiseTo = to;
    return std::pair(shape::OptimizeHexahedra(mesh, Fixed(fixed), options).MinimumAfter, mesh);
  };
  const auto [minimum, mesh] = raised(0.0);
  EXPECT_EQ(raised(minimum).second.Points, mesh.Points);
  EXPECT_GT(raised(minimum + 0.02).first, minimum + 1e-3);
}

TEST(HexOptimization, SmoothingMakesPointsMeansOfTheirNeighbours)
{
  constexpr int n = 4;
  shape::HexMesh mesh = Shaken(n, 0.8);
  const Fixed constraint(Sides(Grid(n), n));
  shape::SmoothHexahedra(mesh, constraint, 200);
  EXPECT_LT((mesh.Points - Grid(n).Points).cwiseAbs().maxCoeff(), 1e-12);
  mesh = Grid(n);
  shape::SmoothHexahedra(mesh, OnSphere(Sides(mesh, n)), 0);
  for (int point = 0; point < mesh.Points.rows(); ++point)
  {
    EXPECT_TRUE(
      !OnSide(Grid(n), point, n) || std::abs(mesh.Points.row(point).norm() - 1.0) < 1e-15);
  }
}

namespace
{

const int Steps = shape::HexOptimizationOptions().UntanglingSteps;

} // namespace

TEST(HexUntangling, TurnsWhatNoPointAloneCanTurn)
{
  // Two neighbours have changed places.
  constexpr int n = 4, side = n + 1;
  const shape::HexMesh grid = Grid(n);
  const Fixed constraint(Sides(grid, n));
  const int one = 1 + side * (2 + side * 2), other = one + 2;
  shape::HexMesh mesh = grid;
  mesh.Points.row(one).swap(mesh.Points.row(other));
  ASSERT_LT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.0);
  EXPECT_EQ(shape::UntangleHexahedra(mesh, constraint, Steps), 0);
  EXPECT_GT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.3);
  for (int point = 0; point < grid.Points.rows(); ++point)
  {
    if (OnSide(grid, point, n))
    {
      EXPECT_EQ(mesh.Points.row(point), grid.Points.row(point));
    }
  }
  shape::HexMesh good = grid;
  EXPECT_EQ(shape::UntangleHexahedra(good, constraint, Steps), 0);
  EXPECT_EQ(good.Points, grid.Points);
}

TEST(HexUntangling, CountsWhatTheBoundaryKeepsInverted)
{
  constexpr int n = 3;
  shape::HexMesh mesh = Grid(n);
  const Fixed constraint(Sides(mesh, n));
  mesh.Points.row(0) << 0.4, 0.4, 0.4; // a corner of the boundary, beyond the first cells
  const double before =
    static_cast<double>((shape::ComputeScaledJacobians(mesh).array() <= 0.0).count());
  const int left = shape::UntangleHexahedra(mesh, constraint, Steps);
  EXPECT_GT(left, 0);
  EXPECT_LE(left, before);
  EXPECT_EQ(left, (shape::ComputeScaledJacobians(mesh).array() <= 0.0).count());
  EXPECT_TRUE(mesh.Points.allFinite());
}

TEST(HexOptimization, AnyNumberOfThreadsGivesTheSameBits)
{
  constexpr int n = 4;
  const Fixed constraint(Sides(Grid(n), n));
  shape::HexMesh one = Shaken(n, 0.8), three = one;
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  shape::OptimizeHexahedra(one, constraint);
  setenv("VTK_SMP_MAX_THREADS", "3", 1);
  shape::OptimizeHexahedra(three, constraint);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one.Points, three.Points);
}

TEST(HexOptimization, NeverMakesTheWorstWorse)
{
  constexpr int n = 3;
  shape::HexMesh mesh = Grid(n);
  const auto result = shape::OptimizeHexahedra(mesh, Fixed(std::vector<char>(64, 1)));
  EXPECT_EQ(mesh.Points, Grid(n).Points);
  EXPECT_EQ(result.MinimumAfter, result.MinimumBefore);
  mesh.Hexahedra(0, 0) = 64;
  EXPECT_THROW(
    shape::OptimizeHexahedra(mesh, Fixed(std::vector<char>(65, 1))), shape::InvalidInput);
  shape::HexOptimizationOptions options;
  options.Sweeps = -1;
  EXPECT_THROW(
    shape::OptimizeHexahedra(mesh, Fixed(std::vector<char>(65, 1)), options), shape::InvalidInput);
  mesh = Shaken(n, 0.5);
  EXPECT_THROW(shape::OptimizeHexahedra(mesh, Fixed(Sides(Grid(n), n)), {},
                 shape::Progress([](double fraction) { return fraction < 0.3; })),
    shape::Aborted);
}
