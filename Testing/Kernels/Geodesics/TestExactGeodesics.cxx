#include "Base/Errors.h"
#include "Geodesics/ExactGeodesics.h"
#include "Mesh/Surface.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

using shapetest::ReadModel;

shape::ClosestPoints At(const shape::Mesh& mesh, const Eigen::RowVector3d& position)
{
  return shape::SurfaceLocator(mesh).Find(position);
}

/// Four triangles for each, in its plane: the same polyhedron. The points of `mesh` come first.
shape::Mesh Split(const shape::Mesh& mesh)
{
  std::map<std::pair<int, int>, int> midpoints;
  std::vector<Eigen::RowVector3d> positions;
  const int points = static_cast<int>(mesh.Points.rows());
  const auto middle = [&](int a, int b)
  {
    const auto [found, isNew] =
      midpoints.emplace(std::minmax(a, b), points + static_cast<int>(positions.size()));
    if (isNew)
    {
      positions.emplace_back(0.5 * (mesh.Points.row(a) + mesh.Points.row(b)));
    }
    return found->second;
  };
  shape::Mesh split;
  split.Triangles.resize(4 * mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const int a = mesh.Triangles(t, 0), b = mesh.Triangles(t, 1), c = mesh.Triangles(t, 2);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    split.Triangles.middleRows(4 * t, 4) << a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca;
  }
  split.Points.resize(points + static_cast<Eigen::Index>(positions.size()), 3);
  split.Points.topRows(points) = mesh.Points;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    split.Points.row(points + static_cast<Eigen::Index>(i)) = positions[i];
  }
  return split;
}

} // namespace

TEST(ExactGeodesics, AreStraightInThePlane)
{
  const shape::Mesh square = shapetest::FlatSquare(12, 0.3);
  for (const Eigen::RowVector3d& seed : { Eigen::RowVector3d(0.123, -0.345, 0.0),
         Eigen::RowVector3d(1.0, 0.05, 0.0), Eigen::RowVector3d(square.Points.row(70)) })
  {
    const Eigen::VectorXd distances = shape::ComputeExactGeodesics(square, At(square, seed));
    const Eigen::VectorXd straight = (square.Points.rowwise() - seed).rowwise().norm();
    EXPECT_LT((distances - straight).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(ExactGeodesics, TurnOnTheBorder)
{
  // An L: from the end of one arm to that of the other by way of the inner corner.
  shape::Mesh bent = shapetest::FlatSquare(16, 0.0);
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(bent.Triangles.rows()); ++t)
  {
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
    {
      centre += bent.Points.row(bent.Triangles(t, k)) / 3.0;
    }
    if (centre(0) < 0.0 || centre(1) < 0.0)
    {
      kept.push_back(t);
    }
  }
  bent.Triangles = bent.Triangles(kept, Eigen::all).eval();
  const Eigen::VectorXd distances =
    shape::ComputeExactGeodesics(bent, At(bent, Eigen::RowVector3d(1.0, -0.25, 0.0)));
  const double corner = std::hypot(1.0, 0.25);
  int beyond = 0;
  for (int point = 0; point < static_cast<int>(bent.Points.rows()); ++point)
  {
    const double x = bent.Points(point, 0), y = bent.Points(point, 1);
    if (x > 0.0 && y > 0.0)
    {
      EXPECT_TRUE(std::isinf(distances(point))) << "no triangle is left there";
    }
    else if (y > -0.25 * x && x <= 0.0)
    {
      EXPECT_NEAR(distances(point), corner + std::hypot(x, y), 1e-12);
      ++beyond;
    }
  }
  EXPECT_GT(beyond, 60);
}

TEST(ExactGeodesics, OfABoxAreThoseOfItsUnfoldings)
{
  // The spider and the fly in the 30 by 12 by 12 room: 40, across five of its six walls.
  shape::Mesh room = shapetest::Prism({ { 0, 0 }, { 30, 0 }, { 30, 12 }, { 0, 12 } });
  room.Points.col(2) *= 12.0;
  const shape::Mesh split = Split(Split(room));
  const Eigen::RowVector3d spider(0.0, 6.0, 11.0), fly(30.0, 6.0, 1.0);
  shape::Mesh walls = split;
  const shape::ClosestPoints at = At(walls, fly);
  // The fly as a point of the walls: its triangle in three.
  const int triangle = at.Triangles(0), point = static_cast<int>(walls.Points.rows());
  walls.Points.conservativeResize(point + 1, 3);
  walls.Points.row(point) = fly;
  const Eigen::RowVector3i corners = walls.Triangles.row(triangle);
  const Eigen::Index last = walls.Triangles.rows();
  walls.Triangles.conservativeResize(last + 2, 3);
  walls.Triangles.row(triangle) << corners(0), corners(1), point;
  walls.Triangles.row(last) << corners(1), corners(2), point;
  walls.Triangles.row(last + 1) << corners(2), corners(0), point;
  EXPECT_NEAR(shape::ComputeExactGeodesics(walls, At(walls, spider))(point), 40.0, 1e-10);
}

TEST(ExactGeodesics, DoNotDependOnHowThePolyhedronIsCutIntoTriangles)
{
  for (const char* name : { "elephant", "anchor", "hand" })
  {
    SCOPED_TRACE(name);
    const shape::Mesh mesh = ReadModel(name), split = Split(mesh);
    const Eigen::RowVector3d seed = mesh.Points.row(17);
    const Eigen::VectorXd distances = shape::ComputeExactGeodesics(mesh, At(mesh, seed)),
                          finer = shape::ComputeExactGeodesics(split, At(split, seed));
    EXPECT_GT(distances.maxCoeff(), 0.0);
    EXPECT_LT((distances - finer.head(distances.size())).cwiseAbs().maxCoeff(),
      1e-9 * distances.maxCoeff());
  }
}

TEST(ExactGeodesics, AreTheSameThereAndBack)
{
  const shape::Mesh mesh = ReadModel("elephant");
  for (const auto& [a, b] : { std::pair(3, 1000), std::pair(500, 2000), std::pair(77, 1500) })
  {
    const double there = shape::ComputeExactGeodesics(mesh, At(mesh, mesh.Points.row(a)))(b),
                 back = shape::ComputeExactGeodesics(mesh, At(mesh, mesh.Points.row(b)))(a);
    EXPECT_NEAR(there, back, 1e-10 * there);
    EXPECT_GE(there, (mesh.Points.row(a) - mesh.Points.row(b)).norm());
  }
}

TEST(ExactGeodesics, BetweenPlacesAreThoseFromThem)
{
  shape::Mesh half = ReadModel("elephant"); // open, so that paths turn on a border, too
  half.Triangles = half.Triangles.topRows(half.Triangles.rows() / 2).eval();
  half = shape::SplitComponents(half).front();
  for (const shape::Mesh& mesh : { ReadModel("hand"), ReadModel("elk"), half })
  {
    const int count = 40;
    const shape::ClosestPoints positions =
      shape::SurfaceLocator(mesh).Find(shape::SampleRandomly(mesh, count, 3));
    Eigen::VectorXi points = Eigen::VectorXi::LinSpaced(count, 0, 1000);
    const shape::SurfacePoints corners = shape::MakeSurfacePointsAtVertices(points, mesh);
    const Eigen::VectorXd there = shape::ComputeExactGeodesicsBetween(mesh, positions, corners),
                          back = shape::ComputeExactGeodesicsBetween(mesh, corners, positions);
    for (int i = 0; i < count; ++i)
    {
      shape::ClosestPoints seed;
      seed.Triangles = positions.Triangles.row(i);
      seed.Barycentrics = positions.Barycentrics.row(i);
      const double wanted = shape::ComputeExactGeodesics(mesh, seed)(points(i));
      EXPECT_NEAR(there(i), wanted, 1e-10 * wanted);
      EXPECT_NEAR(back(i), wanted, 1e-10 * wanted);
    }
    EXPECT_EQ(
      shape::ComputeExactGeodesicsBetween(mesh, positions, positions).cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST(ExactGeodesics, BetweenComponentsAreInfinite)
{
  const shape::Mesh one = shapetest::Icosphere(1), two = shapetest::Twice(one, { 3, 0, 0 });
  const shape::SurfacePoints from = shape::MakeSurfacePointsAtVertices(Eigen::Vector2i(0, 1), two),
                             to = shape::MakeSurfacePointsAtVertices(
                               Eigen::Vector2i(static_cast<int>(one.Points.rows()), 1), two);
  const Eigen::VectorXd distances = shape::ComputeExactGeodesicsBetween(two, from, to);
  EXPECT_TRUE(std::isinf(distances(0)));
  EXPECT_EQ(distances(1), 0.0);
}

TEST(ExactGeodesics, CanBeAborted)
{
  const shape::Mesh mesh = ReadModel("elephant");
  EXPECT_THROW(shape::ComputeExactGeodesics(
                 mesh, At(mesh, mesh.Points.row(0)), shape::Progress([](double) { return false; })),
    shape::Aborted);
  const shape::SurfacePoints ends =
    shape::MakeSurfacePointsAtVertices(Eigen::Vector2i(0, 1000), mesh);
  EXPECT_THROW(shape::ComputeExactGeodesicsBetween(
                 mesh, ends, ends, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
