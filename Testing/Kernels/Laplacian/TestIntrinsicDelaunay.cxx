#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Mesh/HalfEdges.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace
{

/// Checks that no edge inside has a negative weight and that the area is the surface's.
Eigen::SparseMatrix<double> CheckedStiffness(const shape::Mesh& mesh)
{
  const shape::IntrinsicTriangles flat = shape::BuildIntrinsicDelaunay(mesh);
  EXPECT_EQ(flat.Triangles.rows(), mesh.Triangles.rows());
  const shape::TriangleAngles angles = shape::ComputeAnglesFromLengths(flat.Sides);
  const double area = shape::ComputeTriangleAngles(mesh).Areas.sum();
  EXPECT_NEAR(angles.Areas.sum(), area, 1e-4 * area);
  Eigen::SparseMatrix<double> stiffness =
    shape::BuildCotangentStiffness(flat.Triangles, angles.Cotangents, mesh.Points.rows());
  std::set<std::pair<int, int>> boundary;
  for (const shape::HalfEdge& edge : shape::SortHalfEdges(mesh.Triangles, mesh.Points.rows()))
  {
    const std::pair<int, int> ends(edge.Low(), edge.High());
    if (!boundary.insert(ends).second)
    {
      boundary.erase(ends);
    }
  }
  double maximum = 0.0;
  for (int column = 0; column < stiffness.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, column); entry; ++entry)
    {
      const std::pair<int, int> ends = std::minmax({ static_cast<int>(entry.row()), column });
      maximum =
        entry.row() == column || boundary.count(ends) ? maximum : std::max(maximum, entry.value());
    }
  }
  EXPECT_LE(maximum, 1e-6);
  return stiffness;
}

} // namespace

TEST(IntrinsicDelaunay, OfAStretchedGridIsThatOfItsPoints)
{
  // A sheared grid, whose triangles are needles: the plane's Delaunay triangulation of these points
  // is that of a square grid, up to diagonals, whose weights are 0.
  constexpr int n = 9, shear = 4;
  shape::Mesh grid{ Eigen::MatrixXd((n + 1) * (n + 1), 3), Eigen::MatrixXi(2 * n * n, 3) };
  const auto id = [](int x, int y) { return x + (n + 1) * y; };
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      grid.Points.row(id(x, y)) << x + shear * y, y, 0.0;
      if (x < n && y < n)
      {
        grid.Triangles.row(2 * (x + n * y)) << id(x, y), id(x + 1, y), id(x + 1, y + 1);
        grid.Triangles.row(2 * (x + n * y) + 1) << id(x, y), id(x + 1, y + 1), id(x, y + 1);
      }
    }
  }
  const Eigen::SparseMatrix<double> stiffness = CheckedStiffness(grid);
  const int middle = id(n / 2, n / 2);
  EXPECT_NEAR(stiffness.coeff(middle, middle), 4.0, 1e-4);
  EXPECT_NEAR(stiffness.coeff(middle, id(n / 2 + 1, n / 2)), -1.0, 1e-4);
  EXPECT_NEAR(stiffness.coeff(middle, id(n / 2 - shear, n / 2 + 1)), -1.0, 1e-4);
}

TEST(IntrinsicDelaunay, KeepsTheDirichletEnergyOfLinearFunctionsInThePlane)
{
  // A fan whose triangles are very obtuse, in the plane: x has the energy area / 2 at inner points,
  // whatever the edges are.
  shape::Mesh fan{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(7, 3) };
  fan.Points.row(7) << 0.9, 0.01, 0.0;
  for (int i = 0; i < 7; ++i)
  {
    const double angle = 2.0 * M_PI * i / 7.0;
    fan.Points.row(i) << std::cos(angle), std::sin(angle), 0.0;
    fan.Triangles.row(i) << i, (i + 1) % 7, 7;
  }
  const Eigen::SparseMatrix<double> stiffness = CheckedStiffness(fan);
  const Eigen::VectorXd x = fan.Points.col(0);
  const double area = shape::ComputeTriangleAngles(fan).Areas.sum();
  EXPECT_NEAR(x.dot(stiffness * x), area, 1e-4 * area);
}

TEST(IntrinsicDelaunay, OfRealSurfacesHasNoNegativeWeight)
{
  for (const char* name : { "elephant", "anchor", "hand", "elk" })
  {
    SCOPED_TRACE(name);
    CheckedStiffness(shapetest::ReadModel(name));
  }
}
