#include "Base/Errors.h"
#include "Geometry/GraphComponents.h"
#include "Geometry/PointGraph.h"
#include "Search/PointTree.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

/// Every triangle with three points of its own.
shape::Mesh Soup(const shape::Mesh& mesh)
{
  shape::Mesh soup{ Eigen::MatrixXd(3 * mesh.Triangles.rows(), 3), mesh.Triangles };
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(mesh, t);
    soup.Triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  return soup;
}

std::vector<int> NeighboursOf(const shape::PointGraph& graph, int node)
{
  return { graph.Neighbours.begin() + graph.First[node],
    graph.Neighbours.begin() + graph.First[node + 1] };
}

Eigen::MatrixXd RandomPoints(int count)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(count, 3, [&] { return uniform(generator); });
}

} // namespace

TEST(PointGraph, OfASphereHasItsEdgesAreasAndCurvature)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const shape::PointGraph graph = shape::BuildPointGraph(sphere);
  EXPECT_EQ(graph.Size(), 2562);
  EXPECT_EQ(graph.Neighbours.size(), 6u * 2560u); // twice the edges, 3 (n - 2)
  for (int i = 0; i < graph.Size(); ++i)
  {
    const std::vector<int> around = NeighboursOf(graph, i);
    EXPECT_TRUE(std::is_sorted(around.begin(), around.end()));
    for (std::size_t k = 0; k < around.size(); ++k)
    {
      EXPECT_EQ(graph.Lengths[graph.First[i] + k],
        (sphere.Points.row(i) - sphere.Points.row(around[k])).norm());
    }
  }
  // Each triangle counts at its three corners.
  EXPECT_NEAR(graph.Weights.sum(), 3.0 * 4.0 * M_PI, 0.01 * 12.0 * M_PI);
  // The angles that are missing around all points are 4 pi (Gauss and Bonnet).
  EXPECT_NEAR(graph.Curvatures.dot(graph.Weights) / 3.0, 4.0 * M_PI, 1e-9);
  EXPECT_LT((graph.Curvatures.array() - 1.0).abs().maxCoeff(), 0.2);
  EXPECT_LT((graph.Normals - sphere.Points).rowwise().norm().maxCoeff(), 0.01);
}

TEST(PointGraph, OfASoupIsThatOfTheSurface)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::Mesh soup = Soup(sphere);
  soup.Points += 1e-12 * RandomPoints(static_cast<int>(soup.Points.rows()));
  const shape::PointGraph one = shape::BuildPointGraph(sphere),
                          other = shape::BuildPointGraph(soup);
  ASSERT_EQ(other.Size(), one.Size());
  EXPECT_NEAR(other.MeanLength, one.MeanLength, 1e-10);
  for (int point = 0; point < soup.Points.rows(); ++point)
  {
    const int node = other.NodeOf(point);
    EXPECT_LT((other.Positions.row(node) - soup.Points.row(point)).norm(), 1e-10);
    const int same = sphere.Triangles(point / 3, point % 3);
    EXPECT_NEAR(other.Weights(node), one.Weights(same), 1e-10);
    EXPECT_EQ(NeighboursOf(other, node).size(), NeighboursOf(one, same).size());
  }
}

TEST(PointGraph, ADenseSpotHardlyChangesTheMeanLength)
{
  const shape::Mesh flat = shapetest::FlatSquare(20, 0.2);
  const double before = shape::BuildPointGraph(flat).MeanLength;
  shape::Mesh dense = flat; // 200 points in one triangle, as fans
  for (int k = 0; k < 200; ++k)
  {
    const Eigen::RowVector3i corners = dense.Triangles.row(0);
    const auto n = static_cast<int>(dense.Points.rows());
    dense.Points.conservativeResize(n + 1, 3);
    dense.Points.row(n) =
      (dense.Points.row(corners(0)) + dense.Points.row(corners(1)) + dense.Points.row(corners(2))) /
      3.0;
    const Eigen::Index m = dense.Triangles.rows();
    dense.Triangles.conservativeResize(m + 2, 3);
    dense.Triangles.row(0) << corners(0), corners(1), n;
    dense.Triangles.row(m) << corners(1), corners(2), n;
    dense.Triangles.row(m + 1) << corners(2), corners(0), n;
  }
  EXPECT_NEAR(shape::BuildPointGraph(dense).MeanLength, before, 0.02 * before);
}

TEST(PointGraph, SolidsCurvesAndLoosePointsHaveNeighbours)
{
  shape::ShapeElements shape;
  shape.Points.resize(8, 3);
  shape.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 9, 9, 9, 9, 9, 8;
  shape.Tetrahedra.resize(1, 4);
  shape.Tetrahedra << 0, 1, 2, 3;
  shape.Lines.resize(2, 2);
  shape.Lines << 3, 4, 4, 5;
  const shape::PointGraph graph = shape::BuildPointGraph(shape, { 1 });
  EXPECT_EQ(NeighboursOf(graph, 0), std::vector<int>({ 1, 2, 3 }));
  EXPECT_EQ(NeighboursOf(graph, 4), std::vector<int>({ 3, 5 }));
  EXPECT_EQ(NeighboursOf(graph, 6), std::vector<int>({ 7 }));
  EXPECT_EQ(graph.Weights(6), 1.0); // the squared distance of its nearest neighbour
  EXPECT_GT(graph.Weights.minCoeff(), 0.0);
  EXPECT_EQ(graph.Curvatures, Eigen::VectorXd::Zero(8));
}

TEST(PointGraph, DegenerateTrianglesHaveNoWeight)
{
  shape::Mesh mesh;
  mesh.Points.resize(6, 3);
  mesh.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0, 1, 0, 0;
  mesh.Triangles.resize(3, 3);
  mesh.Triangles << 0, 1, 2, 1, 3, 4, 1, 5, 3;
  const shape::PointGraph graph = shape::BuildPointGraph(mesh);
  EXPECT_EQ(graph.Size(), 5); // 5 is 1
  EXPECT_EQ(graph.NodeOf(5), graph.NodeOf(1));
  EXPECT_EQ(graph.Weights(3), 0.0);
  EXPECT_NEAR(graph.Weights(0), 0.5, 1e-15);
  EXPECT_TRUE(graph.Weights.allFinite() && graph.Curvatures.allFinite());
}

TEST(PointGraph, IslandsAreJoinedWhereTheyAreNearest)
{
  // Three squares in a row, the last nearer to the middle one than to the first.
  const shape::Mesh square = shapetest::FlatSquare(4, 0.0);
  const Eigen::Index n = square.Points.rows(), m = square.Triangles.rows();
  shape::Mesh all{ Eigen::MatrixXd(3 * n, 3), Eigen::MatrixXi(3 * m, 3) };
  for (int k = 0; k < 3; ++k)
  {
    all.Points.middleRows(k * n, n) = square.Points.rowwise() + Eigen::RowVector3d(2.5 * k, 0, 0);
    all.Triangles.middleRows(k * m, m) = square.Triangles.array() + static_cast<int>(k * n);
  }
  shape::PointGraph graph = shape::BuildPointGraph(all);
  const auto links = shape::ListLinks(graph);
  EXPECT_EQ(shape::ConnectComponents(graph, { 0 }), 2);
  const auto joined = shape::ListLinks(graph);
  ASSERT_EQ(joined.size(), links.size() + 2);
  double longest = 0.0;
  for (const auto& [a, b] : joined)
  {
    longest = std::max(longest, (graph.Positions.row(a) - graph.Positions.row(b)).norm());
  }
  EXPECT_LT(longest, 0.71); // a diagonal of a square's cell: the gaps are 0.5
  EXPECT_EQ(shape::ConnectComponents(graph, { 0 }), 0);
}

TEST(PointGraph, NamesWhatIsWrong)
{
  shape::Mesh mesh = shapetest::Icosphere(0);
  EXPECT_REFUSED(shape::BuildPointGraph(shape::Mesh{}), "has no points");
  mesh.Triangles(0, 0) = 12;
  EXPECT_THROW(shape::BuildPointGraph(mesh), shape::InvalidInput);
  mesh.Triangles(0, 0) = 0;
  mesh.Points(3, 1) = NAN;
  EXPECT_THROW(shape::BuildPointGraph(mesh), shape::InvalidInput);
}

TEST(PointTree, FindsWhatASearchThroughAllFinds)
{
  Eigen::MatrixXd points = RandomPoints(500);
  points.bottomRows(100) = points.topRows(100); // equally near ones, too
  const shape::PointTree tree(points);
  const Eigen::MatrixXd positions = RandomPoints(50);
  for (const Eigen::RowVector3d position : positions.rowwise())
  {
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < points.rows(); ++i)
    {
      order.emplace_back((points.row(i) - position).squaredNorm(), i);
    }
    std::sort(order.begin(), order.end());
    const std::vector<int> nearest = tree.Nearest(position, 20);
    ASSERT_EQ(nearest.size(), 20u);
    for (int k = 0; k < 20; ++k)
    {
      EXPECT_EQ(nearest[k], order[k].second);
    }
    const auto odd = std::find_if(
      order.begin(), order.end(), [](const auto& item) { return item.second % 2 == 1; });
    EXPECT_EQ(tree.NearestOf(
                position, [](int i) { return i % 2 == 1; }, 10.0),
      odd->second);
    EXPECT_EQ(tree.NearestOf(
                position, [](int) { return false; }, 10.0),
      -1);
    const double radius = std::sqrt(order[7].first);
    const std::vector<int> within = tree.Within(position, 1.000001 * radius);
    EXPECT_TRUE(std::is_sorted(within.begin(), within.end()));
    EXPECT_GE(within.size(), 8u);
    for (const int i : within)
    {
      EXPECT_LE((points.row(i) - position).norm(), 1.000001 * radius);
    }
  }
  EXPECT_EQ(tree.Nearest(positions.row(0), 1000).size(), 500u);
}

TEST(PointGraph, LengthsThatCannotBeComputedWithAreNamed)
{
  shape::Mesh sphere = shapetest::Icosphere(1);
  for (const double scale : { 1e-60, 1e60, 1e200 })
  {
    shape::Mesh scaled = sphere;
    scaled.Points *= scale;
    EXPECT_THROW(shape::BuildPointGraph(scaled), shape::InvalidInput);
  }
  sphere.Points *= 1e-40;
  EXPECT_GT(shape::BuildPointGraph(sphere).MeanLength, 0.0);
}
