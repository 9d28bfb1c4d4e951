#include "Base/Errors.h"
#include "Geodesics/ExactGeodesics.h"
#include "Geodesics/SurfacePath.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/SurfacePoints.h"
#include "Support/SimpleSurfaces.h"
#include "Support/SurfacePathChecks.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using shapetest::ExpectPath;
using shapetest::PositionOf;

/// The place at a point.
shape::SurfacePoint AtPoint(const shape::Mesh& mesh, int point)
{
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    if ((corners.array() == point).any())
    {
      return { t, (corners.array() == point).cast<double>() };
    }
  }
  return {};
}

/// Inside a triangle, at one of its corners, or on one of its edges.
shape::SurfacePoint RandomPosition(const shape::Mesh& mesh, std::mt19937& random)
{
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  shape::SurfacePoint position{ static_cast<int>(random() % mesh.Triangles.rows()), {} };
  const double a = share(), b = (1.0 - a) * share();
  switch (random() % 3)
  {
    case 0:
      position.Barycentric << 0, 1, 0;
      break;
    case 1:
      position.Barycentric << a, 0, 1.0 - a;
      break;
    default:
      position.Barycentric << 1.0 - a - b, a, b;
  }
  return position;
}

/// The lesser of the angles at a point between a path's places before and after it, each in a
/// triangle around it; infinite on the border.
double LesserAngle(const shape::Mesh& mesh, const std::vector<int>& twins,
  const shape::SurfacePath& path, std::size_t at)
{
  Eigen::Index corner = 0;
  path.Positions[at].Barycentric.maxCoeff(&corner);
  const int point = mesh.Triangles(path.Positions[at].Triangle, corner);
  const auto angle = [](const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
  { return std::atan2(a.cross(b).norm(), a.dot(b)); };
  const Eigen::RowVector3d position = mesh.Points.row(point);
  double total = 0.0;
  std::vector<double> directions; // counted around the point, of the path before and after it
  const int first = 3 * path.Positions[at].Triangle + static_cast<int>(corner);
  int side = first;
  do
  {
    const int t = side / 3;
    const Eigen::RowVector3d a =
      mesh.Points.row(mesh.Triangles(t, shape::NextHalfEdge(side) % 3)) - position;
    const Eigen::RowVector3d b =
      mesh.Points.row(mesh.Triangles(t, shape::PreviousHalfEdge(side) % 3)) - position;
    for (const std::size_t stretch : { at - 1, at })
    {
      const std::size_t other = stretch == at ? at + 1 : at - 1;
      if (path.Triangles[stretch] == t)
      {
        directions.push_back(total + angle(a, PositionOf(mesh, path.Positions[other]) - position));
      }
    }
    total += angle(a, b);
    side = twins[shape::PreviousHalfEdge(side)];
  } while (side >= 0 && side != first);
  if (side < 0 || directions.size() != 2)
  {
    return INFINITY;
  }
  const double between = std::abs(directions[1] - directions[0]);
  return std::min(between, total - between);
}

} // namespace

TEST(SurfacePath, IsStraightInThePlane)
{
  const shape::Mesh plane = shapetest::FlatSquare(40, 0.3);
  shape::SurfacePaths paths(plane);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i)
  {
    const shape::SurfacePoint from = RandomPosition(plane, random),
                              to = RandomPosition(plane, random);
    const shape::SurfacePath path = paths.Find(from, to);
    ExpectPath(plane, path);
    EXPECT_NEAR(path.Length, (PositionOf(plane, to) - PositionOf(plane, from)).norm(), 1e-13);
    EXPECT_EQ(path.Triangles, shape::SurfacePaths(plane).Find(from, to).Triangles);
  }
  // All but one stretch of a way along edges is left out.
  const shape::Mesh grid = shapetest::FlatSquare(10, 0.0);
  const auto pointAt = [&](double x, double y)
  {
    Eigen::Index point = 0;
    (grid.Points.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&point);
    return AtPoint(grid, static_cast<int>(point));
  };
  const shape::SurfacePath along =
    shape::SurfacePaths(grid).Find(pointAt(-1.0, 0.2), pointAt(1.0, 0.2));
  ExpectPath(grid, along);
  EXPECT_NEAR(along.Length, 2.0, 1e-14);
}

TEST(SurfacePath, OverACubeIsThatOfItsNet)
{
  shape::Mesh cube = shapetest::Prism({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  shape::SurfacePaths paths(cube);
  Eigen::Index low = 0, high = 0;
  cube.Points.rowwise().sum().minCoeff(&low);
  cube.Points.rowwise().sum().maxCoeff(&high);
  const shape::SurfacePath path =
    paths.Find(AtPoint(cube, static_cast<int>(low)), AtPoint(cube, static_cast<int>(high)));
  ExpectPath(cube, path);
  EXPECT_NEAR(path.Length, std::sqrt(5.0), 1e-14);
}

TEST(SurfacePath, TurnsAtTheCornerOfABorder)
{
  // Half of a plate of holes: an L, from one of its ends to the other.
  shape::Mesh corner = shapetest::FlatSquare(20, 0.0);
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(corner.Triangles.rows()); ++t)
  {
    const Eigen::RowVector3d middle = shape::GetCorners(corner, t).colwise().mean();
    if (middle(0) < 0.0 || middle(1) < 0.0)
    {
      kept.push_back(t);
    }
  }
  corner.Triangles = corner.Triangles(kept, Eigen::all).eval();
  const auto pointAt = [&](double x, double y)
  {
    Eigen::Index point = 0;
    (corner.Points.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&point);
    return AtPoint(corner, static_cast<int>(point));
  };
  const shape::SurfacePath path =
    shape::SurfacePaths(corner).Find(pointAt(1.0, -0.5), pointAt(-0.5, 1.0));
  ExpectPath(corner, path);
  EXPECT_NEAR(path.Length, 2.0 * std::hypot(1.0, 0.5), 1e-14);
}

TEST(SurfacePath, IsLocallyShortestOnModels)
{
  int turns = 0;
  for (const char* name : { "bear", "fandisk", "joint", "elephant" })
  {
    const shape::Mesh mesh = shapetest::ReadModel(name);
    shape::SurfacePaths paths(mesh);
    std::mt19937 random(2);
    constexpr int count = 40;
    shape::SurfacePoints from{ Eigen::VectorXi(count), Eigen::MatrixXd(count, 3) }, to = from;
    Eigen::VectorXd lengths(count);
    for (int i = 0; i < count; ++i)
    {
      const shape::SurfacePoint a = RandomPosition(mesh, random), b = RandomPosition(mesh, random);
      from.Triangles(i) = a.Triangle;
      from.Barycentrics.row(i) = a.Barycentric;
      to.Triangles(i) = b.Triangle;
      to.Barycentrics.row(i) = b.Barycentric;
      const shape::SurfacePath path = paths.Find(a, b);
      ExpectPath(mesh, path);
      lengths(i) = path.Length;
      for (std::size_t at = 1; at + 1 < path.Positions.size(); ++at)
      {
        if (path.Positions[at].Barycentric.maxCoeff() == 1.0)
        {
          EXPECT_GE(LesserAngle(mesh, paths.Twins(), path, at), M_PI - 1e-8) << name;
          ++turns;
        }
      }
    }
    const Eigen::ArrayXd ratios =
      lengths.array() / shape::ComputeExactGeodesicsBetween(mesh, from, to).array();
    EXPECT_GT(ratios.minCoeff(), 1.0 - 1e-9) << name;
    EXPECT_LT(ratios.mean(), 1.002) << name;
    EXPECT_LT(ratios.maxCoeff(), 1.1) << name;
  }
  EXPECT_GT(turns, 100) << "paths turn at points";
}

TEST(SurfacePath, WithinATriangleAndAlongAnEdge)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::SurfacePaths paths(sphere);
  const shape::SurfacePath inside =
    paths.Find({ 5, Eigen::RowVector3d(0.2, 0.3, 0.5) }, { 5, Eigen::RowVector3d(0.5, 0.5, 0) });
  ExpectPath(sphere, inside);
  EXPECT_EQ(inside.Triangles, std::vector<int>{ 5 });
  const int a = sphere.Triangles(7, 0), b = sphere.Triangles(7, 1);
  const shape::SurfacePath edge = paths.Find(AtPoint(sphere, a), AtPoint(sphere, b));
  ExpectPath(sphere, edge);
  EXPECT_EQ(edge.Positions.size(), 2U);
  EXPECT_NEAR(edge.Length, (sphere.Points.row(a) - sphere.Points.row(b)).norm(), 1e-15);
  const shape::SurfacePath nowhere = paths.Find(AtPoint(sphere, a), AtPoint(sphere, a));
  EXPECT_EQ(nowhere.Length, 0.0);
}

TEST(SurfacePath, PartsThatAreNotConnected)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  const shape::Mesh both = shapetest::Twice(sphere);
  const Eigen::RowVector3d middle = Eigen::RowVector3d::Constant(1.0 / 3.0);
  EXPECT_THROW(shape::SurfacePaths(both).Find({ 0, middle }, { 100, middle }), shape::InvalidInput);
  bool isAsked = false;
  const shape::Progress stop([&](double) { return !(isAsked = true); });
  EXPECT_THROW(
    shape::SurfacePaths(sphere).Find({ 0, middle }, { 79, middle }, stop), shape::Aborted);
  EXPECT_TRUE(isAsked);
}
