#include "Base/Errors.h"
#include "Correspondence/Conformal/HyperbolicMap.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using shapetest::PositionsOn;

namespace
{

std::vector<int> FirstPoints(int count)
{
  std::vector<int> points(count);
  std::iota(points.begin(), points.end(), 0);
  return points;
}

double LargestError(
  const shape::SurfacePoints& map, const shape::Mesh& target, const Eigen::MatrixXd& expected)
{
  return (PositionsOn(map, target) - expected).rowwise().norm().maxCoeff();
}

shape::Mesh Stretched(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  mesh.Points.col(2) *= 2.0;
  return mesh;
}

} // namespace

TEST(HyperbolicMap, ASurfaceAndItsRotatedCopyGiveTheIdentity)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = a;
  b.Points = a.Points * shapetest::Rotation(2.0, { 0.3, -0.5, 0.8 }).transpose();
  for (const int cones : { 5, 8, 12 })
  {
    const auto map =
      shape::MapThroughHyperbolicOrbifold(a, FirstPoints(cones), b, FirstPoints(cones));
    EXPECT_LT(LargestError(map.AToB, b, b.Points), 1e-7);
    EXPECT_LT(LargestError(map.BToA, a, a.Points), 1e-7);
  }
}

TEST(HyperbolicMap, MovingTheCutDoesNotChangeTheMap)
{
  // Landmarks around the equator. The same closed curve through them is opened at each leg in turn,
  // and followed both ways: other edges are cut, and all images move.
  const shape::Surface a = shapetest::Pebble(shapetest::Icosphere(4)), b = Stretched(4);
  const shape::Mesh sphere = shapetest::Icosphere(4);
  std::vector<int> cones;
  for (int i = 0; i < 7; ++i)
  {
    const double angle = 2.0 * M_PI * i / 7, height = i % 2 == 0 ? 0.2 : -0.2;
    Eigen::Index nearest = 0;
    (sphere.Points * Eigen::Vector3d(std::cos(angle), std::sin(angle), height)).maxCoeff(&nearest);
    cones.push_back(static_cast<int>(nearest));
  }
  const auto mapped = [&](const std::vector<int>& order)
  {
    return PositionsOn(
      shape::MapBetweenHyperbolicImages(
        a, shape::MapToHyperbolicOrbifold(a, order), b, shape::MapToHyperbolicOrbifold(b, order)),
      b);
  };
  const Eigen::MatrixXd first = mapped(cones);
  for (std::size_t i = 1; i < cones.size(); ++i)
  {
    std::rotate(cones.begin(), cones.begin() + 1, cones.end());
    EXPECT_LT((mapped(cones) - first).rowwise().norm().maxCoeff(), 1e-6);
  }
  std::reverse(cones.begin(), cones.end());
  EXPECT_LT((mapped(cones) - first).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(HyperbolicMap, IsOneToOneAndMeetsTheLandmarks)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(4)), b = Stretched(4);
  for (const int cones : { 5, 9, 12 })
  {
    const std::vector<int> points = FirstPoints(cones);
    const auto map = shape::MapThroughHyperbolicOrbifold(a, points, b, points);
    for (const int cone : points)
    {
      Eigen::Index corner = 0;
      EXPECT_EQ(map.AToB.Barycentrics.row(cone).maxCoeff(&corner), 1.0);
      EXPECT_EQ(b.Triangles(map.AToB.Triangles(cone), corner), cone);
    }
    EXPECT_TRUE((map.AToB.Barycentrics.array() >= 0.0).all());
    // The image of A on B winds around its inside once, facing outwards.
    EXPECT_NEAR(shape::ComputeWindingNumber(
                  PositionsOn(map.AToB, b), a.Triangles, Eigen::RowVector3d(0.01, 0.02, 0.03)),
      1.0, 1e-9);
  }
}

TEST(HyperbolicMap, AnotherMeshOfTheSameShapeGivesNearlyTheIdentity)
{
  double before = 1.0;
  for (const int level : { 2, 3, 4 })
  {
    const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(level));
    const shape::Mesh b = shapetest::Pebble(shapetest::Icosphere(level + 1));
    const auto map = shape::MapThroughHyperbolicOrbifold(a, FirstPoints(8), b, FirstPoints(8));
    const double error =
      (PositionsOn(map.AToB, b) - b.Points.topRows(a.Points.rows())).rowwise().norm().mean();
    EXPECT_LT(error, 0.7 * before);
    before = error;
  }
}

TEST(HyperbolicMap, NumbersOfPointsTrianglesAndLandmarksDoNotMatter)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3)), b = Stretched(3);
  const std::vector<int> cones = { 0, 1, 2, 3, 4, 6, 9 }, shuffled = { 4, 9, 1, 0, 6, 3, 2 };
  const auto first = shape::MapThroughHyperbolicOrbifold(a, cones, b, cones);
  const auto other = shape::MapThroughHyperbolicOrbifold(a, shuffled, b, shuffled);
  EXPECT_LT(LargestError(other.AToB, b, PositionsOn(first.AToB, b)), 1e-7);
  const shapetest::Renumbered renumbered = shapetest::Renumber(b, 5);
  std::vector<int> conesThere;
  for (const int cone : cones)
  {
    conesThere.push_back(renumbered.NewOf(cone));
  }
  const auto there = shape::MapThroughHyperbolicOrbifold(a, cones, renumbered.Mesh, conesThere);
  EXPECT_LT(LargestError(there.AToB, renumbered.Mesh, PositionsOn(first.AToB, b)), 1e-7);
}

TEST(HyperbolicMap, TheOrderIsThatOfTheShortestPath)
{
  // Places on a line, in any order.
  const std::vector<double> places = { 3.0, 0.5, 7.0, 1.1, 4.2, 9.0, 2.0 };
  Eigen::MatrixXd distances(7, 7);
  for (int i = 0; i < 7; ++i)
  {
    for (int j = 0; j < 7; ++j)
    {
      distances(i, j) = std::abs(places[i] - places[j]);
    }
  }
  const std::vector<int> order = shape::FindShortestOrder(distances);
  EXPECT_EQ(order, (std::vector<int>{ 1, 3, 6, 0, 4, 2, 5 }));
}

TEST(HyperbolicMap, SaysWhichSurfaceIsAtFault)
{
  const std::string refusal = shapetest::Refusal(
    []
    {
      shape::MapThroughHyperbolicOrbifold(
        shapetest::Icosphere(1), FirstPoints(5), shapetest::Torus(1.0, 0.3, 12, 8), FirstPoints(5));
    });
  EXPECT_EQ(refusal.find("Surface B: "), 0u) << refusal;
}
