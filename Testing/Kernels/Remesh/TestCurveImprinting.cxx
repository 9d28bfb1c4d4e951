#include "Base/Errors.h"
#include "Mesh/SurfaceCut.h"
#include "Mesh/Topology.h"
#include "Remesh/CurveImprinting.h"
#include "Search/ClosestPoint.h"
#include "Support/CurveShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using shapetest::Circle;

shape::ImprintedCurves Insert(
  const shape::Mesh& mesh, const std::vector<Eigen::MatrixXd>& curves, double snap = 0.05)
{
  const shape::SurfaceLocator locator(mesh);
  shape::SurfacePaths paths(mesh);
  std::vector<shape::SurfaceLoop> loops;
  loops.reserve(curves.size());
  for (const Eigen::MatrixXd& curve : curves)
  {
    loops.push_back(shape::TraceLoopThrough(curve, locator, paths));
  }
  return shape::ImprintCurves(mesh, loops, { snap });
}

double ComputeLoopLength(const shape::ImprintedCurves& inserted, std::size_t loop = 0)
{
  const std::vector<int>& points = inserted.Loops[loop];
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    length += (inserted.Surface.Points.row(points[(i + 1) % points.size()]) -
      inserted.Surface.Points.row(points[i]))
                .norm();
  }
  return length;
}

/// The edges of a surface, each with the number of its triangles.
std::map<std::pair<int, int>, int> EdgesOf(const shape::Mesh& mesh)
{
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      ++edges[std::minmax(t(k), t((k + 1) % 3))];
    }
  }
  return edges;
}

/// That it is the same surface, and each loop a closed way along its edges.
void ExpectSameShape(const shape::Mesh& mesh, const shape::ImprintedCurves& inserted)
{
  const Eigen::Index given = mesh.Points.rows();
  const shape::Provenance& provenance = inserted.Provenance;
  ASSERT_EQ(inserted.Surface.Points.rows(), provenance.Points.size());
  EXPECT_EQ(inserted.Surface.Points.topRows(given), mesh.Points);
  const shape::Topology before = shape::ComputeTopology(mesh);
  const shape::Topology after = shape::ComputeTopology(inserted.Surface);
  EXPECT_EQ(after.EulerNumber, before.EulerNumber);
  EXPECT_EQ(after.Components, before.Components);
  EXPECT_EQ(after.BoundaryLoops, before.BoundaryLoops);
  EXPECT_EQ(after.NonManifoldEdges, before.NonManifoldEdges);
  EXPECT_EQ(after.NonManifoldPoints, before.NonManifoldPoints);
  EXPECT_EQ(after.MisorientedEdges, before.MisorientedEdges);
  EXPECT_EQ((after.ComponentId.array() < 0).count(), (before.ComponentId.array() < 0).count());
  // The area vectors of the parts add up to the triangle's, and none points the other way.
  const Eigen::MatrixXd whole = shape::ComputeAreaVectors(mesh);
  const Eigen::MatrixXd parts = shape::ComputeAreaVectors(inserted.Surface);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(whole.rows(), 3);
  const double size = std::pow(shape::ComputeBoxDiagonal(mesh.Points), 2);
  for (Eigen::Index i = 0; i < parts.rows(); ++i)
  {
    const int original = provenance.Cells(i);
    sums.row(original) += parts.row(i);
    EXPECT_GE(parts.row(i).dot(whole.row(original)), -1e-14 * size * whole.row(original).norm());
  }
  EXPECT_LT((sums - whole).cwiseAbs().maxCoeff(), 1e-14 * size);
  EXPECT_EQ(provenance.Points.head(given),
    Eigen::VectorXi::LinSpaced(given, 0, static_cast<int>(given) - 1));
  EXPECT_TRUE((provenance.Points.tail(provenance.Points.size() - given).array() == -1).all());
  EXPECT_GE(provenance.Weights.coeffs().minCoeff(), 0.0);
  EXPECT_LT(
    (provenance.Weights * Eigen::VectorXd::Ones(given)).array().abs().maxCoeff(), 1 + 1e-15);
  EXPECT_LT((provenance.Weights * mesh.Points - inserted.Surface.Points).cwiseAbs().maxCoeff(),
    1e-15 * (1.0 + mesh.Points.cwiseAbs().maxCoeff()));
  // Each new point lies in the triangles whose parts have it.
  for (Eigen::Index i = 0; i < parts.rows(); ++i)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(provenance.Cells(i));
    for (const int point : inserted.Surface.Triangles.row(i))
    {
      double sum = 0.0;
      for (const int corner : corners)
      {
        sum += provenance.Weights.coeff(point, corner);
      }
      EXPECT_NEAR(sum, 1.0, 1e-15);
    }
  }
  const auto edges = EdgesOf(inserted.Surface);
  for (const std::vector<int>& loop : inserted.Loops)
  {
    EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      EXPECT_EQ(edges.count(std::minmax(loop[i], loop[(i + 1) % loop.size()])), 1U);
    }
  }
}

/// How many parts the surface falls into along the loops.
int PartsAlong(const shape::ImprintedCurves& inserted)
{
  std::vector<std::array<int, 2>> cut;
  for (const std::vector<int>& loop : inserted.Loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      cut.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  }
  return shape::ComputeTopology(shape::CutAlongEdges(inserted.Surface, cut).Surface).Components;
}

} // namespace

TEST(LoopInsertion, ACircleInThePlane)
{
  const shape::Mesh plane = shapetest::FlatSquare(30, 0.3);
  const Eigen::MatrixXd circle = Circle({ 0.1, -0.05, 0.2 }, { 0.6, 0, 0 }, { 0, 0.6, 0 }, 400);
  const shape::ImprintedCurves inserted = Insert(plane, { circle }, 0.0);
  ExpectSameShape(plane, inserted);
  ASSERT_EQ(inserted.Loops.size(), 1U);
  EXPECT_NEAR(ComputeLoopLength(inserted), 400 * 1.2 * std::sin(M_PI / 400), 1e-10);
  EXPECT_EQ(PartsAlong(inserted), 2);
  // Moved to points and edges that are near it is not far away.
  const shape::ImprintedCurves moved = Insert(plane, { circle });
  ExpectSameShape(plane, moved);
  EXPECT_NEAR(ComputeLoopLength(moved), 1.2 * M_PI, 0.12);
  EXPECT_LT(moved.Surface.Points.rows(), inserted.Surface.Points.rows());
}

TEST(LoopInsertion, WithinOneTriangle)
{
  const shape::Mesh sphere = shapetest::Icosphere(0);
  const Eigen::Matrix3d corners = shape::GetCorners(sphere, 4);
  Eigen::MatrixXd small(4, 3);
  small << 0.5, 0.3, 0.2, 0.2, 0.5, 0.3, 0.3, 0.2, 0.5, 0.4, 0.3, 0.3;
  const shape::ImprintedCurves inserted = Insert(sphere, { small * corners });
  ExpectSameShape(sphere, inserted);
  EXPECT_EQ(inserted.Loops.at(0).size(), 4U);
  EXPECT_EQ(inserted.Surface.Triangles.rows(), 20 + 8);
  EXPECT_EQ(PartsAlong(inserted), 2);
}

TEST(LoopInsertion, AlongEdgesNothingIsSplit)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  // The ring around a point, every other of its points.
  const shape::ImprintedCurves ring = Insert(sphere,
    { [&]
      {
        std::vector<int> around;
        const auto edges = EdgesOf(sphere);
        for (const auto& [edge, count] : edges)
        {
          if (edge.first == 20)
          {
            around.push_back(edge.second);
          }
          else if (edge.second == 20)
          {
            around.push_back(edge.first);
          }
        }
        const Eigen::RowVector3d axis = sphere.Points.row(20);
        const Eigen::RowVector3d u = axis.unitOrthogonal(), v = axis.cross(u);
        std::sort(around.begin(), around.end(),
          [&](int a, int b)
          {
            const auto angle = [&](int i)
            { return std::atan2(sphere.Points.row(i).dot(v), sphere.Points.row(i).dot(u)); };
            return angle(a) < angle(b);
          });
        return Eigen::MatrixXd(sphere.Points(around, Eigen::all));
      }() });
  EXPECT_EQ(ring.Surface.Points.rows(), sphere.Points.rows());
  EXPECT_EQ(ring.Surface.Triangles, sphere.Triangles);
  EXPECT_EQ(PartsAlong(ring), 2);
}

TEST(LoopInsertion, ALoopThatCrossesItself)
{
  const shape::Mesh plane = shapetest::FlatSquare(20, 0.3);
  const int count = 200;
  Eigen::MatrixXd eight(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * (i + 0.5) / count;
    eight.row(i) << 0.8 * std::sin(angle), 0.5 * std::sin(2.0 * angle) + 0.1 * std::sin(angle), 0;
  }
  const shape::ImprintedCurves inserted = Insert(plane, { eight });
  ExpectSameShape(plane, inserted);
  EXPECT_EQ(inserted.Loops.size(), 2U);
  EXPECT_EQ(inserted.LoopIds, (std::vector<int>{ 0, 0 }));
  EXPECT_GE(ComputeLoopLength(inserted, 0), ComputeLoopLength(inserted, 1));
  EXPECT_EQ(PartsAlong(inserted), 3);

  // Three times around, on ever smaller circles: two loops inside.
  Eigen::MatrixXd spiral(300, 3);
  for (int i = 0; i < 300; ++i)
  {
    const double angle = 2.0 * M_PI * i / 100, radius = 0.8 - 0.002 * std::min(i, 200);
    spiral.row(i) << radius * std::cos(angle), radius * std::sin(angle), 0;
  }
  const shape::ImprintedCurves turned = Insert(plane, { spiral });
  ExpectSameShape(plane, turned);
  EXPECT_GE(turned.Loops.size(), 1U);
}

TEST(LoopInsertion, ALoopThereAndBackEnclosesNothing)
{
  const shape::Mesh plane = shapetest::FlatSquare(10, 0.0);
  Eigen::MatrixXd way(4, 3);
  way << -0.5, 0.03, 0, 0, 0.03, 0, 0.5, 0.03, 0, 0, 0.03, 0;
  EXPECT_THROW(Insert(plane, { way }), shape::InvalidInput);
  EXPECT_THROW(Insert(plane, { way.topRows(2) }), shape::InvalidInput);
  EXPECT_THROW(Insert(plane, { way }, 0.7), shape::InvalidInput);
}

TEST(LoopInsertion, TrianglesWithoutArea)
{
  // A strip whose middle triangles have their points on one line.
  shape::Mesh strip{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(7, 3) };
  strip.Points << 0, 0, 0, 3, 0, 0, 3, 2, 0, 0, 2, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 3, 1, 0;
  strip.Triangles << 0, 1, 7, 0, 7, 4, 4, 7, 5, 5, 7, 6, 4, 5, 3, 5, 6, 3, 6, 7, 3;
  strip.Triangles.conservativeResize(8, 3);
  strip.Triangles.row(7) << 7, 2, 3;
  const Eigen::MatrixXd circle = Circle({ 1.45, 1.02, 0 }, { 0.8, 0, 0 }, { 0, 0.7, 0 }, 60);
  const shape::ImprintedCurves inserted = Insert(strip, { circle }, 0.01);
  ExpectSameShape(strip, inserted);
  EXPECT_EQ(PartsAlong(inserted), 2);
}

TEST(LoopInsertion, RandomLoopsOnModels)
{
  for (const char* name : { "bear", "elephant", "fandisk", "joint", "cow" })
  {
    const shape::Mesh mesh = shapetest::ReadModel(name);
    const double size = shape::ComputeBoxDiagonal(mesh.Points);
    const shape::SurfaceLocator locator(mesh);
    shape::SurfacePaths paths(mesh);
    std::mt19937 random(3);
    for (int i = 0; i < 12; ++i)
    {
      // A few clicks around a place.
      const Eigen::RowVector3d middle = mesh.Points.row(random() % mesh.Points.rows());
      const Eigen::RowVector3d normal =
        shape::ComputeAreaVectors(mesh).row(locator.FindOne(middle).Triangle);
      const Eigen::RowVector3d u = normal.unitOrthogonal();
      const Eigen::RowVector3d v = normal.normalized().cross(u);
      const double radius = size * (0.02 + 0.01 * (i % 8));
      const Eigen::MatrixXd clicks = Circle(middle, radius * u, radius * v, i % 2 == 0 ? 8 : 100);
      const shape::ImprintedCurves inserted = shape::ImprintCurves(
        mesh, { shape::TraceLoopThrough(clicks, locator, paths) }, { i % 3 == 0 ? 0.0 : 0.05 });
      ExpectSameShape(mesh, inserted);
      EXPECT_GE(inserted.Loops.size(), 1U);
    }
  }
}
