#include "Base/Errors.h"
#include "Geodesics/CreasePath.h"
#include "Geodesics/SurfaceLoop.h"
#include "Search/ClosestPoint.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using Eigen::RowVector3d;
using Eigen::RowVector3i;

/// The boundary of the unit cubes for which `isIn` holds, each square as two triangles.
template <typename IsIn>
shape::Mesh CubesOf(int size, const IsIn& isIn)
{
  std::map<std::array<int, 3>, int> numbers;
  std::vector<RowVector3i> triangles;
  const auto number = [&](const RowVector3i& at)
  {
    const auto next = static_cast<int>(numbers.size());
    return numbers.insert({ { at(0), at(1), at(2) }, next }).first->second;
  };
  for (int x = 0; x < size; ++x)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int z = 0; z < size; ++z)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          for (const int way : { 0, 1 })
          {
            const RowVector3i cube(x, y, z), step = RowVector3i::Unit(axis);
            if (!isIn(cube) || isIn(RowVector3i(cube + (2 * way - 1) * step)))
            {
              continue;
            }
            RowVector3i u = RowVector3i::Unit((axis + 1) % 3),
                        v = RowVector3i::Unit((axis + 2) % 3);
            if (way == 0)
            {
              std::swap(u, v);
            }
            const RowVector3i corner = cube + way * step;
            const int a = number(corner), b = number(corner + u), c = number(corner + u + v),
                      d = number(corner + v);
            triangles.emplace_back(a, b, c);
            triangles.emplace_back(a, c, d);
          }
        }
      }
    }
  }
  shape::Mesh mesh{ Eigen::MatrixXd(numbers.size(), 3), Eigen::MatrixXi(triangles.size(), 3) };
  for (const auto& [at, index] : numbers)
  {
    mesh.Points.row(index) << at[0], at[1], at[2];
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    mesh.Triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
  }
  return mesh;
}

/// A bar with a square section on a slab, 12 x 12 x 12 together. It stands on the square from Low
/// to High in the plane z = Top, whose sides are concave edges, divided into `cells` edges.
struct BarOnSlab
{
  explicit BarOnSlab(int cells)
    : Surface(CubesOf(3 * cells,
        [&](const RowVector3i& cube)
        {
          const auto isAmong = [&](int i, int low, int high)
          { return i >= low * cells && i < high * cells; };
          const bool isBar = isAmong(cube(0), 1, 2) && isAmong(cube(1), 1, 2);
          const bool isBox = isAmong(cube(0), 0, 3) && isAmong(cube(1), 0, 3);
          return isBox && (isAmong(cube(2), 0, 1) || (isBar && isAmong(cube(2), 1, 3)));
        }))
  {
    this->Surface.Points *= 4.0 / cells;
  }

  /// A point near each side of the square, at most `off` from it along the surface.
  Eigen::MatrixXd Clicks(double off, unsigned seed) const
  {
    std::mt19937 random(seed);
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    Eigen::MatrixXd clicks(4, 3);
    for (int side = 0; side < 4; ++side)
    {
      const Eigen::Vector2d out(side == 0 ? 1
          : side == 2                     ? -1
                                          : 0,
        side == 1     ? 1
          : side == 3 ? -1
                      : 0);
      const double along = 1.0 * (share() - 0.5), away = off * (0.5 + 0.5 * share());
      const bool isOnBar = share() < 0.5;
      const Eigen::Vector2d at = Eigen::Vector2d(6.0, 6.0) + (isOnBar ? 2.0 : 2.0 + away) * out +
        along * Eigen::Vector2d(-out(1), out(0));
      clicks.row(side) << at(0), at(1), isOnBar ? Top + away : Top;
    }
    return clicks;
  }

  static constexpr double Low = 4.0, High = 8.0, Top = 4.0;
  shape::Mesh Surface;
};

struct Traced
{
  Traced(
    const shape::Mesh& mesh, const Eigen::MatrixXd& clicks, const shape::CreaseOptions& options)
  {
    const shape::SurfaceLocator locator{ shape::Surface(mesh) };
    shape::SurfacePaths paths(locator.GetSurface());
    this->Loop = shape::TraceLoopThrough(clicks, locator, paths, options);
    const std::size_t count = this->Loop.Positions.size();
    for (const shape::SurfacePoint& position : this->Loop.Positions)
    {
      this->Positions.push_back(shape::GetPosition(mesh, position));
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Length += (this->Positions[(i + 1) % count] - this->Positions[i]).norm();
    }
  }

  shape::SurfaceLoop Loop;
  std::vector<RowVector3d> Positions;
  double Length = 0.0;
};

shape::CreaseOptions Following(double weight, double reach = 0.25)
{
  shape::CreaseOptions options;
  options.CreaseWeight = weight;
  options.CreaseReach = reach;
  return options;
}

/// The distance of a position from the square on which the bar stands.
double DistanceFromSquare(const RowVector3d& position)
{
  const Eigen::Array2d outside =
    (position.head<2>().array().transpose() - 6.0).abs() - 2.0; // of the half plane of each side
  const double inPlane =
    outside.maxCoeff() > 0.0 ? outside.cwiseMax(0.0).matrix().norm() : -outside.maxCoeff();
  return std::hypot(inPlane, position(2) - BarOnSlab::Top);
}

/// The same surface with its points and triangles in another order.
shape::Mesh Renumbered(const shape::Mesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<int> points(mesh.Points.rows()), triangles(mesh.Triangles.rows());
  std::iota(points.begin(), points.end(), 0);
  std::iota(triangles.begin(), triangles.end(), 0);
  std::shuffle(points.begin(), points.end(), random);
  std::shuffle(triangles.begin(), triangles.end(), random);
  shape::Mesh other{ Eigen::MatrixXd(mesh.Points.rows(), 3), mesh.Triangles };
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    other.Points.row(points[i]) = mesh.Points.row(i);
  }
  for (Eigen::Index i = 0; i < mesh.Triangles.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      other.Triangles(i, k) = points[mesh.Triangles(triangles[i], (k + triangles[i]) % 3)];
    }
  }
  return other;
}

/// Two half planes at a right angle, with the crease on the x axis from 0 to 4; `cells` edges are
/// on a length of 1.
shape::Mesh Fold(int cells)
{
  const int across = 4 * cells + 1, along = 2 * cells;
  shape::Mesh mesh{ Eigen::MatrixXd(across * (along + 1), 3),
    Eigen::MatrixXi(2 * (across - 1) * along, 3) };
  Eigen::Index row = 0;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      const double y = static_cast<double>(j) / cells - 1.0;
      mesh.Points.row(j * across + i) << static_cast<double>(i) / cells, std::max(y, 0.0),
        std::max(-y, 0.0);
      if (i + 1 < across && j < along)
      {
        const int a = j * across + i;
        mesh.Triangles.row(row++) << a, a + 1, a + across + 1;
        mesh.Triangles.row(row++) << a, a + across + 1, a + across;
      }
    }
  }
  return mesh;
}

/// The cost of a path, measured by the dihedral angles of the surface.
double CostOf(const shape::Mesh& mesh, const shape::SurfacePath& path, double weight)
{
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < path.Positions.size(); ++i)
  {
    const shape::PointSupport a(mesh, path.Positions[i]), b(mesh, path.Positions[i + 1]);
    const Eigen::RowVector3i own = mesh.Triangles.row(path.Triangles[i]);
    EXPECT_TRUE(a.IsIn(own) && b.IsIn(own));
    double angle = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int from = own(k), to = own((k + 1) % 3);
      for (int t = 0; a.IsOn(from, to) && b.IsOn(from, to) && t < mesh.Triangles.rows(); ++t)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          if (mesh.Triangles(t, corner) == to && mesh.Triangles(t, (corner + 1) % 3) == from)
          {
            const auto normal = [&](int triangle) -> RowVector3d
            {
              const Eigen::Matrix3d at = shape::GetCorners(mesh, triangle);
              return (at.row(1) - at.row(0)).cross(at.row(2) - at.row(0)).normalized();
            };
            const RowVector3d mine = normal(path.Triangles[i]);
            const double height =
              (mesh.Points.row(mesh.Triangles(t, (corner + 2) % 3)) - mesh.Points.row(from))
                .dot(mine);
            angle = height > 0.0 ? std::acos(std::clamp(mine.dot(normal(t)), -1.0, 1.0)) : 0.0;
          }
        }
      }
    }
    cost += (shape::GetPosition(mesh, path.Positions[i + 1]) -
              shape::GetPosition(mesh, path.Positions[i]))
              .norm() /
      (1.0 + weight * angle / (0.5 * M_PI));
  }
  return cost;
}

} // namespace

TEST(CreasePath, ALoopRunsAlongTheConcaveEdgesNextToItsPoints)
{
  // The points are at least 2.12 apart (sqrt(1.5^2 + 1.5^2)), so those up to 0.5 away move.
  for (const int cells : { 2, 3, 5 })
  {
    const BarOnSlab bar(cells);
    for (unsigned seed = 0; seed < 10; ++seed)
    {
      const Eigen::MatrixXd clicks = bar.Clicks(0.5, seed);
      const Traced along(bar.Surface, clicks, Following(10.0));
      EXPECT_NEAR(along.Length, 16.0, 1e-12);
      for (const RowVector3d& position : along.Positions)
      {
        EXPECT_LT(DistanceFromSquare(position), 1e-14);
      }
      // The shortest paths run through the points, beside the edges.
      const Traced shortest(bar.Surface, clicks, {});
      double farthest = 0.0;
      for (const RowVector3d& position : shortest.Positions)
      {
        farthest = std::max(farthest, DistanceFromSquare(position));
      }
      EXPECT_GT(farthest, 0.24);
    }
  }
}

TEST(CreasePath, PointsBeyondTheReachStayOnTheLoop)
{
  const BarOnSlab bar(4);
  const Eigen::MatrixXd clicks = bar.Clicks(0.5, 1);
  const Traced along(bar.Surface, clicks, Following(10.0, 0.0));
  for (const auto& click : clicks.rowwise())
  {
    double nearest = 1.0;
    for (const RowVector3d& position : along.Positions)
    {
      nearest = std::min(nearest, (position - click).norm());
    }
    EXPECT_LT(nearest, 1e-12);
  }
  // Between them it runs along the edges: most of the square is on it.
  double on = 0.0;
  for (std::size_t i = 0; i < along.Positions.size(); ++i)
  {
    const RowVector3d &a = along.Positions[i],
                      &b = along.Positions[(i + 1) % along.Positions.size()];
    on += DistanceFromSquare(a) < 1e-14 && DistanceFromSquare(b) < 1e-14 ? (b - a).norm() : 0.0;
  }
  EXPECT_GT(on, 10.0);
}

TEST(CreasePath, WithoutWeightPathsAreTheShortestBitForBit)
{
  const BarOnSlab bar(4);
  const Eigen::MatrixXd clicks = bar.Clicks(0.5, 3);
  const Traced traced(bar.Surface, clicks, Following(0.0));
  const shape::SurfaceLocator locator{ shape::Surface(bar.Surface) };
  shape::SurfacePaths paths(locator.GetSurface());
  std::vector<RowVector3d> wanted;
  for (int i = 0; i < 4; ++i)
  {
    const shape::SurfacePath leg =
      paths.Find(locator.FindOne(clicks.row(i)), locator.FindOne(clicks.row((i + 1) % 4)));
    for (std::size_t k = 0; k + 1 < leg.Positions.size(); ++k)
    {
      wanted.push_back(shape::GetPosition(bar.Surface, leg.Positions[k]));
    }
  }
  EXPECT_EQ(traced.Positions, wanted);
}

TEST(CreasePath, ItIsNeverMoreCostlyThanTheShortest)
{
  // Random pairs on a surface with many weak creases: the cost is the one measured here.
  shape::Mesh mesh = shapetest::Icosphere(3);
  for (auto point : mesh.Points.rowwise())
  {
    point *= 1.0 + 0.2 * std::sin(7.0 * point(0)) * std::cos(5.0 * point(1));
  }
  const shape::Surface surface(mesh);
  shape::SurfacePaths paths(surface);
  std::mt19937 random(5);
  int better = 0;
  for (const double weight : { 0.0, 1.0, 20.0 })
  {
    shape::CreasePaths creases(surface, paths, Following(weight));
    for (int i = 0; i < 40; ++i)
    {
      const auto end = [&]
      {
        const double a = 0.1 + 0.3 * (random() % 3), b = 0.2;
        return shape::SurfacePoint{ static_cast<int>(random() % mesh.Triangles.rows()),
          { a, b, 1.0 - a - b } };
      };
      const shape::SurfacePoint from = end(), to = end();
      const shape::SurfacePath shortest = paths.Find(from, to), path = creases.Find(from, to);
      EXPECT_LE(CostOf(mesh, path, weight), CostOf(mesh, shortest, 0.0) * (1.0 + 1e-12));
      EXPECT_NEAR(path.Length, CostOf(mesh, path, 0.0), 1e-12);
      better += CostOf(mesh, path, weight) < 0.99 * shortest.Length;
    }
  }
  EXPECT_GT(better, 30);
}

TEST(CreasePath, ItIsRefractedAtACrease)
{
  // Two points at a height a beside a concave crease of a right angle, L apart. The cheapest path
  // leaves the crease at the angle whose cosine is c = 1 / (1 + weight), as light does, and costs
  // c L + 2 a sqrt(1 - c^2). Off the crease the path is straight, so only the point where it meets
  // the crease is rounded to an edge of length h: the error is of second order.
  constexpr double a = 0.5, length = 3.0, weight = 1.0, c = 1.0 / (1.0 + weight);
  const double exact = c * length + 2.0 * a * std::sqrt(1.0 - c * c);
  for (const int cells : { 4, 8, 16 })
  {
    const shape::Mesh fold = Fold(cells);
    const shape::Surface surface(fold);
    const shape::SurfaceLocator locator(surface);
    shape::SurfacePaths paths(surface);
    shape::CreasePaths creases(surface, paths, Following(weight));
    const double cost = CostOf(fold,
      creases.Find(locator.FindOne({ 0.5, a, 0.0 }), locator.FindOne({ 0.5 + length, a, 0.0 })),
      weight);
    // Half the second derivative of c x + sqrt(a^2 + (x0 - x)^2), twice, for a step of h / 2.
    const double h = 1.0 / cells, slant = a / std::sqrt(1.0 - c * c);
    EXPECT_GT(cost, exact - 1e-12);
    EXPECT_LT(cost, exact + a * a / (slant * slant * slant) * h * h);
  }
}

TEST(CreasePath, SizeAndNumberingChangeNothing)
{
  const BarOnSlab bar(3);
  const Eigen::MatrixXd clicks = bar.Clicks(0.9, 7);
  for (const double reach : { 0.0, 0.25 })
  {
    const Traced own(bar.Surface, clicks, Following(4.0, reach));
    shape::Mesh large = bar.Surface;
    large.Points *= 1024.0; // a power of two, so nothing is rounded
    const Traced scaled(large, 1024.0 * clicks, Following(4.0, reach));
    ASSERT_EQ(scaled.Positions.size(), own.Positions.size());
    for (std::size_t i = 0; i < own.Positions.size(); ++i)
    {
      EXPECT_EQ(scaled.Positions[i], 1024.0 * own.Positions[i]);
    }
    for (unsigned seed = 0; seed < 5; ++seed)
    {
      const Traced other(Renumbered(bar.Surface, seed), clicks, Following(4.0, reach));
      EXPECT_NEAR(other.Length, own.Length, 1e-12 * own.Length);
    }
  }
}

TEST(CreasePath, ConvexCreases)
{
  // Around the top of the bar, which is the square at z = 12.
  const BarOnSlab bar(3);
  Eigen::MatrixXd clicks = bar.Clicks(0.5, 2);
  for (auto click : clicks.rowwise())
  {
    click(2) = click(2) > BarOnSlab::Top ? 12.0 - (click(2) - BarOnSlab::Top) : 12.0;
    for (const int axis : { 0, 1 })
    {
      // Points on the slab, beside the square, become points on the top, inside it.
      const double out = click(axis) - 6.0;
      click(axis) =
        std::abs(out) > 2.0 ? 6.0 + std::copysign(4.0 - std::abs(out), out) : click(axis);
    }
  }
  for (const auto kind :
    { shape::CreaseOptions::CreasesType::Convex, shape::CreaseOptions::CreasesType::Both })
  {
    shape::CreaseOptions options = Following(10.0);
    options.Creases = kind;
    EXPECT_NEAR(Traced(bar.Surface, clicks, options).Length, 16.0, 1e-12);
  }
  const double shortest = Traced(bar.Surface, clicks, {}).Length;
  EXPECT_LT(shortest, 15.9);
  // There is no concave edge there.
  EXPECT_EQ(Traced(bar.Surface, clicks, Following(10.0)).Length, shortest);
}

TEST(CreasePath, WrongOptionsAreNamed)
{
  const BarOnSlab bar(2);
  const Eigen::MatrixXd clicks = bar.Clicks(0.5, 1);
  EXPECT_REFUSED(Traced(bar.Surface, clicks, Following(-1.0)), "CreaseWeight is -1");
  EXPECT_REFUSED(Traced(bar.Surface, clicks, Following(std::nan(""))), "CreaseWeight is nan");
  EXPECT_REFUSED(Traced(bar.Surface, clicks, Following(1.0, 0.6)), "CreaseReach is 0.6");
}
