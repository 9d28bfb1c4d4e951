#include "Base/Errors.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace
{

using shapetest::ReadModel;

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// FlatSquare with each place moved: (x, y) in [-1, 1]^2 to anywhere in space.
shape::Mesh Bent(int cells, const std::function<RowVector3d(double, double)>& bend)
{
  shape::Mesh mesh = shapetest::FlatSquare(cells, 0.2);
  for (auto point : mesh.Points.rowwise())
  {
    point = bend(point(0), point(1));
  }
  return mesh;
}

/// The largest distance between the patch's places and what `expected` says of its points.
double LargestError(const shape::Mesh& mesh, const shape::ExponentialPatch& patch,
  const std::function<RowVector2d(const RowVector3d&)>& expected)
{
  double largest = 0.0;
  for (std::size_t row = 0; row < patch.Points.size(); ++row)
  {
    const RowVector2d position = patch.Positions.row(static_cast<Eigen::Index>(row));
    largest = std::max(largest, (position - expected(mesh.Points.row(patch.Points[row]))).norm());
  }
  return largest;
}

std::vector<int> Untorn(const shape::ExponentialPatch& patch)
{
  std::vector<int> flipped;
  std::set_difference(patch.Flipped.begin(), patch.Flipped.end(), patch.Torn.begin(),
    patch.Torn.end(), std::back_inserter(flipped));
  return flipped;
}

/// That all of `patch` is the beginning of `larger`, bit for bit.
void ExpectPrefix(const shape::ExponentialPatch& patch, const shape::ExponentialPatch& larger)
{
  const auto k = static_cast<Eigen::Index>(patch.Points.size());
  const auto t = static_cast<Eigen::Index>(patch.Triangles.size());
  ASSERT_LE(patch.Points.size(), larger.Points.size());
  ASSERT_LE(patch.Triangles.size(), larger.Triangles.size());
  EXPECT_TRUE(std::equal(patch.Points.begin(), patch.Points.end(), larger.Points.begin()));
  EXPECT_TRUE(std::equal(patch.Triangles.begin(), patch.Triangles.end(), larger.Triangles.begin()));
  EXPECT_EQ(patch.Positions, larger.Positions.topRows(k));
  EXPECT_EQ(patch.Distances, larger.Distances.head(k));
  EXPECT_EQ(patch.Corners, larger.Corners.topRows(t));
}

} // namespace

TEST(ExponentialMap, LaysAPlaneOutAsItIs)
{
  const shape::Mesh mesh = shapetest::FlatSquare(30, 0.3);
  shape::ExponentialMap map(mesh);
  for (const RowVector3d& seed : { RowVector3d(0.11, -0.07, 0.0), RowVector3d(-0.6, 0.55, 0.3) })
  {
    const shape::ExponentialPatch patch = map.Around(seed, 0.5);
    EXPECT_GT(patch.Points.size(), 150U);
    const RowVector2d origin = seed.head(2);
    EXPECT_LT(LargestError(mesh, patch,
                [&](const RowVector3d& point) -> RowVector2d { return point.head(2) - origin; }),
      1e-14);
    // Distances are those of straight ways, and every point that near is in the patch.
    EXPECT_LT((patch.Distances - patch.Positions.rowwise().norm()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LE(patch.Distances.maxCoeff(), 0.5);
    const auto near =
      ((mesh.Points.leftCols(2).rowwise() - origin).rowwise().norm().array() <= 0.48).count();
    EXPECT_GE(static_cast<Eigen::Index>(patch.Points.size()), near);
    EXPECT_TRUE(patch.Flipped.empty());
    EXPECT_TRUE(patch.Torn.empty());
  }
}

TEST(ExponentialMap, UnrollsACylinder)
{
  // The patch's x axis goes around: (1, 0, 0) at the seed (0, 0, 1).
  const auto error = [](int cells)
  {
    const shape::Mesh mesh = Bent(cells,
      [](double x, double y) { return RowVector3d(std::sin(2.0 * x), y, std::cos(2.0 * x)); });
    shape::ExponentialMap map(mesh, { true, 0 });
    const shape::ExponentialPatch patch = map.Around(RowVector3d(0, 0, 1), 0.95, { 1, 0, 0 });
    EXPECT_TRUE(patch.Flipped.empty());
    return LargestError(mesh, patch,
      [](const RowVector3d& point)
      { return RowVector2d(std::atan2(point(0), point(2)), point(1)); });
  };
  EXPECT_LT(error(20), 2e-2);
  EXPECT_LT(error(40), 0.5 * error(20));
  EXPECT_LT(error(80), 0.5 * error(40));
}

TEST(ExponentialMap, UnrollsACone)
{
  // Half as steep as wide: unrolled, angles about the apex shrink by the sine of its half angle.
  const double sine = std::sin(M_PI / 6.0), cosine = std::cos(M_PI / 6.0);
  const auto error = [&](int cells)
  {
    const shape::Mesh mesh = Bent(cells,
      [&](double x, double y)
      {
        const double way = 2.0 + y;
        return RowVector3d(
          way * sine * std::sin(2.5 * x), -way * cosine, way * sine * std::cos(2.5 * x));
      });
    shape::ExponentialMap map(mesh, { true, 0 });
    const shape::ExponentialPatch patch =
      map.Around(RowVector3d(0, -2.0 * cosine, 2.0 * sine), 0.95, { 1, 0, 0 });
    EXPECT_TRUE(patch.Flipped.empty());
    return LargestError(mesh, patch,
      [&](const RowVector3d& point)
      {
        const double way = point.norm(), angle = sine * std::atan2(point(0), point(2));
        return RowVector2d(way * std::sin(angle), way * std::cos(angle) - 2.0);
      });
  };
  EXPECT_LT(error(20), 2e-2);
  EXPECT_LT(error(80), 0.35 * error(20));
}

TEST(ExponentialMap, OfASphereKeepsDistancesAndDirections)
{
  const auto errors = [](int level)
  {
    const shape::Mesh mesh = shapetest::Icosphere(level);
    const RowVector3d normal = RowVector3d(0.3, -0.5, 0.8).normalized();
    shape::ExponentialMap map(mesh, { true, 0 });
    const shape::ExponentialPatch patch = map.Around(normal, 1.2);
    EXPECT_TRUE(patch.Flipped.empty());
    EXPECT_TRUE(patch.Torn.empty());
    double distance = 0.0, position = 0.0;
    for (std::size_t row = 0; row < patch.Points.size(); ++row)
    {
      const RowVector3d point = mesh.Points.row(patch.Points[row]);
      const double angle = std::acos(std::min(1.0, point.dot(normal)));
      const RowVector2d flat(point.dot(patch.Seed.XAxis), point.dot(patch.Seed.YAxis));
      const auto i = static_cast<Eigen::Index>(row);
      distance = std::max(distance, std::abs(patch.Distances(i) - angle));
      position = std::max(
        position, (patch.Positions.row(i) - angle / std::max(1e-9, flat.norm()) * flat).norm());
    }
    return std::make_pair(distance, position);
  };
  const auto coarse = errors(3), fine = errors(5);
  EXPECT_LT(coarse.first, 0.03);
  EXPECT_LT(fine.first, 0.3 * coarse.first);
  EXPECT_LT(coarse.second, 0.06);
  EXPECT_LT(fine.second, 0.4 * coarse.second);
}

TEST(ExponentialMap, TurnsWithTheSurface)
{
  const shape::Mesh mesh = ReadModel("elephant");
  const RowVector3d seed = mesh.Points.row(900), direction(0.2, 1.0, -0.4);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const RowVector3d shift(3.0, -1.0, 2.0);
  shape::Mesh moved = mesh;
  moved.Points = (mesh.Points * turn.transpose()).rowwise() + shift;
  const double radius = 0.12 * shape::ComputeBoxDiagonal(mesh.Points);
  const shape::ExponentialPatch one = shape::ExponentialMap(mesh).Around(seed, radius, direction);
  const shape::ExponentialPatch other = shape::ExponentialMap(moved).Around(
    RowVector3d(seed * turn.transpose() + shift), radius, direction * turn.transpose());
  EXPECT_EQ(one.Points, other.Points);
  EXPECT_LT((one.Positions - other.Positions).cwiseAbs().maxCoeff(), 1e-10 * radius);
  // The x axis is where the direction points, on the surface's side.
  EXPECT_LT(std::abs(one.Seed.XAxis.dot(one.Seed.Normal)), 1e-12);
  EXPECT_GT(one.Seed.XAxis.dot(direction), 0.0);
  EXPECT_LT(std::abs(one.Seed.YAxis.dot(direction)), 1e-12);
}

TEST(ExponentialMap, ALargerRadiusOnlyAdds)
{
  for (const char* name : { "bunny00", "elephant", "fandisk", "hand" })
  {
    SCOPED_TRACE(name);
    const shape::Mesh mesh = ReadModel(name);
    const double diagonal = shape::ComputeBoxDiagonal(mesh.Points);
    shape::ExponentialMap map(mesh);
    for (const int point : { 3, 1000 })
    {
      const RowVector3d seed = mesh.Points.row(point);
      const shape::ExponentialPatch small = map.Around(seed, 0.05 * diagonal);
      const shape::ExponentialPatch large = map.Around(seed, 0.15 * diagonal);
      const shape::ExponentialPatch all = map.Around(seed, 100.0 * diagonal);
      EXPECT_GT(large.Points.size(), small.Points.size());
      ExpectPrefix(small, large);
      ExpectPrefix(large, all);
      // What was in between leaves no trace.
      const shape::ExponentialPatch again = map.Around(seed, 0.05 * diagonal);
      ExpectPrefix(small, again);
      ExpectPrefix(again, small);
    }
  }
  // Many points at one distance.
  shape::ExponentialMap sphere(shapetest::Icosphere(4));
  const RowVector3d pole = sphere.Surface().Points().row(0);
  ExpectPrefix(sphere.Around(pole, 0.6), sphere.Around(pole, 1.0));
}

TEST(ExponentialMap, UpwindAveragingSparesFlips)
{
  const shape::Mesh mesh = ReadModel("bunny00");
  const double diagonal = shape::ComputeBoxDiagonal(mesh.Points);
  std::mt19937 random(1);
  const Eigen::MatrixXd seeds = shape::SampleRandomly(mesh, 60, 1);
  double rates[2];
  for (const bool average : { false, true })
  {
    shape::ExponentialMap map(mesh, { average, average ? 2 : 0 });
    double flipped = 0.0, triangles = 0.0;
    for (const auto& seed : seeds.rowwise())
    {
      const shape::ExponentialPatch patch = map.Around(RowVector3d(seed), 0.1 * diagonal);
      flipped += static_cast<double>(patch.Flipped.size());
      triangles += static_cast<double>(patch.Triangles.size());
    }
    rates[average ? 1 : 0] = flipped / triangles;
  }
  EXPECT_LT(rates[1], 0.15 * rates[0]);
  EXPECT_LT(rates[1], 0.002);
}

TEST(ExponentialMap, IsCutOpenWhereTheFrontMeetsItself)
{
  // A tube of circumference 2 pi: the patch goes all around it.
  const shape::Mesh tube = shapetest::Torus(20.0, 1.0, 400, 24);
  const shape::ExponentialPatch patch =
    shape::ExponentialMap(tube).Around(RowVector3d(21.0, 0, 0), 5.0, { 0, 0, 1 });
  EXPECT_FALSE(patch.Torn.empty());
  EXPECT_TRUE(Untorn(patch).empty());
  // The image is as wide as the tube is around, and no wider.
  EXPECT_NEAR(patch.Positions.col(0).maxCoeff(), M_PI, 0.25);
  EXPECT_NEAR(patch.Positions.col(0).minCoeff(), -M_PI, 0.25);
  EXPECT_GT(patch.Positions.col(1).maxCoeff(), 4.5);
  // Only those that have points on both sides of the cut are torn.
  for (const int row : patch.Torn)
  {
    const Eigen::Vector3d around = patch.Positions(patch.Corners.row(row), 0);
    EXPECT_GT(around.maxCoeff(), 2.3);
    EXPECT_LT(around.minCoeff(), -2.3);
  }
}

TEST(ExponentialMap, ChangesLittleWhereTheSeedDoes)
{
  const shape::Mesh mesh = shapetest::Icosphere(4);
  shape::ExponentialMap map(mesh);
  // Across triangles, edges and a point, in steps of a fiftieth of an edge.
  const RowVector3d from = mesh.Points.row(700), along = RowVector3d(0.1, 0.13, -0.2);
  const double step = 0.0015;
  shape::ExponentialPatch before = map.Around(from, 0.5, { 0, 0, 1 });
  for (int i = 1; i < 100; ++i)
  {
    const RowVector3d seed = (from + i * step * along.normalized()).normalized();
    const shape::ExponentialPatch patch = map.Around(seed, 0.5, { 0, 0, 1 });
    std::vector<int> rows(mesh.Points.rows(), -1);
    for (std::size_t row = 0; row < before.Points.size(); ++row)
    {
      rows[before.Points[row]] = static_cast<int>(row);
    }
    double largest = 0.0;
    for (std::size_t row = 0; row < patch.Points.size(); ++row)
    {
      if (rows[patch.Points[row]] >= 0)
      {
        const RowVector2d position = patch.Positions.row(static_cast<Eigen::Index>(row));
        largest =
          std::max(largest, (position - before.Positions.row(rows[patch.Points[row]])).norm());
      }
    }
    EXPECT_LT(largest, 2.5 * step);
    before = patch;
  }
}

TEST(ExponentialMap, TakesTheClosestPlaceAndSaysWhereTheRimIs)
{
  const shape::Mesh mesh = shapetest::FlatSquare(20, 0.0);
  shape::ExponentialMap map(mesh);
  const shape::ExponentialPatch far = map.Around(RowVector3d(0.3, 0.2, 7.0), 0.4);
  EXPECT_TRUE(far.Seed.Origin.isApprox(RowVector3d(0.3, 0.2, 0.0), 1e-12));
  EXPECT_FALSE(far.ReachesBoundary);
  EXPECT_TRUE(map.Around(RowVector3d(0.9, 0.2, 0.0), 0.4).ReachesBoundary);
  EXPECT_TRUE(
    map.Around(RowVector3d(5.0, 9.0, 0.0), 0.4).Seed.Origin.isApprox(RowVector3d(1, 1, 0), 1e-12));
  // Less than the nearest point: no points, and the frame.
  const shape::ExponentialPatch none = map.Around(RowVector3d(0.03, 0.01, 0.0), 1e-6);
  EXPECT_TRUE(none.Points.empty());
  EXPECT_TRUE(none.Triangles.empty());
  EXPECT_EQ(none.Seed.Normal, RowVector3d(0, 0, 1));
}

TEST(ExponentialMap, OfTrianglesThatDoNotHangTogetherIsTheSame)
{
  const shape::Mesh mesh = ReadModel("elephant");
  const Eigen::Index t = mesh.Triangles.rows();
  shape::Mesh soup{ Eigen::MatrixXd(3 * t, 3), Eigen::MatrixXi(t, 3) };
  for (int row = 0; row < t; ++row)
  {
    soup.Points.middleRows(3 * row, 3) = shape::GetCorners(mesh, row);
    soup.Triangles.row(row) << 3 * row, 3 * row + 1, 3 * row + 2;
  }
  const RowVector3d seed = mesh.Points.row(42);
  const double radius = 0.1 * shape::ComputeBoxDiagonal(mesh.Points);
  const shape::ExponentialPatch one = shape::ExponentialMap(mesh).Around(seed, radius);
  const shape::ExponentialPatch other = shape::ExponentialMap(soup).Around(seed, radius);
  std::vector<int> triangles[2] = { one.Triangles, other.Triangles };
  for (std::vector<int>& rows : triangles)
  {
    std::sort(rows.begin(), rows.end());
  }
  EXPECT_EQ(triangles[0], triangles[1]);
  EXPECT_EQ(one.Flipped.size(), other.Flipped.size());
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(mesh.Points.rows(), 2);
  for (std::size_t row = 0; row < one.Points.size(); ++row)
  {
    positions.row(one.Points[row]) = one.Positions.row(static_cast<Eigen::Index>(row));
  }
  for (std::size_t row = 0; row < other.Points.size(); ++row)
  {
    const int point = mesh.Triangles(other.Points[row] / 3, other.Points[row] % 3);
    EXPECT_LT((positions.row(point) - other.Positions.row(static_cast<Eigen::Index>(row))).norm(),
      1e-9 * radius);
  }
}

TEST(ExponentialMap, SeesNoPointsWithoutTriangles)
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  const RowVector3d seed(0.2, 0.3, 0.9);
  const shape::ExponentialPatch patch = shape::ExponentialMap(mesh).Around(seed, 1.0);
  const Eigen::Index n = mesh.Points.rows();
  mesh.Points.conservativeResize(n + 30, 3);
  mesh.Points.bottomRows(30) = 1.01 * shape::SampleRandomly(shapetest::Icosphere(2), 30, 1);
  const shape::ExponentialPatch beside = shape::ExponentialMap(mesh).Around(seed, 1.0);
  ExpectPrefix(patch, beside);
  ExpectPrefix(beside, patch);
}

TEST(ExponentialMap, IsDefinedOnSurfacesOfEveryKind)
{
  // A square with three sheets at one edge, a triangle without area, one with a point used twice,
  // a point that none uses, and a component of its own.
  shape::Mesh mesh = shapetest::FlatSquare(6, 0.0);
  const auto n = static_cast<int>(mesh.Points.rows());
  const Eigen::Index m = mesh.Triangles.rows();
  mesh.Points.conservativeResize(n + 6, 3);
  mesh.Points.bottomRows(6) << 0.1, 0.1, 0.7, 0.2, 0.2, 0.0, 9, 9, 9, 5, 0, 0, 6, 0, 0, 5, 1, 0;
  mesh.Triangles.conservativeResize(m + 4, 3);
  const Eigen::RowVector3i edge = mesh.Triangles.row(m / 2);
  mesh.Triangles.row(m) << edge(0), edge(1), n;
  mesh.Triangles.row(m + 1) << edge(1), edge(2), edge(2);
  mesh.Triangles.row(m + 2) << edge(0), edge(1), edge(0);
  mesh.Triangles.row(m + 3) << n + 3, n + 4, n + 5;
  shape::ExponentialMap map(mesh);
  for (const double radius : { 0.3, 2.0, 50.0 })
  {
    const shape::ExponentialPatch patch = map.Around(RowVector3d(0.02, 0.01, 0), radius);
    EXPECT_TRUE(patch.Positions.allFinite());
    EXPECT_TRUE(patch.Distances.allFinite());
    EXPECT_LT(*std::max_element(patch.Points.begin(), patch.Points.end()), n + 1);
  }
  const shape::ExponentialPatch apart = map.Around(RowVector3d(5.2, 0.2, 0), 10.0);
  EXPECT_EQ(apart.Triangles, std::vector<int>{ static_cast<int>(m + 3) });
  EXPECT_TRUE(apart.ReachesBoundary);
  // Where no triangle has an area.
  shape::Mesh line{ Eigen::MatrixXd::Zero(4, 3), Eigen::MatrixXi(2, 3) };
  line.Points.col(0) << 0, 1, 2, 3;
  line.Triangles << 0, 1, 2, 1, 2, 3;
  const shape::ExponentialPatch flat =
    shape::ExponentialMap(line).Around(RowVector3d(0.5, 0, 0), 2.0);
  EXPECT_TRUE(flat.Positions.allFinite());
  EXPECT_NEAR(flat.Positions.row(0).norm(), 0.5, 1e-12);
  EXPECT_TRUE(flat.Flipped.empty());
}

TEST(ExponentialMap, RefusesWhatItCannotUse)
{
  const shape::Mesh mesh = shapetest::Icosphere(1);
  shape::ExponentialMap map(mesh);
  const RowVector3d seed(0, 0, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    EXPECT_REFUSED(map.Around(seed, radius), "Radius is");
  }
  EXPECT_REFUSED(map.Around(RowVector3d(nan, 0, 0), 1.0), "the seed");
  EXPECT_REFUSED(map.Around(seed, 1.0, { 0, nan, 0 }), "x direction is not finite");
  EXPECT_REFUSED(map.Around(shape::ClosestPoint{}, 1.0), "the seed is not on the surface");
  EXPECT_REFUSED(shape::ExponentialMap(mesh, { true, -1 }), "NormalSmoothing is -1");
  EXPECT_REFUSED(
    shape::ExponentialMap(shape::Surface(mesh.Points, Eigen::MatrixXi(0, 3))), "has no triangles");
  shape::Mesh bad = mesh;
  bad.Triangles(3, 1) = 1000;
  EXPECT_THROW(shape::ExponentialMap{ bad }, shape::InvalidInput);
  bad = mesh;
  bad.Points(5, 2) = nan;
  EXPECT_THROW(shape::ExponentialMap{ bad }, shape::InvalidInput);
  EXPECT_THROW(
    map.Around(seed, 1.0, { 1, 0, 0 }, -1, shape::Progress([](double) { return false; })),
    shape::Aborted);
}

TEST(TangentFrame, TurnsWithoutAJump)
{
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const auto unit = [&]
  { return RowVector3d(normal(random), normal(random), normal(random)).normalized(); };
  for (int i = 0; i < 200; ++i)
  {
    const RowVector3d from = unit(), to = unit(), vector = unit();
    EXPECT_LT((shape::RotateBetweenNormals(from, from, to) - to).norm(), 1e-12);
    const RowVector3d turned = shape::RotateBetweenNormals(vector, from, to);
    EXPECT_NEAR(turned.norm(), 1.0, 1e-12);
    // The axis of the shortest turn is across both.
    EXPECT_NEAR(turned.dot(from.cross(to)), vector.dot(from.cross(to)), 1e-12);
    EXPECT_LT((shape::RotateBetweenNormals(from, from, -from) + from).norm(), 1e-12);

    const shape::TangentFrame frame = shape::BuildTangentFrame(vector, to);
    EXPECT_NEAR(frame.XAxis.norm(), 1.0, 1e-12);
    EXPECT_LT((frame.XAxis.cross(frame.YAxis) - to).norm(), 1e-12);
    const RowVector3d near = (to + 1e-4 * unit()).normalized();
    if (to(2) > -0.9)
    {
      EXPECT_LT((shape::BuildTangentFrame(vector, near).XAxis - frame.XAxis).norm(), 1e-2);
    }
    EXPECT_EQ(shape::BuildTangentFrame(vector, to, to).XAxis, frame.XAxis);
  }
  EXPECT_TRUE(
    shape::BuildTangentFrame({ 0, 0, 0 }, { 0, 0, -1 }).XAxis.isApprox(RowVector3d(1, 0, 0)));
}
