#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

// Functions shared by the tests of filled holes.
namespace shapetest
{

constexpr double Degree = M_PI / 180.0;

/// Returns the mesh without the triangles for whose centroid `isRemoved` is true.
inline shape::Mesh Without(
  shape::Mesh mesh, const std::function<bool(const Eigen::RowVector3d&)>& isRemoved)
{
  int kept = 0;
  const Eigen::MatrixXd centres = shape::ComputeCentroids(mesh);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (!isRemoved(centres.row(t)))
    {
      mesh.Triangles.row(kept++) = mesh.Triangles.row(t);
    }
  }
  mesh.Triangles.conservativeResize(kept, 3);
  return mesh;
}

inline Eigen::RowVector3d CapAxis()
{
  return Eigen::RowVector3d(0.3, -0.5, 0.8).normalized();
}

/// Returns the unit sphere without a cap of this half-angle around CapAxis.
inline shape::Mesh SphereWithoutCap(int level, double degrees)
{
  return Without(shapetest::Icosphere(level),
    [degrees](const Eigen::RowVector3d& position)
    { return position.normalized().dot(CapAxis()) > std::cos(degrees * M_PI / 180.0); });
}

/// Returns two rows of quads beside a closed curve; their points are the curve moved by away(i) and
/// by twice that. The curve is the left boundary, and its first point is point 0.
inline shape::Mesh Ribbon(const Eigen::MatrixXd& curve, const Eigen::MatrixXd& away)
{
  const auto count = static_cast<int>(curve.rows());
  shape::Mesh ribbon{ Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(4 * count, 3) };
  ribbon.Points << curve, curve + away, curve + 2.0 * away;
  for (int i = 0; i < count; ++i)
  {
    const int next = (i + 1) % count;
    for (const int row : { 0, count })
    {
      ribbon.Triangles.row(4 * i + (row > 0 ? 2 : 0)) << row + i, row + count + i, row + next;
      ribbon.Triangles.row(4 * i + (row > 0 ? 3 : 1)) << row + next, row + count + i,
        row + count + next;
    }
  }
  return ribbon;
}

/// Returns the boundary loop that starts at point 0, or nothing if there is none.
inline std::vector<std::vector<int>> LoopOfPointZero(const shape::Mesh& mesh)
{
  for (const std::vector<int>& loop : shape::FindBoundaryLoops(mesh).Loops)
  {
    if (loop.front() == 0)
    {
      return { loop };
    }
  }
  return {};
}

/// Checks the properties of every fill: the input is unchanged, bit for bit, and the result is a
/// manifold.
inline void ExpectSound(
  const shape::Mesh& before, const shape::FilledSurface& filled, int openLoops, int euler)
{
  EXPECT_EQ(filled.Surface.Points.topRows(before.Points.rows()), before.Points);
  EXPECT_EQ(filled.Surface.Triangles.topRows(before.Triangles.rows()), before.Triangles);
  EXPECT_TRUE(filled.Surface.Points.allFinite());
  // A surface on a line is a manifold, too.
  const shape::Topology topology = shape::ComputeTopology(filled.Surface);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.NonManifoldPoints, 0);
  EXPECT_EQ(topology.MisorientedEdges, 0);
  EXPECT_EQ(topology.BoundaryLoops, openLoops);
  EXPECT_EQ(topology.EulerNumber, euler);
}

/// Returns the number of self-intersections of all fills.
inline int Crossings(const shape::FilledSurface& filled)
{
  int count = 0;
  for (const shape::FilledHole& hole : filled.Holes)
  {
    count += hole.SelfIntersections;
  }
  return count;
}

} // namespace shapetest
