#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Parameterize/OrbifoldTutte.h"
#include "Quality/ConformalDistortion.h"
#include "Support/FlatMaps.h"
#include "Support/MatchingShapes.h"
#include "Support/Orbifolds.h"
#include "Support/Refusals.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using shape::OrbifoldType;
using shapetest::ConesOnIcosphere;

namespace
{

int Flips(const shape::OrbifoldImage& image)
{
  return shapetest::CountFlips(image.Cut.Surface.Triangles, image.Points);
}

double ImageArea(const shape::Mesh& cut, const Eigen::MatrixXd& points)
{
  double area = 0.0;
  for (const auto& corners : cut.Triangles.rowwise())
  {
    Eigen::Matrix2d edges;
    edges.row(0) = points.row(corners(1)) - points.row(corners(0));
    edges.row(1) = points.row(corners(2)) - points.row(corners(0));
    area += 0.5 * edges.determinant();
  }
  return area;
}

double MeanDistortion(const shape::Mesh& mesh, const Eigen::MatrixXd& image)
{
  Eigen::MatrixXd flat = Eigen::MatrixXd::Zero(image.rows(), 3);
  flat.leftCols(2) = image;
  return shapetest::MeanDistortion(mesh, flat);
}

} // namespace

TEST(OrbifoldTutte, CoversTheTileOnceWithoutAFlip)
{
  const double areas[] = { 1.0, std::sqrt(0.75), std::sqrt(3.0) / 4.0, 1.0 };
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(3));
    const auto image = shape::MapToOrbifold(mesh, ConesOnIcosphere(type), type);
    EXPECT_EQ(Flips(image), 0);
    // The cut is curved, but what it takes on one side it gives on the other.
    EXPECT_NEAR(ImageArea(image.Cut.Surface, image.Points), areas[static_cast<int>(type)], 1e-12);
    // The cut surface is a disk whose points know where they come from.
    EXPECT_GT(image.Cut.Surface.Points.rows(), mesh.Points.rows());
    EXPECT_EQ(image.Cut.Surface.Points, mesh.Points(image.Cut.Provenance.Points, Eigen::all));
  }
}

TEST(OrbifoldTutte, TheAnglesAroundConesAddUpToTheirOrders)
{
  const double orders[][4] = { { 4, 2, 4, 0 }, { 3, 3, 3, 0 }, { 6, 3, 2, 0 }, { 2, 2, 2, 2 } };
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const auto image = shape::MapToOrbifold(
      shapetest::Pebble(shapetest::Icosphere(3)), ConesOnIcosphere(type), type);
    Eigen::VectorXd angles = Eigen::VectorXd::Zero(642);
    for (const auto& corners : image.Cut.Surface.Triangles.rowwise())
    {
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::RowVector2d u =
          image.Points.row(corners((k + 1) % 3)) - image.Points.row(corners(k));
        const Eigen::RowVector2d v =
          image.Points.row(corners((k + 2) % 3)) - image.Points.row(corners(k));
        angles(image.Cut.Provenance.Points(corners(k))) +=
          std::atan2(u(0) * v(1) - u(1) * v(0), u.dot(v));
      }
    }
    Eigen::VectorXd expected = Eigen::VectorXd::Constant(642, 2.0 * M_PI);
    for (std::size_t i = 0; i < image.Cones.size(); ++i)
    {
      expected(image.Cones[i]) /= orders[static_cast<int>(type)][i];
    }
    EXPECT_LT((angles - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(OrbifoldTutte, TheMotionsOfTheTileFormItsGroup)
{
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const shape::OrbifoldTile tile = shape::BuildOrbifoldTile(type);
    for (std::size_t leg = 0; leg < tile.Legs.size(); ++leg)
    {
      EXPECT_LT(std::abs(tile.Legs[leg](tile.There[leg]) - tile.Back[leg]), 1e-15);
      EXPECT_LT(std::abs(tile.Legs[leg](tile.There[leg + 1]) - tile.Back[leg + 1]), 1e-15);
    }
    // As many images of the tile as fit into a disk: its area over the tile's.
    const auto motions = shape::ComputeOrbifoldMotions(tile, { 0.37, 0.21 }, 12.0);
    const double areas[] = { 1.0, std::sqrt(0.75), std::sqrt(3.0) / 4.0, 1.0 };
    const double expected = M_PI * 144.0 / areas[static_cast<int>(type)];
    EXPECT_NEAR(static_cast<double>(motions.size()) / expected, 1.0, 0.06);
    EXPECT_EQ(motions.front().Shift, 0.0);
  }
}

TEST(OrbifoldTutte, BecomesConformalWithTheMeshAwayFromTheCones)
{
  // Near a cone of order k the image grows with the k-th root of the distance: errors fall slowly.
  const double limits[] = { 0.04, 0.02, 0.09, 0.02 };
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    double before = 10.0;
    for (const int level : { 2, 3, 4 })
    {
      const auto image = shape::MapToOrbifold(
        shapetest::Pebble(shapetest::Icosphere(level)), ConesOnIcosphere(type), type);
      const Eigen::MatrixXd positions =
        type == OrbifoldType::Rectangle ? shape::FitToBestParallelogram(image) : image.Points;
      const double above = MeanDistortion(image.Cut.Surface, positions) - 1.0;
      EXPECT_LT(above, 0.8 * before) << static_cast<int>(type) << " level " << level;
      before = above;
    }
    EXPECT_LT(before, limits[static_cast<int>(type)]) << static_cast<int>(type);
  }
}

TEST(OrbifoldTutte, TheBestParallelogramKeepsTheAreaAndLowersTheDistortion)
{
  const auto image = shape::MapToOrbifold(
    shapetest::Pebble(shapetest::Icosphere(3)), { 0, 4, 8, 2 }, OrbifoldType::Rectangle);
  const Eigen::MatrixXd best = shape::FitToBestParallelogram(image);
  EXPECT_NEAR(ImageArea(image.Cut.Surface, best), 1.0, 1e-12);
  EXPECT_LT(
    MeanDistortion(image.Cut.Surface, best), MeanDistortion(image.Cut.Surface, image.Points));
}

TEST(OrbifoldTutte, CanBeCutBetweenNeighbours)
{
  // On an octahedron every path is one edge.
  const shape::Mesh octahedron{
    (Eigen::MatrixXd(6, 3) << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1).finished(),
    (Eigen::MatrixXi(8, 3) << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3,
      5)
      .finished()
  };
  EXPECT_EQ(Flips(shape::MapToOrbifold(octahedron, { 0, 2, 4 }, OrbifoldType::Rhombus)), 0);
  EXPECT_EQ(Flips(shape::MapToOrbifold(octahedron, { 0, 2, 1, 5 }, OrbifoldType::Rectangle)), 0);
}

TEST(OrbifoldTutte, ATetrahedronOfConesHasNothingLeftToFind)
{
  const shape::Mesh tetrahedron{
    (Eigen::MatrixXd(4, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1).finished(),
    (Eigen::MatrixXi(4, 3) << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2).finished()
  };
  const shape::OrbifoldImage image =
    shape::MapToOrbifold(tetrahedron, { 0, 1, 2, 3 }, OrbifoldType::Rectangle);
  EXPECT_EQ(Flips(image), 0);
  EXPECT_NEAR(ImageArea(image.Cut.Surface, image.Points), 1.0, 1e-12);
}

TEST(OrbifoldTutte, FindsAPathWhereTheShortestWouldWallAConeIn)
{
  // Every four corners of an icosahedron, in every order.
  const shape::Mesh mesh = shapetest::Icosphere(0);
  int paths = 0;
  for (int code = 0; code < 12 * 12 * 12; ++code)
  {
    const std::vector<int> stops = { 0, code % 12, code / 12 % 12, code / 144 };
    if (std::set<int>(stops.begin(), stops.end()).size() == 4)
    {
      EXPECT_EQ(shape::FindEdgePathThrough(mesh, stops).Stops.size(), 4u);
      ++paths;
    }
  }
  EXPECT_EQ(paths, 990);
}

TEST(OrbifoldTutte, APathAvoidsWhatCountsAsLong)
{
  const shape::Mesh mesh = shapetest::Icosphere(3);
  Eigen::Index top = 0, bottom = 0;
  mesh.Points.col(2).maxCoeff(&top);
  mesh.Points.col(2).minCoeff(&bottom);
  for (const double side : { 1.0, -1.0 })
  {
    const Eigen::MatrixXd factors = (side * mesh.Points.col(0).array() > 0.2)
                                      .select(Eigen::ArrayXd::Constant(642, 50.0), 1.0)
                                      .matrix();
    const shape::EdgePath path = shape::FindEdgePathThrough(
      mesh, { static_cast<int>(top), static_cast<int>(bottom) }, {}, factors);
    EXPECT_LE((side * mesh.Points(path.Points, 0)).maxCoeff(), 0.2);
  }
}

TEST(OrbifoldTutte, WhatItCannotMapIsRefusedWithTheFact)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(2));
  EXPECT_REFUSED(
    shape::MapToOrbifold(mesh, { 0, 1 }, OrbifoldType::Square), "has 3 cones, but 2 are given");
  EXPECT_REFUSED(shape::MapToOrbifold(mesh, { 0, 7, 0 }, OrbifoldType::Square),
    "cones 0 and 2 are the same point, 0");
  EXPECT_REFUSED(shape::MapToOrbifold(mesh, { 0, 7, 999 }, OrbifoldType::Square), "is point 999");
  EXPECT_REFUSED(
    shape::MapToOrbifold(shapetest::Torus(1.0, 0.3, 20, 10), { 0, 50, 100 }, OrbifoldType::Square),
    "(genus 1)");
  EXPECT_REFUSED(
    shape::MapToOrbifold(shapetest::FlatDisk(4), { 0, 1, 2 }, OrbifoldType::Square), "open loop");
}
