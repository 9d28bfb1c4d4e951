#include "Atlas/SampleQuality.h"
#include "Quality/ScaledJacobian.h"
#include "Support/ProgressChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace
{

constexpr int Side = 6;

/// A cube of Side^3 hexahedra of size 1.
shape::HexMesh Cube()
{
  shape::HexMesh mesh{ Eigen::MatrixXd((Side + 1) * (Side + 1) * (Side + 1), 3),
    Eigen::MatrixXi(Side * Side * Side, 8) };
  const auto number = [](int x, int y, int z) { return x + (Side + 1) * (y + (Side + 1) * z); };
  for (int z = 0; z <= Side; ++z)
  {
    for (int y = 0; y <= Side; ++y)
    {
      for (int x = 0; x <= Side; ++x)
      {
        mesh.Points.row(number(x, y, z)) << x, y, z;
        if (x < Side && y < Side && z < Side)
        {
          mesh.Hexahedra.row(x + Side * (y + Side * z)) << number(x, y, z), number(x + 1, y, z),
            number(x + 1, y + 1, z), number(x, y + 1, z), number(x, y, z + 1),
            number(x + 1, y, z + 1), number(x + 1, y + 1, z + 1), number(x, y + 1, z + 1);
        }
      }
    }
  }
  return mesh;
}

shape::Surface BoundaryOf(const shape::HexMesh& mesh)
{
  return { mesh.Points, shape::SplitQuads(shape::FindBoundaryQuads(mesh)) };
}

/// The cube with a point in the middle of a face, and one inside, moved towards a neighbour.
shape::HexMesh Spoiled()
{
  shape::HexMesh mesh = Cube();
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d at = mesh.Points.row(i);
    if (at == Eigen::RowVector3d(3, 3, 0) || at == Eigen::RowVector3d(3, 3, 3))
    {
      mesh.Points.row(i) += Eigen::RowVector3d(0.46, 0.42, 0.0);
    }
  }
  return mesh;
}

} // namespace

TEST(SampleQuality, RaisesTheMinimumAndKeepsTheBoundaryOnTheSample)
{
  const shape::Surface sample = BoundaryOf(Cube());
  const shape::HexMesh given = Spoiled();
  const double before = shape::ComputeScaledJacobians(given).minCoeff();
  ASSERT_GT(before, 0.0);
  ASSERT_LT(before, 0.3);
  shape::HexMesh mesh = given;
  const double after = shape::RaiseSampleQuality(mesh, {}, sample, 0.5);
  EXPECT_GE(after, 0.5);
  EXPECT_EQ(after, shape::ComputeScaledJacobians(mesh).minCoeff());
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    // A point that was on a plane of the cube still is: at an edge on two of them.
    for (int k = 0; k < 3; ++k)
    {
      const double at = given.Points(i, k);
      if (at == 0.0 || at == Side)
      {
        EXPECT_NEAR(mesh.Points(i, k), at, 1e-12) << "point " << i;
      }
    }
  }
}

TEST(SampleQuality, LeavesGoodHexahedraAlone)
{
  const shape::HexMesh given = Spoiled();
  shape::HexMesh mesh = given;
  EXPECT_LT(shape::RaiseSampleQuality(mesh, {}, BoundaryOf(Cube()), 0.0), 0.3);
  EXPECT_EQ(mesh.Points, given.Points) << "nothing is wanted";
  mesh = Cube();
  EXPECT_EQ(shape::RaiseSampleQuality(mesh, {}, BoundaryOf(Cube()), 0.9), 1.0);
  EXPECT_EQ(mesh.Points, Cube().Points);
}

TEST(SampleQuality, HoldsThePointsBetweenRegions)
{
  const shape::HexMesh given = Spoiled();
  Eigen::VectorXi regions(given.Hexahedra.rows());
  std::set<int> lower, between;
  for (int hex = 0; hex < regions.size(); ++hex)
  {
    regions(hex) = hex / (Side * Side) < 2 ? 7 : -7; // below and above z = 2
    for (const int point : given.Hexahedra.row(hex))
    {
      if (regions(hex) == 7)
      {
        lower.insert(point);
      }
      else if (lower.count(point))
      {
        between.insert(point);
      }
    }
  }
  ASSERT_EQ(between.size(), static_cast<std::size_t>((Side + 1) * (Side + 1)));
  shape::HexMesh mesh = given;
  EXPECT_GT(shape::RaiseSampleQuality(mesh, regions, BoundaryOf(Cube()), 0.5),
    shape::ComputeScaledJacobians(given).minCoeff());
  for (const int point : between)
  {
    EXPECT_EQ(mesh.Points.row(point), given.Points.row(point));
  }
}

TEST(SampleQuality, ReportsProgressAndStops)
{
  const shape::Surface sample = BoundaryOf(Cube());
  const auto raise = [&](const shape::Progress& progress)
  {
    shape::HexMesh mesh = Spoiled();
    shape::RaiseSampleQuality(mesh, {}, sample, 0.5, progress);
  };
  EXPECT_GT(shapetest::ExpectProgressRises(raise), 2);
  shapetest::ExpectStopsAt(2, raise);
}
