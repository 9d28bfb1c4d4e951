#include "Base/Errors.h"
#include "Correspondence/CommonBase/BaseDomain.h"
#include "Correspondence/CommonBase/CommonBaseMap.h"
#include "Correspondence/CommonBase/Private/BaseEmbedding.h"
#include "Correspondence/CommonBase/SurfaceCurves.h"
#include "Correspondence/Conformal/SphereCommonDomain.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geometry/Orientation.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

using shapetest::PositionsOn;

namespace
{

/// The surface of a plate of cubes with a row of square holes: genus `holes`. Each square of a cube
/// is `cells` x `cells` pairs of triangles.
shape::Mesh PlateWithHoles(int holes, int cells)
{
  const int columns = (2 * holes + 1) * cells, rows = 3 * cells, layers = cells;
  const auto isSolid = [&](int i, int j, int k)
  {
    const bool isInside = i >= 0 && i < columns && j >= 0 && j < rows && k >= 0 && k < layers;
    return isInside && !(j / cells == 1 && (i / cells) % 2 == 1);
  };
  std::map<std::array<int, 3>, int> indices;
  std::vector<std::array<int, 3>> corners;
  std::vector<std::array<int, 3>> triangles;
  const auto indexOf = [&](const std::array<int, 3>& corner)
  {
    const auto [position, isNew] = indices.emplace(corner, static_cast<int>(corners.size()));
    if (isNew)
    {
      corners.push_back(corner);
    }
    return position->second;
  };
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      for (int k = 0; k < layers; ++k)
      {
        for (int axis = 0; axis < 3 && isSolid(i, j, k); ++axis)
        {
          for (const int side : { 0, 1 })
          {
            std::array<int, 3> next{ i, j, k };
            next[axis] += side == 0 ? -1 : 1;
            if (isSolid(next[0], next[1], next[2]))
            {
              continue;
            }
            std::array<std::array<int, 3>, 4> quad;
            quad.fill({ i, j, k });
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (auto& corner : quad)
            {
              corner[axis] += side;
            }
            ++quad[1][u];
            ++quad[2][u];
            ++quad[2][v];
            ++quad[3][v];
            const std::array<int, 4> q{ indexOf(quad[0]), indexOf(quad[side == 1 ? 1 : 3]),
              indexOf(quad[2]), indexOf(quad[side == 1 ? 3 : 1]) };
            triangles.push_back({ q[0], q[1], q[2] });
            triangles.push_back({ q[0], q[2], q[3] });
          }
        }
      }
    }
  }
  shape::Mesh mesh{ Eigen::MatrixXd(corners.size(), 3), Eigen::MatrixXi(triangles.size(), 3) };
  for (std::size_t p = 0; p < corners.size(); ++p)
  {
    mesh.Points.row(p) << corners[p][0], corners[p][1], corners[p][2];
  }
  mesh.Points /= cells;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.Triangles.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return mesh;
}

/// Bent about the y axis and tapered.
shape::Mesh Bent(shape::Mesh mesh, double angle)
{
  const double width = mesh.Points.col(0).maxCoeff();
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = mesh.Points.row(i);
    const double turn = angle * p(0) / width, radius = width / angle + p(2);
    mesh.Points.row(i) << radius * std::sin(turn), p(1) * (1.0 + 0.3 * p(0) / width),
      radius * std::cos(turn);
  }
  return mesh;
}

shape::Landmarks EveryNth(const shape::Mesh& mesh, int count)
{
  shape::Landmarks landmarks;
  for (int k = 0; k < count; ++k)
  {
    const int point = static_cast<int>((k * mesh.Points.rows()) / count);
    landmarks.push_back({ point, point });
  }
  return landmarks;
}

/// Checks that the map is one to one and takes landmarks to their partners.
void ExpectOneToOne(const shape::Mesh& a, const shape::Mesh& b, const shape::Landmarks& landmarks)
{
  const shape::BaseDomain domain = shape::TraceBaseDomain(a, b, landmarks);
  // Patches with three sides each: Euler's formula for the genus.
  EXPECT_EQ(2 * domain.Paths.size(), 3 * domain.Patches.size());
  EXPECT_EQ(static_cast<int>(landmarks.size()) - static_cast<int>(domain.Paths.size()) +
      static_cast<int>(domain.Patches.size()),
    2 - 2 * domain.Genus);
  for (const auto& [given, divided] : { std::pair(&a, &domain.A), std::pair(&b, &domain.B) })
  {
    EXPECT_NEAR(shape::ComputeArea(divided->Surface), shape::ComputeArea(*given),
      1e-12 * shape::ComputeArea(*given));
    const shape::BaseEmbedding plane = shape::EmbedPatches(domain, *divided, "it");
    double area = 0.0;
    for (const shape::Mesh& patch : plane.Patches)
    {
      EXPECT_TRUE(shape::FindInvertedTriangles(patch.Triangles, patch.Points.leftCols(2)).empty());
      area += shape::ComputeArea(patch);
    }
    // No triangle is inverted, and together they are as large as their image: none overlap.
    EXPECT_NEAR(area, 0.5 * static_cast<double>(domain.Patches.size()), 1e-9);
  }
  const shape::CommonBaseMap map = shape::MapThroughBase(a, b, landmarks);
  const Eigen::MatrixXd onB = PositionsOn(map.Maps.AToB, b), onA = PositionsOn(map.Maps.BToA, a);
  for (const auto& [pointA, pointB] : landmarks)
  {
    EXPECT_EQ((onB.row(pointA) - b.Points.row(pointB)).norm(), 0.0);
    EXPECT_EQ((onA.row(pointB) - a.Points.row(pointA)).norm(), 0.0);
  }
  EXPECT_EQ(map.Flipped, 0);
  EXPECT_TRUE((map.Maps.AToB.Barycentrics.array() >= 0.0).all());
  EXPECT_TRUE((map.Maps.BToA.Barycentrics.array() >= 0.0).all());
}

/// The energy of a map of plane triangles, divided by the area; both areas are scaled to be equal.
double SymmetricDirichlet(const shape::Mesh& mesh, const Eigen::MatrixXd& images)
{
  const double scale = shape::ComputeArea(mesh) / shape::ComputeArea({ images, mesh.Triangles });
  double sum = 0.0;
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    const Eigen::Matrix3d p = shape::GetCorners(mesh, t),
                          q = shape::GetCorners({ images, mesh.Triangles }, t);
    Eigen::Matrix<double, 3, 2> from, to;
    for (int k = 0; k < 2; ++k)
    {
      from.col(k) = (p.row(k + 1) - p.row(0)).transpose();
      to.col(k) = std::sqrt(scale) * (q.row(k + 1) - q.row(0)).transpose();
    }
    const Eigen::Matrix2d one = from.transpose() * from, other = to.transpose() * to;
    sum += 0.5 * std::sqrt(one.determinant()) *
      ((one.inverse() * other).trace() + (other.inverse() * one).trace());
  }
  return sum / shape::ComputeArea(mesh);
}

/// How often a closed polyline goes around the z axis.
int TurnsAroundZ(const Eigen::MatrixXd& loop)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const Eigen::RowVector3d p = loop.row(i), q = loop.row((i + 1) % loop.rows());
    sum += std::atan2(p(0) * q(1) - p(1) * q(0), p(0) * q(0) + p(1) * q(1));
  }
  return static_cast<int>(std::lround(sum / (2.0 * M_PI)));
}

/// The distance of a position from a polyline along points of a mesh.
double DistanceToCurve(
  const Eigen::RowVector3d& p, const shape::Mesh& mesh, const std::vector<int>& curve)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    const Eigen::RowVector3d a = mesh.Points.row(curve[i - 1]),
                             edge = mesh.Points.row(curve[i]) - a;
    const double t = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * edge).norm());
  }
  return nearest;
}

/// Checks that the map is one to one, and takes landmarks to landmarks and curves onto curves.
void ExpectKept(const shape::Mesh& a, const shape::Mesh& b, const shape::Landmarks& landmarks,
  const std::vector<shape::CurvePair>& curves)
{
  const shape::CommonBaseMap map = shape::MapThroughBase(a, b, landmarks, { curves });
  EXPECT_EQ(map.Flipped, 0);
  const Eigen::MatrixXd onB = PositionsOn(map.Maps.AToB, b), onA = PositionsOn(map.Maps.BToA, a);
  for (const auto& [pointA, pointB] : landmarks)
  {
    EXPECT_EQ((onB.row(pointA) - b.Points.row(pointB)).norm(), 0.0);
    EXPECT_EQ((onA.row(pointB) - a.Points.row(pointA)).norm(), 0.0);
  }
  for (const shape::CurvePair& curve : curves)
  {
    for (const int point : curve.OnA)
    {
      EXPECT_LT(DistanceToCurve(onB.row(point), b, curve.OnB), 1e-9);
    }
    for (const int point : curve.OnB)
    {
      EXPECT_LT(DistanceToCurve(onA.row(point), a, curve.OnA), 1e-9);
    }
  }
}

/// The curve through given positions, one in each row, of two meshes.
shape::CurvePair CurveThrough(const shape::Mesh& a, const Eigen::MatrixXd& onA,
  const shape::Mesh& b, const Eigen::MatrixXd& onB)
{
  return { shape::TraceEdgeCurve(a, onA, "A"), shape::TraceEdgeCurve(b, onB, "B") };
}

/// A circle about the z axis.
Eigen::MatrixXd Circle(double radius, double height)
{
  constexpr int count = 60;
  Eigen::MatrixXd circle(count + 1, 3);
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    circle.row(i) << radius * std::cos(angle), radius * std::sin(angle), height;
  }
  circle.row(count) = circle.row(0);
  return circle;
}

/// The rim of a rectangle with two opposite corners in a plane z = height.
Eigen::MatrixXd Rim(double left, double bottom, double right, double top, double height)
{
  Eigen::MatrixXd rim(5, 3);
  rim << left, bottom, height, right, bottom, height, right, top, height, left, top, height, left,
    bottom, height;
  return rim;
}

} // namespace

TEST(CommonBase, ASurfaceAndItselfGiveTheIdentity)
{
  for (const shape::Mesh& mesh : { shapetest::Pebble(shapetest::Icosphere(3)),
         shapetest::Torus(1.0, 0.4, 30, 16), PlateWithHoles(2, 3) })
  {
    const shape::CommonBaseMap map = shape::MapThroughBase(mesh, mesh, EveryNth(mesh, 5));
    EXPECT_LT((PositionsOn(map.Maps.AToB, mesh) - mesh.Points).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((PositionsOn(map.Maps.BToA, mesh) - mesh.Points).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(map.Energy, 4.0, 1e-9);
  }
}

TEST(CommonBase, IsOneToOneForEachGenus)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  ExpectOneToOne(shapetest::Pebble(sphere), sphere, EveryNth(sphere, 7));
  for (const int holes : { 1, 2, 3 })
  {
    const shape::Mesh plate = PlateWithHoles(holes, 2);
    ExpectOneToOne(plate, Bent(plate, 2.0), EveryNth(plate, 4 + 2 * holes));
  }
}

TEST(CommonBase, MapsBetweenDifferentMeshes)
{
  // The points of the finer plate at even indices are those of the coarser one.
  const shape::Mesh coarse = PlateWithHoles(2, 2), fine = Bent(PlateWithHoles(2, 4), 1.0);
  const shape::Mesh straight = PlateWithHoles(2, 4);
  shape::Landmarks landmarks;
  for (const auto& landmark : EveryNth(coarse, 8))
  {
    Eigen::Index partner = 0;
    (straight.Points.rowwise() - coarse.Points.row(landmark[0]))
      .rowwise()
      .squaredNorm()
      .minCoeff(&partner);
    landmarks.push_back({ landmark[0], static_cast<int>(partner) });
  }
  ExpectOneToOne(coarse, fine, landmarks);
}

TEST(CommonBase, DistortsLessThanTheCommonSphere)
{
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  shape::Mesh b = a;
  for (Eigen::Index i = 0; i < b.Points.rows(); ++i)
  {
    const double turn = 0.5 * a.Points(i, 2);
    b.Points(i, 0) = std::cos(turn) * a.Points(i, 0) - std::sin(turn) * a.Points(i, 1);
    b.Points(i, 1) = std::sin(turn) * a.Points(i, 0) + std::cos(turn) * a.Points(i, 1);
  }
  const shape::Landmarks landmarks = EveryNth(a, 8);
  const shape::CommonBaseMap base = shape::MapThroughBase(a, b, landmarks);
  const auto sphere =
    shape::MapThroughSphere(a, shape::PointsOf(landmarks, 0), b, shape::PointsOf(landmarks, 1));
  EXPECT_EQ(base.Flipped, 0);
  const double ours = SymmetricDirichlet(a, PositionsOn(base.Maps.AToB, b));
  EXPECT_GE(ours, 4.0);
  EXPECT_LT(ours, SymmetricDirichlet(a, PositionsOn(sphere.AToB, b)));
}

TEST(CommonBase, HandleLoopsGoToHandleLoopsWhereTunnelLoopsAreShorter)
{
  // Around the tube of the first torus it is shorter than through its hole; of the second one, it
  // is longer.
  constexpr int around = 36, across = 18;
  const shape::Mesh thin = shapetest::Torus(1.0, 0.3, around, across),
                    thick = shapetest::Torus(1.0, 0.85, around, across);
  const shape::CommonBaseMap map = shape::MapThroughBase(thin, thick, EveryNth(thin, 6));
  const Eigen::MatrixXd images = PositionsOn(map.Maps.AToB, thick);
  std::vector<int> handle, tunnel;
  const double step = 2.0 * M_PI / around;
  for (Eigen::Index i = 0; i < thin.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = thin.Points.row(i);
    const double angle = std::atan2(p(1), p(0));
    if (std::abs(angle) < 0.1 * step)
    {
      handle.push_back(static_cast<int>(i));
    }
    if (std::abs(p(2)) < 1e-9 && p.norm() > 1.0)
    {
      tunnel.push_back(static_cast<int>(i));
    }
  }
  ASSERT_EQ(handle.size(), static_cast<std::size_t>(across));
  ASSERT_EQ(tunnel.size(), static_cast<std::size_t>(around));
  EXPECT_EQ(TurnsAroundZ(images(handle, Eigen::all)), 0);
  EXPECT_EQ(
    TurnsAroundZ(images(tunnel, Eigen::all)), TurnsAroundZ(thin.Points(tunnel, Eigen::all)));
}

TEST(CommonBase, CurvesGoOntoCurvesOnSpheres)
{
  const shape::Mesh sphere = shapetest::Icosphere(3), pebble = shapetest::Pebble(sphere);
  const shape::Landmarks landmarks = EveryNth(sphere, 7);
  Eigen::MatrixXd arc(3, 3), meridian(2, 3);
  arc << sphere.Points.row(landmarks[0][0]), 0.0, 0.0, 1.0, sphere.Points.row(landmarks[3][0]);
  const std::vector<int> along = shape::TraceEdgeCurve(sphere, arc, "A");
  // The two ends of a curve are landmarks; a circle has none.
  const std::vector<int> circle = shape::TraceEdgeCurve(sphere, Circle(0.9, -0.4), "A");
  ExpectKept(sphere, pebble, landmarks, { { along, along } });
  ExpectKept(sphere, pebble, landmarks, { { circle, circle } });
  // The images slide along the circle of another radius, on a mesh that is not that of A.
  const shape::Mesh fine = shapetest::Icosphere(4);
  shape::Landmarks pair;
  for (const int point : { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 })
  {
    pair.push_back({ point, point });
  }
  ExpectKept(sphere, fine, pair,
    { CurveThrough(sphere, Circle(0.8, -0.2), fine, Circle(0.9, -0.4)),
      CurveThrough(sphere, Circle(0.8, 0.6), fine, Circle(0.7, 0.7)) });
}

TEST(CommonBase, CurvesGoOntoCurvesAroundHandles)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 20, 12),
                    thin = shapetest::Torus(1.0, 0.3, 20, 12);
  // Around the hole outside and inside, and around the tube.
  const auto across = [](double minor)
  {
    Eigen::MatrixXd circle(31, 3);
    for (int i = 0; i <= 30; ++i)
    {
      const double angle = 2.0 * M_PI * i / 30;
      circle.row(i) << 1.0 + minor * std::cos(angle), 0.0, minor * std::sin(angle);
    }
    circle.row(30) = circle.row(0);
    return circle;
  };
  shape::Landmarks landmarks = EveryNth(torus, 5);
  const shape::CurvePair outside = CurveThrough(torus, Circle(1.4, 0.0), thin, Circle(1.3, 0.0)),
                         inside = CurveThrough(torus, Circle(0.6, 0.0), thin, Circle(0.7, 0.0)),
                         tube = CurveThrough(torus, across(0.4), thin, across(0.3));
  ExpectKept(torus, thin, landmarks, { outside });
  ExpectKept(torus, thin, landmarks, { tube });
  ExpectKept(torus, thin, landmarks, { outside, inside });
  // These cross at a point, which must be a landmark: they begin there.
  ExpectKept(torus, thin, landmarks, { outside, tube });
  for (const int holes : { 1, 2, 3 })
  {
    const shape::Mesh plate = PlateWithHoles(holes, 2), bent = Bent(plate, 2.0);
    std::vector<shape::CurvePair> rims;
    for (const double height : { 0.0, 1.0 })
    {
      for (const Eigen::MatrixXd& rim :
        { Rim(0.0, 0.0, 2.0 * holes + 1.0, 3.0, height), Rim(1.0, 1.0, 2.0, 2.0, height) })
      {
        const std::vector<int> curve = shape::TraceEdgeCurve(plate, rim, "A");
        rims.push_back({ curve, curve });
      }
    }
    ExpectKept(plate, bent, EveryNth(plate, 4 + 2 * holes), rims);
  }
}

TEST(CommonBase, RefusesCurvesThatCannotBeKept)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Landmarks landmarks = EveryNth(sphere, 7);
  const auto curve = [&](const Eigen::MatrixXd& positions)
  { return shape::TraceEdgeCurve(sphere, positions, "A"); };
  Eigen::MatrixXd west(2, 3), south(2, 3);
  west << -0.6, 0.0, 0.8, 0.6, 0.0, 0.8;
  south << 0.0, -0.6, 0.8, 0.0, 0.6, 0.8;
  const std::vector<int> one = curve(west), other = curve(south), circle = curve(Circle(0.9, -0.4));
  const auto trace = [&](const std::vector<shape::CurvePair>& curves)
  { return shape::TraceBaseDomain(sphere, sphere, landmarks, curves); };
  EXPECT_REFUSED(trace({ { one, one }, { other, other } }), "curve 0 and curve 1 meet at point");
  EXPECT_REFUSED(trace({ { one, one }, { one, one } }), "which a curve has passed");
  EXPECT_REFUSED(trace({ { one, circle } }), "closed on one surface only");
  EXPECT_REFUSED(trace({ { { 0, 1 }, one } }), "does not follow edges of SurfaceA");
  // A torus on which one loop is a handle loop, and its partner a tunnel loop.
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 30, 16);
  Eigen::MatrixXd tube(5, 3);
  tube << 1.4, 0.0, 0.0, 1.0, 0.0, 0.4, 0.6, 0.0, 0.0, 1.0, 0.0, -0.4, 1.4, 0.0, 0.0;
  EXPECT_REFUSED(shape::TraceBaseDomain(torus, torus, { { 37, 37 }, { 53, 53 } },
                   { CurveThrough(torus, Circle(1.4, 0.0), torus, tube) }),
    "does not bound alike on both surfaces");
}

TEST(CommonBase, RefusesWhatHasNoCommonBase)
{
  const shape::Mesh sphere = shapetest::Icosphere(2), torus = shapetest::Torus(1.0, 0.3, 20, 10);
  EXPECT_REFUSED(shape::TraceBaseDomain(sphere, torus, EveryNth(sphere, 4)), "have genus 0 and 1");
  EXPECT_REFUSED(shape::TraceBaseDomain(sphere, sphere, EveryNth(sphere, 2)), "needs 3");
  EXPECT_REFUSED(shape::TraceBaseDomain(torus, torus, EveryNth(torus, 1)), "needs 2");
  EXPECT_REFUSED(
    shape::TraceBaseDomain(shapetest::FlatDisk(3), sphere, EveryNth(sphere, 4)), "SurfaceA");
}
