#include "Search/ClosestPoint.h"
#include "Search/NearestSurfacePoints.h"
#include "Search/TriangleTree.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

Eigen::MatrixXd RandomRows(int rows, int columns, unsigned int seed)
{
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd values(rows, columns);
  for (double& value : values.reshaped())
  {
    value = static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  return values;
}

/// The torus's points in six dimensions, bent by a few waves.
Eigen::MatrixXd InSix(const shape::Mesh& mesh)
{
  Eigen::MatrixXd points(mesh.Points.rows(), 6);
  points << mesh.Points, (2.0 * mesh.Points.array()).sin();
  return points;
}

TEST(NearestRows, AreThoseOfAllComparisons)
{
  const Eigen::MatrixXd rows = RandomRows(2500, 20, 1), queries = RandomRows(300, 20, 2);
  const Eigen::VectorXi found = shape::FindNearestRows(queries, rows);
  for (Eigen::Index i = 0; i < queries.rows(); ++i)
  {
    const Eigen::VectorXd squares = (rows.rowwise() - queries.row(i)).rowwise().squaredNorm();
    EXPECT_LE(squares(found(i)), squares.minCoeff() + 1e-5);
  }
}

TEST(NearestRows, OfEqualOnesTheFirst)
{
  Eigen::MatrixXd rows = RandomRows(10, 5, 3);
  rows.row(7) = rows.row(2);
  EXPECT_EQ(shape::FindNearestRows(rows.row(7), rows)(0), 2);
}

TEST(TriangleTree, FindsPlacesOnTheSurfaceFromTheTriangleNextDoor)
{
  // Of a triangle and the one across an edge near a place, the distances are all but equal: what
  // single precision loses must not count. (Twice that loses 1e-17.)
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 90, 40);
  const Eigen::MatrixXd points = InSix(torus);
  const shape::TriangleTree tree(torus.Triangles, points);
  for (int t = 0; t + 1 < torus.Triangles.rows(); t += 2)
  {
    // The two triangles of a square share an edge.
    for (const double inside : { 1e-2, 1e-3, 1e-4 })
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        Eigen::RowVector3d weights = Eigen::RowVector3d::Constant(0.5 * (1.0 - inside));
        weights(corner) = inside;
        const Eigen::RowVectorXd position =
          weights * points(torus.Triangles.row(t).eval(), Eigen::all);
        ASSERT_LT(tree.Find(position, t + 1).SquaredDistance, 1e-15) << t;
      }
    }
  }
}

TEST(TriangleTree, FindsTheNearestOfAllTrianglesAlsoAfterAMove)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  const Eigen::MatrixXd first = InSix(torus);
  shape::TriangleTree tree(torus.Triangles, first);
  for (const Eigen::MatrixXd& points : { first, Eigen::MatrixXd(1.7 * first.rowwise().reverse()) })
  {
    tree.Move(points);
    const Eigen::MatrixXd queries = 4.0 * RandomRows(60, 6, 4).array() - 2.0;
    for (Eigen::Index i = 0; i < queries.rows(); ++i)
    {
      const shape::NearestTriangle found = tree.Find(queries.row(i), -1);
      const shape::NearestTriangle again = tree.Find(queries.row(i), 17);
      EXPECT_NEAR(found.SquaredDistance, again.SquaredDistance, 1e-12);
      const Eigen::RowVectorXd position =
        found.Barycentric * points(torus.Triangles.row(found.Triangle).eval(), Eigen::all);
      EXPECT_NEAR((position - queries.row(i)).squaredNorm(), found.SquaredDistance, 1e-9);
      // No place of any triangle is nearer: a lattice in each.
      double minimum = std::numeric_limits<double>::infinity();
      constexpr int lattice = 6;
      for (int t = 0; t < torus.Triangles.rows(); ++t)
      {
        const Eigen::MatrixXd corners = points(torus.Triangles.row(t).eval(), Eigen::all);
        for (int j = 0; j <= lattice; ++j)
        {
          for (int k = 0; j + k <= lattice; ++k)
          {
            const Eigen::RowVector3d at(lattice - j - k, j, k);
            minimum = std::min(minimum, (at / lattice * corners - queries.row(i)).squaredNorm());
          }
        }
      }
      EXPECT_LE(found.SquaredDistance, minimum + 1e-12);
      EXPECT_GE(found.SquaredDistance, minimum - 0.3);
    }
  }
}

TEST(NearestPlaces, InThreeDimensionsAreTheClosestPoints)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  const Eigen::MatrixXd near = 1.02 * shape::SampleRandomly(torus, 500, 6);
  const shape::SurfacePoints map =
    shape::FindNearestSurfacePoints(near, torus.Triangles, torus.Points);
  const shape::ClosestPoints closest = shape::SurfaceLocator(torus).Find(near);
  const Eigen::MatrixXd positions = shape::PullBack(map, torus.Triangles, torus.Points);
  EXPECT_LT((positions - closest.Positions).cwiseAbs().maxCoeff(), 1e-9);
}

} // namespace
