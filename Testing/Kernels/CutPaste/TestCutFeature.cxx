#include "Base/Errors.h"
#include "CutPaste/CutFeature.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Support/CurveShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using shapetest::Circle;

double AreaOf(const shape::Mesh& mesh)
{
  return 0.5 * shape::ComputeAreaVectors(mesh).rowwise().norm().sum();
}

shape::CutFeatureOptions WithoutFill(shape::LoopSide side = shape::LoopSide::Smaller)
{
  shape::CutFeatureOptions options;
  options.Side = side;
  options.FillHole = false;
  return options;
}

/// Triangles of a part that are the surface's; those of fills come after them.
Eigen::Index CountKept(const shape::CutFeatureResult& cut, const shape::DividedPart& part)
{
  return &part == &cut.Rest && !cut.Holes.empty() ? cut.Holes.front().FirstTriangle
                                                  : part.Surface.Triangles.rows();
}

/// That the parts are those of the surface: their areas add up, and their points are its own or on
/// its triangles.
void ExpectPartsOf(const shape::Mesh& mesh, const shape::CutFeatureResult& cut)
{
  double area = 0.0;
  for (const shape::DividedPart* part : { &cut.Feature, &cut.Rest })
  {
    const shape::Mesh& own = part->Surface;
    const Eigen::MatrixXd areas = shape::ComputeAreaVectors(own);
    const shape::Provenance& provenance = part->Provenance;
    ASSERT_EQ(provenance.Points.size(), own.Points.rows());
    ASSERT_EQ(provenance.Cells.size(), own.Triangles.rows());
    area += 0.5 * areas.topRows(CountKept(cut, *part)).rowwise().norm().sum();
    const Eigen::MatrixXd sources = provenance.Weights * mesh.Points;
    for (Eigen::Index i = 0; i < own.Points.rows(); ++i)
    {
      const int original = provenance.Points(i);
      if (original >= 0)
      {
        EXPECT_EQ(own.Points.row(i), mesh.Points.row(original));
      }
      if (part->Ids[i] >= 0)
      {
        EXPECT_LT((sources.row(i) - own.Points.row(i)).norm(),
          1e-14 * (1.0 + mesh.Points.cwiseAbs().maxCoeff()));
      }
    }
  }
  EXPECT_NEAR(area, AreaOf(mesh), 1e-11 * AreaOf(mesh));
}

/// The feature of a manifold surface, cut along one loop and not filled: Euler numbers add up, as
/// does the border.
void ExpectDivided(const shape::Mesh& mesh, const shape::CutFeatureResult& cut)
{
  ExpectPartsOf(mesh, cut);
  const shape::Topology before = shape::ComputeTopology(mesh);
  const shape::Topology feature = shape::RequireManifold(cut.Feature.Surface, "the feature");
  const shape::Topology rest = shape::RequireManifold(cut.Rest.Surface, "the rest");
  EXPECT_EQ(feature.EulerNumber + rest.EulerNumber, before.EulerNumber);
  EXPECT_EQ(feature.BoundaryLoops + rest.BoundaryLoops, before.BoundaryLoops + 2);
}

} // namespace

TEST(CutFeature, ADiskFromAPlane)
{
  const shape::Mesh plane = shapetest::FlatSquare(30, 0.3);
  const Eigen::MatrixXd circle = Circle({ 0.1, -0.2, 0.3 }, { 0.6, 0, 0 }, { 0, 0.6, 0 }, 300);
  shape::CutFeatureOptions options = WithoutFill();
  options.SnapShare = 0.0;
  const shape::CutFeatureResult cut = shape::CutFeature(plane, { circle }, options);
  ExpectDivided(plane, cut);
  EXPECT_NEAR(AreaOf(cut.Feature.Surface), 150 * 0.36 * std::sin(2 * M_PI / 300), 1e-10);
  EXPECT_NEAR(cut.CutLength, 300 * 1.2 * std::sin(M_PI / 300), 1e-10);
  EXPECT_EQ(cut.Loops, 1);
  EXPECT_EQ(cut.LoopsLeftOut, 0);
  EXPECT_TRUE(cut.Bases.empty());
  // Moved to points and edges nearby it is as large but for a twentieth of an edge.
  EXPECT_NEAR(AreaOf(shape::CutFeature(plane, { circle }, WithoutFill()).Feature.Surface),
    0.36 * M_PI, 1.2 * M_PI * 0.05 * 0.1);
}

TEST(CutFeature, ACapFromASphereAndItsSides)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const double angle = 0.5;
  // Counter-clockwise seen from outside: the cap is on the left.
  const Eigen::MatrixXd circle =
    Circle({ 0, 0, std::cos(angle) }, { std::sin(angle), 0, 0 }, { 0, std::sin(angle), 0 }, 200);
  const double cap = 2.0 * M_PI * (1.0 - std::cos(angle));
  using Side = shape::LoopSide;
  for (const Side side : { Side::Smaller, Side::Larger, Side::Left, Side::Right })
  {
    const shape::CutFeatureResult cut = shape::CutFeature(sphere, { circle }, WithoutFill(side));
    ExpectDivided(sphere, cut);
    const bool isCap = side == Side::Smaller || side == Side::Left;
    EXPECT_NEAR(AreaOf(cut.Feature.Surface), isCap ? cap : 4.0 * M_PI - cap, 0.02);
  }
  const shape::CutFeatureResult turned = shape::CutFeature(
    sphere, { Eigen::MatrixXd(circle.colwise().reverse()) }, WithoutFill(Side::Right));
  EXPECT_NEAR(AreaOf(turned.Feature.Surface), cap, 0.02);
}

TEST(CutFeature, SeveralLoops)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const auto around = [](double height)
  {
    const double radius = std::sqrt(1.0 - height * height);
    return Circle({ 0, 0, height }, { radius, 0, 0 }, { 0, radius, 0 }, 100);
  };
  // A belt between two, as large as its height by Archimedes.
  const shape::CutFeatureResult belt =
    shape::CutFeature(sphere, { around(0.3), around(-0.2) }, WithoutFill());
  ExpectPartsOf(sphere, belt);
  EXPECT_NEAR(AreaOf(belt.Feature.Surface), 2.0 * M_PI * 0.5, 0.03);
  EXPECT_EQ(shape::ComputeTopology(belt.Feature.Surface).EulerNumber, 0);
  EXPECT_EQ(shape::ComputeTopology(belt.Rest.Surface).Components, 2);
  EXPECT_EQ(belt.Loops, 2);
  // One of the two.
  shape::CutFeatureOptions options = WithoutFill();
  options.LoopIndex = 1;
  const shape::CutFeatureResult one =
    shape::CutFeature(sphere, { around(0.3), around(-0.2) }, options);
  EXPECT_NEAR(AreaOf(one.Feature.Surface), 2.0 * M_PI * 0.8, 0.03);
  // Two caps of two spheres, and another sphere.
  shape::Mesh many{ Eigen::MatrixXd(3 * sphere.Points.rows(), 3),
    Eigen::MatrixXi(3 * sphere.Triangles.rows(), 3) };
  const Eigen::RowVector3d shift(3, 0, 0);
  const auto n = static_cast<int>(sphere.Points.rows());
  many.Points << sphere.Points, sphere.Points.rowwise() + shift,
    sphere.Points.rowwise() + 2.0 * shift;
  many.Triangles << sphere.Triangles, sphere.Triangles.array() + n,
    sphere.Triangles.array() + 2 * n;
  const shape::CutFeatureResult caps =
    shape::CutFeature(many, { around(0.5), around(-0.5).rowwise() + shift }, WithoutFill());
  ExpectPartsOf(many, caps);
  EXPECT_NEAR(AreaOf(caps.Feature.Surface), 2.0 * M_PI, 0.04);
  EXPECT_EQ(shape::ComputeTopology(caps.Rest.Surface).Components, 3);
}

TEST(CutFeature, ALoopAroundAHandleNeedsAnother)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.3, 60, 24);
  const auto across = [](double angle)
  {
    const Eigen::RowVector3d u(std::cos(angle), std::sin(angle), 0);
    return Circle(u, 0.3 * u, { 0, 0, 0.3 }, 60);
  };
  EXPECT_THROW(shape::CutFeature(torus, { across(0.1) }, WithoutFill()), shape::InvalidInput);
  const shape::CutFeatureResult tube =
    shape::CutFeature(torus, { across(0.1), across(1.1) }, WithoutFill());
  ExpectPartsOf(torus, tube);
  EXPECT_NEAR(AreaOf(tube.Feature.Surface), 2.0 * M_PI * 0.3, 0.05);
  EXPECT_EQ(shape::ComputeTopology(tube.Feature.Surface).EulerNumber, 0);
}

TEST(CutFeature, ALoopThatTouchesItselfCutsItsLongestPart)
{
  const shape::Mesh plane = shapetest::FlatSquare(20, 0.3);
  Eigen::MatrixXd eight(200, 3);
  for (int i = 0; i < 200; ++i)
  {
    const double angle = 2.0 * M_PI * (i + 0.5) / 200;
    const double x = 0.5 * std::sin(angle);
    eight.row(i) << x * (x > 0.0 ? 1.5 : 1.0), 0.4 * std::sin(2.0 * angle), 0;
  }
  const shape::CutFeatureResult cut = shape::CutFeature(plane, { eight }, WithoutFill());
  ExpectDivided(plane, cut);
  EXPECT_EQ(cut.LoopsLeftOut, 1);
  EXPECT_NEAR(AreaOf(cut.Feature.Surface), 0.75 * 0.4 * 4.0 / 3.0, 0.02); // a lobe
  EXPECT_GT(cut.Feature.Surface.Points.col(0).minCoeff(), -0.05);
}

TEST(CutFeature, AtTheBorder)
{
  const shape::Mesh plane = shapetest::FlatSquare(10, 0.2);
  // It leaves the plane; there it runs along the border.
  const Eigen::MatrixXd outside = Circle({ 1.0, 0.1, 0 }, { 0.5, 0, 0 }, { 0, 0.5, 0 }, 100);
  const shape::CutFeatureResult notch =
    shape::CutFeature(plane, { outside }, shape::CutFeatureOptions());
  ExpectPartsOf(plane, notch);
  EXPECT_EQ(notch.Loops, 0);
  EXPECT_TRUE(notch.Holes.empty());
  EXPECT_EQ(shape::RequireManifold(notch.Feature.Surface, "the feature").BoundaryLoops, 1);
  EXPECT_EQ(shape::RequireManifold(notch.Rest.Surface, "the rest").BoundaryLoops, 1);
  EXPECT_NEAR(AreaOf(notch.Feature.Surface), 0.125 * M_PI, 0.02);
  // It touches the border at one point: the hole is filled, or that point is doubled.
  Eigen::MatrixXd touching(4, 3);
  touching << 1, 0.2, 0, 0.4, 0.6, 0, 0.2, 0.2, 0, 0.4, -0.2, 0;
  const shape::CutFeatureResult open = shape::CutFeature(plane, { touching }, WithoutFill());
  ExpectPartsOf(plane, open);
  EXPECT_EQ(shape::RequireManifold(open.Rest.Surface, "the rest").BoundaryLoops, 1);
  const shape::CutFeatureResult filled =
    shape::CutFeature(plane, { touching }, shape::CutFeatureOptions());
  EXPECT_EQ(filled.Holes.size(), 1U);
  EXPECT_EQ(shape::RequireManifold(filled.Rest.Surface, "the rest").EulerNumber, 1);
  // All around.
  Eigen::MatrixXd rim(4, 3);
  rim << -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0;
  EXPECT_THROW(shape::CutFeature(plane, { rim }, WithoutFill()), shape::InvalidInput);
}

TEST(CutFeature, WhatIsLeftIsFilled)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const double angle = 0.4;
  const Eigen::MatrixXd circle =
    Circle({ std::cos(angle), 0, 0 }, { 0, std::sin(angle), 0 }, { 0, 0, std::sin(angle) }, 60);
  const shape::CutFeatureResult cut =
    shape::CutFeature(sphere, { circle }, shape::CutFeatureOptions());
  ExpectPartsOf(sphere, cut);
  ASSERT_EQ(cut.Holes.size(), 1U);
  EXPECT_EQ(shape::RequireClosedSurface(cut.Rest.Surface, "the rest").EulerNumber, 2);
  EXPECT_EQ(shape::RequireManifold(cut.Feature.Surface, "the feature").BoundaryLoops, 1);
  // The fill goes on as the sphere does, and so the base is that of the sphere: a circle in the
  // plane as long as its meridians, and normals that point away from the middle.
  EXPECT_LT((cut.Rest.Surface.Points.rowwise().norm().array() - 1.0).abs().maxCoeff(), 0.01);
  ASSERT_FALSE(cut.Bases.empty());
  EXPECT_LT((cut.Bases[0].Origin - Eigen::RowVector3d(1, 0, 0)).norm(), 0.02);
  const std::vector<int>& loop = cut.Bases[0].Loop;
  EXPECT_EQ(loop, shape::FindManifoldBoundaryLoops(cut.Feature.Surface).front());
  const Eigen::MatrixXd positions = cut.Feature.Surface.Points(loop, Eigen::all);
  EXPECT_LT((cut.Bases[0].LoopPositions.rowwise().norm().array() - angle).abs().maxCoeff(), 0.03);
  EXPECT_LT((cut.Bases[0].Normals - positions).rowwise().norm().maxCoeff(), 0.05);
  EXPECT_GT(cut.Bases[0].Normal.dot(cut.Bases[0].Origin), 0.99);
  // Holes that were there stay.
  shape::Mesh open = sphere;
  open.Triangles = sphere.Triangles.bottomRows(sphere.Triangles.rows() - 1);
  const shape::CutFeatureResult of =
    shape::CutFeature(open, { circle }, shape::CutFeatureOptions());
  EXPECT_EQ(shape::RequireManifold(of.Rest.Surface, "the rest").BoundaryLoops, 1);
}

TEST(CutFeature, SelectedTriangles)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const Eigen::MatrixXd midpoints = shape::ComputeCentroids(sphere);
  std::vector<char> isSelected(sphere.Triangles.rows());
  for (std::size_t t = 0; t < isSelected.size(); ++t)
  {
    isSelected[t] = static_cast<char>(midpoints(static_cast<Eigen::Index>(t), 2) > 0.8);
  }
  const shape::CutFeatureResult cut =
    shape::CutFeature(sphere, isSelected, shape::CutFeatureOptions());
  ExpectPartsOf(sphere, cut);
  EXPECT_EQ(
    cut.Feature.Surface.Triangles.rows(), std::count(isSelected.begin(), isSelected.end(), 1));
  EXPECT_EQ(shape::RequireClosedSurface(cut.Rest.Surface, "the rest").EulerNumber, 2);
  EXPECT_FALSE(cut.Bases.empty());
  EXPECT_GE(cut.Feature.Provenance.Points.minCoeff(), 0);
  EXPECT_THROW(
    shape::CutFeature(sphere, std::vector<char>(isSelected.size(), 0)), shape::InvalidInput);
  EXPECT_THROW(
    shape::CutFeature(sphere, std::vector<char>(isSelected.size(), 1)), shape::InvalidInput);
}

TEST(CutFeature, SeamsSoupsAndTrianglesWithoutArea)
{
  // Every triangle with points of its own, some of them a line or a point.
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::Index count = sphere.Triangles.rows();
  shape::Mesh soup{ Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(count + 2, 3) };
  for (Eigen::Index t = 0; t < count; ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(sphere, t);
    soup.Triangles.row(t) << static_cast<int>(3 * t), static_cast<int>(3 * t + 1),
      static_cast<int>(3 * t + 2);
  }
  soup.Triangles.row(count) << 5, 5, 7;
  soup.Triangles.row(count + 1) << 9, 9, 9;
  const Eigen::MatrixXd circle = Circle({ 0, 0.8, 0 }, { 0.6, 0, 0 }, { 0, 0, 0.6 }, 50);
  const shape::CutFeatureResult whole =
    shape::CutFeature(sphere, { circle }, shape::CutFeatureOptions());
  const shape::CutFeatureResult cut =
    shape::CutFeature(soup, { circle }, shape::CutFeatureOptions());
  ExpectPartsOf(soup, cut);
  EXPECT_EQ(cut.Feature.Surface.Triangles.rows(), whole.Feature.Surface.Triangles.rows());
  EXPECT_EQ(CountKept(cut, cut.Rest), CountKept(whole, whole.Rest));
  EXPECT_EQ(cut.CutLength, whole.CutLength);
  // The fill is that of the surface, and so is what the feature stood on.
  ASSERT_EQ(cut.Holes.size(), 1U);
  const shape::FilledHole &hole = cut.Holes[0], &wanted = whole.Holes[0];
  ASSERT_EQ(hole.Points, wanted.Points);
  EXPECT_EQ(hole.Triangles, wanted.Triangles);
  EXPECT_LT((cut.Rest.Surface.Points.middleRows(hole.FirstPoint, hole.Points) -
              whole.Rest.Surface.Points.middleRows(wanted.FirstPoint, wanted.Points))
              .rowwise()
              .norm()
              .maxCoeff(),
    1e-12);
  ASSERT_FALSE(cut.Bases.empty());
  EXPECT_EQ(cut.Bases[0].LoopPositions.rows(), whole.Bases[0].LoopPositions.rows());
  EXPECT_EQ(cut.Bases[0].ConformalRadius, 0.0);
  EXPECT_LT((cut.Bases[0].Normal - whole.Bases[0].Normal).norm(), 1e-12);
}

TEST(CutFeature, PointsWithinTheToleranceAreOne)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::MatrixXd circle = Circle({ 0, 0.8, 0 }, { 0.6, 0, 0 }, { 0, 0, 0.6 }, 50);
  // A seam at x = 0, its points moved apart by less than the tolerance, or by more.
  const Eigen::Index points = sphere.Points.rows();
  for (const double apart : { 1e-10, 1e-5 })
  {
    shape::Mesh seamed{ Eigen::MatrixXd(2 * points, 3), sphere.Triangles };
    seamed.Points << sphere.Points, sphere.Points.array() + apart;
    for (Eigen::Index t = 0; t < sphere.Triangles.rows(); ++t)
    {
      if (shape::GetCorners(sphere, t).col(0).mean() > 0.0)
      {
        seamed.Triangles.row(t).array() += static_cast<int>(points);
      }
    }
    if (apart > 1e-6)
    {
      // Two parts, and a gap that the loop crosses twice.
      const shape::CutFeatureResult across = shape::CutFeature(seamed, { circle }, WithoutFill());
      EXPECT_EQ(across.WeldedPoints, 0);
      EXPECT_EQ(across.Gaps.Count, 2);
      EXPECT_GT(across.Gaps.Widest, apart);
      EXPECT_LT(across.Gaps.Widest, 2.0 * apart);
      continue;
    }
    const shape::CutFeatureResult cut =
      shape::CutFeature(seamed, { circle }, shape::CutFeatureOptions());
    EXPECT_GT(cut.WeldedPoints, 20);
    EXPECT_EQ(cut.Loops, 1);
    EXPECT_EQ(cut.Holes.size(), 1U);
    for (const shape::DividedPart* part : { &cut.Feature, &cut.Rest })
    {
      for (Eigen::Index i = 0; i < part->Surface.Points.rows(); ++i)
      {
        const int original = part->Provenance.Points(i);
        if (original >= 0)
        {
          EXPECT_LT((part->Surface.Points.row(i) - seamed.Points.row(original)).norm(), 2 * apart);
        }
      }
    }
  }
}

TEST(CutFeature, ASeamStaysASeam)
{
  // Two halves with points of their own at x = 0, where a texture may jump.
  const shape::Mesh plane = shapetest::FlatSquare(20, 0.0);
  const Eigen::Index points = plane.Points.rows();
  shape::Mesh seamed{ Eigen::MatrixXd(2 * points, 3), plane.Triangles };
  seamed.Points << plane.Points, plane.Points;
  for (Eigen::Index t = 0; t < plane.Triangles.rows(); ++t)
  {
    if (shape::GetCorners(plane, t).col(0).mean() > 0.0)
    {
      seamed.Triangles.row(t).array() += static_cast<int>(points);
    }
  }
  const Eigen::MatrixXd circle = Circle({ 0.03, 0, 0 }, { 0.52, 0, 0 }, { 0, 0.52, 0 }, 50);
  const shape::CutFeatureResult cut =
    shape::CutFeature(seamed, { circle }, shape::CutFeatureOptions());
  ExpectPartsOf(seamed, cut);
  EXPECT_EQ(cut.Holes.size(), 1U);
  EXPECT_EQ(shape::RequireManifold(cut.Feature.Surface, "the feature").Components, 2);
  for (const shape::DividedPart* part : { &cut.Feature, &cut.Rest })
  {
    for (Eigen::Index t = 0; t < CountKept(cut, *part); ++t)
    {
      // Its points have their data from its own side.
      const bool isRight = shape::GetCorners(part->Surface, t).col(0).mean() > 0.0;
      for (const int point : part->Surface.Triangles.row(t))
      {
        const auto weights = part->Provenance.Weights.row(point);
        EXPECT_NEAR(weights.toDense().tail(points).sum(), isRight ? 1.0 : 0.0, 1e-15);
      }
    }
  }
}

TEST(CutFeature, ANonManifoldPlaceElsewhereDoesNotMatter)
{
  shape::Mesh plane = shapetest::FlatSquare(20, 0.2);
  const Eigen::Index points = plane.Points.rows(), count = plane.Triangles.rows();
  plane.Points.conservativeResize(points + 1, 3);
  plane.Points.row(points) << 0.05, 0.05, 0.3;
  plane.Triangles.conservativeResize(count + 1, 3);
  plane.Triangles.row(count) << plane.Triangles(420, 0), plane.Triangles(420, 1),
    static_cast<int>(points);
  const Eigen::RowVector3d fin = plane.Points.row(plane.Triangles(420, 0));
  const Eigen::MatrixXd circle = Circle({ fin(0), fin(1), 0 }, { 0.3, 0, 0 }, { 0, 0.3, 0 }, 40);
  const shape::CutFeatureResult cut =
    shape::CutFeature(plane, { circle }, shape::CutFeatureOptions());
  ExpectPartsOf(plane, cut);
  EXPECT_EQ(shape::ComputeTopology(cut.Feature.Surface).NonManifoldEdges, 1);
  EXPECT_EQ(shape::RequireManifold(cut.Rest.Surface, "the rest").EulerNumber, 1);
}

TEST(CutFeature, RandomLoopsOnModels)
{
  int filled = 0;
  for (const char* name : { "bull", "lion-head" })
  {
    const shape::Mesh mesh = shapetest::ReadModel(name);
    const double size = shape::ComputeBoxDiagonal(mesh.Points);
    const Eigen::MatrixXd normals = shape::ComputeAreaVectors(mesh);
    std::mt19937 random(5);
    for (int i = 0; i < 6; ++i)
    {
      const auto triangle = static_cast<Eigen::Index>(random() % mesh.Triangles.rows());
      const Eigen::RowVector3d middle = shape::GetCorners(mesh, triangle).colwise().mean();
      const Eigen::RowVector3d normal = normals.row(triangle).normalized();
      const Eigen::RowVector3d u = normal.unitOrthogonal(), v = normal.cross(u);
      const double radius = size * (0.03 + 0.01 * i);
      const Eigen::MatrixXd clicks = Circle(middle, radius * u, radius * v, i % 2 == 0 ? 8 : 60);
      SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
      const shape::CutFeatureResult open = shape::CutFeature(mesh, { clicks }, WithoutFill());
      ExpectDivided(mesh, open);
      const shape::CutFeatureResult cut =
        shape::CutFeature(mesh, { clicks }, shape::CutFeatureOptions());
      ExpectPartsOf(mesh, cut);
      const shape::Topology rest = shape::RequireManifold(cut.Rest.Surface, "the rest");
      EXPECT_EQ(rest.BoundaryLoops, shape::ComputeTopology(mesh).BoundaryLoops) << name << " " << i;
      EXPECT_FALSE(cut.Bases.empty());
      ++filled;
    }
  }
  EXPECT_EQ(filled, 12);
}

TEST(CutFeature, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::MatrixXd circle = Circle({ 0, 0, 0.8 }, { 0.6, 0, 0 }, { 0, 0.6, 0 }, 20);
  EXPECT_THROW(shape::CutFeature(sphere, std::vector<Eigen::MatrixXd>()), shape::InvalidInput);
  EXPECT_THROW(shape::CutFeature(sphere, { circle.topRows(2) }), shape::InvalidInput);
  EXPECT_THROW(shape::CutFeature({ sphere.Points, {} }, { circle }), shape::InvalidInput);
  shape::CutFeatureOptions options;
  options.LoopIndex = 1;
  EXPECT_THROW(shape::CutFeature(sphere, { circle }, options), shape::InvalidInput);
  const shape::Progress stop([](double done) { return done < 0.25; });
  EXPECT_THROW(shape::CutFeature(sphere, { circle }, {}, stop), shape::Aborted);
  // A cutter that was stopped, or refused a loop, cuts as a new one does.
  shape::FeatureCutter cutter(sphere);
  EXPECT_THROW(cutter.Cut({ circle }, {}, stop), shape::Aborted);
  EXPECT_THROW(cutter.Cut({ circle, circle.topRows(2) }), shape::InvalidInput);
  const shape::CutFeatureResult cut = cutter.Cut({ circle }),
                                fresh = shape::CutFeature(sphere, { circle });
  EXPECT_EQ(cut.Feature.Surface.Points, fresh.Feature.Surface.Points);
  EXPECT_EQ(cut.Rest.Surface.Points, fresh.Rest.Surface.Points);
  EXPECT_EQ(cut.Rest.Surface.Triangles, fresh.Rest.Surface.Triangles);
  shape::Mesh broken = sphere;
  broken.Points(3, 0) = NAN;
  EXPECT_THROW(shape::CutFeature(broken, { circle }), shape::InvalidInput);
}
