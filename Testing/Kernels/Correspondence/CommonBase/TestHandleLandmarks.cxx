#include "Base/Errors.h"
#include "Correspondence/CommonBase/CommonBaseMap.h"
#include "Correspondence/CommonBase/HandleLandmarks.h"
#include "Correspondence/CommonBase/Private/HandleLoops.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Support/TestShapes.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace
{

/// How often a closed polyline goes around the z axis.
int TurnsAroundAxis(const Eigen::MatrixXd& loop)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const Eigen::RowVector3d p = loop.row(i), q = loop.row((i + 1) % loop.rows());
    sum += std::atan2(p(0) * q(1) - p(1) * q(0), p(0) * q(0) + p(1) * q(1));
  }
  return static_cast<int>(std::lround(sum / (2.0 * M_PI)));
}

/// Bent to an ellipse, so that no turn maps it to itself.
shape::Mesh Oval(shape::Mesh mesh)
{
  mesh.Points.col(0) *= 1.5;
  return mesh;
}

/// The same surface with its points in reverse order.
shape::Mesh Renumbered(const shape::Mesh& mesh)
{
  const auto last = static_cast<int>(mesh.Points.rows()) - 1;
  return { mesh.Points.colwise().reverse(), last - mesh.Triangles.array() };
}

} // namespace

TEST(HandleLoops, AreTheShortestAroundATubeAndThroughAHole)
{
  // Handle and tunnel loops of a thin and of a thick torus: circles of the mesh, as polygons.
  constexpr int around = 24, across = 12;
  for (const double minor : { 0.3, 0.7 })
  {
    const shape::Mesh torus = shapetest::Torus(1.0, minor, around, across);
    const shape::HandleLoops loops(torus, "it");
    EXPECT_EQ(loops.Genus(), 1);
    double handle = 1e9, tunnel = 1e9;
    for (int point = 0; point < static_cast<int>(torus.Points.rows()); ++point)
    {
      for (const shape::LoopCrossing& found : loops.FindAt(point, 1))
      {
        EXPECT_EQ(found.Handle.Points.front(), point);
        EXPECT_EQ(found.Tunnel.Points.front(), point);
        EXPECT_EQ(std::abs(loops.Crossings(found.Handle, found.Tunnel)), 1);
        EXPECT_EQ(loops.Crossings(shape::Reversed(found.Handle), found.Tunnel),
          -loops.Crossings(found.Handle, found.Tunnel));
        EXPECT_EQ(TurnsAroundAxis(torus.Points(found.Handle.Points, Eigen::all)), 0);
        EXPECT_EQ(std::abs(TurnsAroundAxis(torus.Points(found.Tunnel.Points, Eigen::all))), 1);
        handle = std::min(handle, found.Handle.Length);
        tunnel = std::min(tunnel, found.Tunnel.Length);
      }
    }
    EXPECT_NEAR(handle, 2.0 * across * minor * std::sin(M_PI / across), 1e-9);
    EXPECT_NEAR(tunnel, 2.0 * around * (1.0 - minor) * std::sin(M_PI / around), 1e-9);
  }
}

TEST(HandleLandmarks, GiveAOneToOneMapWithoutTurningTheTorus)
{
  const shape::Mesh a = Oval(shapetest::Torus(1.0, 0.4, 24, 10)),
                    b = Oval(shapetest::Torus(1.0, 0.3, 20, 10));
  // Others that contradict the shape: a quarter turn.
  const shape::HandleLandmarks found = shape::FindHandleLandmarks(a, b, { { 0, 50 }, { 60, 100 } });
  ASSERT_EQ(found.LoopsOfA.size(), 2U);
  EXPECT_FALSE(found.LoopsOfA[0].IsTunnel);
  EXPECT_TRUE(found.LoopsOfA[1].IsTunnel);
  for (const shape::HandleLoop& loop : found.LoopsOfA)
  {
    EXPECT_EQ(loop.Points.front(), loop.Points.back());
    EXPECT_EQ(std::abs(TurnsAroundAxis(a.Points(loop.Points, Eigen::all))), loop.IsTunnel ? 1 : 0);
  }
  shape::Landmarks used;
  const shape::CommonBaseMap map = shape::MapByHandles(a, b, found, used);
  EXPECT_EQ(map.Flipped, 0);
  ASSERT_GE(used.size(), 2U) << "as many as genus 1 needs";
  // The ellipses' long axes are mapped to each other, at one end or the other.
  for (const auto& [pointA, pointB] : used)
  {
    EXPECT_LT(std::abs(std::abs(a.Points(pointA, 0)) - std::abs(b.Points(pointB, 0))), 0.5);
  }
  // Not much worse than from landmarks at the ends of the axes, outside.
  const shape::CommonBaseMap given =
    shape::MapThroughBase(a, b, { { 0, 0 }, { 60, 50 }, { 120, 100 }, { 180, 150 } });
  EXPECT_LT(map.Energy + map.EnergyBack, 1.25 * (given.Energy + given.EnergyBack));
}

TEST(HandleLandmarks, DoNotDependOnTheNumbersOfPoints)
{
  const shape::Mesh a = Oval(shapetest::Torus(1.0, 0.4, 12, 8)),
                    b = Oval(shapetest::Torus(1.0, 0.35, 14, 8));
  const shape::Landmarks others{ { 0, 0 }, { 40, 48 } };
  const shape::Landmarks one = shape::FindHandleLandmarks(a, b, others).Candidates.front().Pairs;
  const auto lastA = static_cast<int>(a.Points.rows()) - 1,
             lastB = static_cast<int>(b.Points.rows()) - 1;
  const shape::Landmarks other = shape::FindHandleLandmarks(
    Renumbered(a), Renumbered(b), { { lastA, lastB }, { lastA - 40, lastB - 48 } })
                                   .Candidates.front()
                                   .Pairs;
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i][0], lastA - other[i][0]);
    EXPECT_EQ(one[i][1], lastB - other[i][1]);
  }
}
