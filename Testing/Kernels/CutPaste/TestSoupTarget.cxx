#include "CutPaste/PasteFeature.h"
#include "CutPaste/SoupTarget.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using Eigen::RowVector3d;

/// A bump on a disk of radius 0.3, with the plane as its base.
struct Bump
{
  Bump()
  {
    constexpr double radius = 0.3;
    constexpr int rings = 10;
    this->Feature = shapetest::FlatDisk(rings);
    this->Feature.Points *= radius;
    for (auto point : this->Feature.Points.rowwise())
    {
      const double share = point.head(2).squaredNorm() / (radius * radius);
      point.z() += 0.2 * std::pow(std::max(0.0, 1.0 - share), 3);
    }
    const auto count = static_cast<int>(this->Feature.Points.rows());
    const int size = 6 * rings;
    for (int i = count - size; i < count; ++i)
    {
      this->Base.Loop.push_back(i);
    }
    this->Base.LoopPositions = this->Feature.Points.bottomRows(size).leftCols(2);
    this->Base.Normals = RowVector3d::UnitZ().replicate(size, 1);
    this->Base.Normal = RowVector3d::UnitZ();
    this->Base.XAxis = RowVector3d::UnitX();
    this->Edge = 2.0 * radius * std::sin(M_PI / size);
    this->Area = 0.5 * size * radius * radius * std::sin(2.0 * M_PI / size);
  }

  shape::Mesh Feature;
  shape::FeatureFootprint Base;
  double Edge = 0.0, Area = 0.0; ///< of the loop: an edge, and the area inside
};

/// Turns a third of the triangles over.
shape::Mesh Unoriented(shape::Mesh mesh)
{
  std::mt19937 random(5);
  for (auto triangle : mesh.Triangles.rowwise())
  {
    if (random() % 3 == 0)
    {
      std::swap(triangle(0), triangle(1));
    }
  }
  return mesh;
}

/// Gives each triangle its own points, and shrinks it by a share.
shape::Mesh Apart(const shape::Mesh& mesh, double share)
{
  shape::Mesh soup{ Eigen::MatrixXd(3 * mesh.Triangles.rows(), 3), mesh.Triangles };
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = mesh.Points(mesh.Triangles.row(t), Eigen::all);
    const RowVector3d centre = corners.colwise().mean();
    for (int k = 0; k < 3; ++k)
    {
      soup.Points.row(3 * t + k) = (1.0 - share) * corners.row(k) + share * centre;
      soup.Triangles(t, k) = static_cast<int>(3 * t + k);
    }
  }
  return soup;
}

double AreaOf(const shape::Mesh& mesh, Eigen::Index first, Eigen::Index count)
{
  double area = 0.0;
  for (Eigen::Index t = first; t < first + count; ++t)
  {
    const Eigen::Matrix3d p = mesh.Points(mesh.Triangles.row(t), Eigen::all);
    const RowVector3d u = p.row(1) - p.row(0), v = p.row(2) - p.row(0);
    area += 0.5 * u.cross(v).norm();
  }
  return area;
}

/// The number of triangles that are the soup's.
Eigen::Index SoupTriangles(const shape::PastedFeature& pasted)
{
  return (pasted.Target.Cells.array() >= 0).count();
}

/// The numbers of edges with one, and with more than two triangles.
std::pair<int, int> OddEdges(const shape::Mesh& mesh)
{
  int open = 0, many = 0;
  const auto sides = shape::SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Low() == sides[begin].Low() &&
      sides[end].High() == sides[begin].High())
    {
      ++end;
    }
    open += end - begin == 1 ? 1 : 0;
    many += end - begin > 2 ? 1 : 0;
  }
  return { open, many };
}

shape::PastedFeature Paste(const Bump& bump, const shape::Mesh& soup, const RowVector3d& seed,
  double scale = 1.0, double rotation = 0.0)
{
  const shape::FeatureToPaste feature(bump.Feature, bump.Base);
  shape::SoupTarget target(soup);
  return feature.PasteOn(target, { seed, rotation, scale });
}

} // namespace

TEST(SoupTarget, OnAPlaneTheFeatureMovesRigidlyAndTheRestKeepsItsArea)
{
  const Bump bump;
  const shape::Mesh plane = shapetest::FlatSquare(20, 0.2);
  const RowVector3d seed(0.05, 0.03, 0.0);
  for (const shape::Mesh& soup : { Unoriented(plane), Apart(Unoriented(plane), 0.0) })
  {
    const shape::PastedFeature pasted = Paste(bump, soup, seed);
    EXPECT_TRUE(pasted.IsOnSoup);
    const Eigen::MatrixXd moved = pasted.Surface.Points.bottomRows(bump.Feature.Points.rows());
    // Points of the loop are snapped to points of the soup within a thousandth of an edge.
    EXPECT_LT(
      (moved.rowwise() - seed - bump.Feature.Points).cwiseAbs().maxCoeff(), 1e-3 * bump.Edge);
    EXPECT_NEAR(AreaOf(pasted.Surface, 0, SoupTriangles(pasted)), 4.0 - bump.Area, 1e-5);
    // Feature and soup have all edges of the seam in common.
    EXPECT_NEAR(pasted.JoinedShare, 1.0, 1e-12);
    EXPECT_LT(pasted.LargestGap, 1e-12);
  }
  // What was connected is connected: only the square's own sides are open.
  const shape::PastedFeature whole = Paste(bump, Unoriented(plane), seed);
  EXPECT_EQ(OddEdges(whole.Surface), std::make_pair(4 * 20, 0));
}

TEST(SoupTarget, AClosedSurfaceStaysClosedWhateverItsTriangles)
{
  const Bump bump;
  for (int i = 0; i < 4; ++i)
  {
    const shape::Mesh sphere = Unoriented(shapetest::Icosphere(4));
    const RowVector3d seed = RowVector3d(std::cos(2.0 * i), std::sin(2.0 * i), 0.4 * i - 0.7);
    const shape::PastedFeature pasted = Paste(bump, sphere, seed, 1.0 + 0.2 * i, 40.0 * i);
    EXPECT_EQ(OddEdges(pasted.Surface), std::make_pair(0, 0));
    EXPECT_EQ(pasted.EulerNumber, 2);
    EXPECT_NEAR(pasted.JoinedShare, 1.0, 1e-12);
    EXPECT_LT(pasted.LargestGap, 1e-12);
    // The bump stands outside: that is the side of most triangles.
    const Eigen::MatrixXd moved = pasted.Surface.Points.bottomRows(bump.Feature.Points.rows());
    EXPECT_GT(moved.row(0).norm(), 1.1);
    EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.5), 3.0);
  }
}

TEST(SoupTarget, CrossesGapsThatAreNotWiderThanAnEdge)
{
  // Two panels with a slot between them, and triangles that all lie apart.
  const Bump bump;
  shape::Mesh panels = Apart(shapetest::FlatSquare(20, 0.0), 0.0);
  for (auto point : panels.Points.rowwise())
  {
    point.x() += point.x() > 1e-9 ? 0.9 * bump.Edge : 0.0;
  }
  for (Eigen::Index t = 0; t < panels.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = panels.Triangles.row(t);
    if (panels.Points(corners, 0).mean() > 0.0)
    {
      for (const int corner : corners)
      {
        panels.Points(corner, 0) = std::max(panels.Points(corner, 0), 0.9 * bump.Edge);
      }
    }
  }
  const shape::PastedFeature slot = Paste(bump, panels, { 0.1, 0.03, 0.0 });
  EXPECT_LE(slot.LargestGap, bump.Edge);
  EXPECT_GT(slot.JoinedShare, 0.9);
  EXPECT_LT(slot.JoinedShare, 1.0);

  const shape::Mesh apart = Apart(Unoriented(shapetest::Icosphere(4)), 0.1);
  const shape::PastedFeature scales = Paste(bump, apart, { 0.3, -0.8, 0.5 });
  EXPECT_LE(scales.LargestGap, bump.Edge);
  EXPECT_TRUE(scales.Surface.Points.allFinite());
}

TEST(SoupTarget, CutsThinDoubleSheetsBoth)
{
  const Bump bump;
  const shape::Mesh plane = shapetest::FlatSquare(20, 0.2);
  shape::Mesh sheets{ Eigen::MatrixXd(2 * plane.Points.rows(), 3),
    Eigen::MatrixXi(2 * plane.Triangles.rows(), 3) };
  sheets.Points << plane.Points, plane.Points.rowwise() - RowVector3d(0.0, 0.0, 0.1 * bump.Edge);
  sheets.Triangles << plane.Triangles,
    plane.Triangles.array() + static_cast<int>(plane.Points.rows());
  const shape::PastedFeature pasted = Paste(bump, sheets, { 0.05, 0.03, 0.1 });
  EXPECT_NEAR(AreaOf(pasted.Surface, 0, SoupTriangles(pasted)), 2.0 * (4.0 - bump.Area), 0.02);
  EXPECT_LE(pasted.LargestGap, bump.Edge);
}

TEST(SoupTarget, ALoopThroughItsPointsReturnsThem)
{
  // The feature's loop runs through points of the soup, along its edges.
  const Bump bump;
  shape::Mesh wide = shapetest::FlatDisk(20);
  wide.Points *= 0.6;
  const shape::Mesh soup = Unoriented(wide);
  const shape::PastedFeature pasted = Paste(bump, soup, { 0.0, 0.0, 0.0 });
  EXPECT_EQ(OddEdges(pasted.Surface), std::make_pair(6 * 20, 0));
  EXPECT_NEAR(pasted.JoinedShare, 1.0, 1e-12);
  const Eigen::MatrixXd moved = pasted.Surface.Points.bottomRows(bump.Feature.Points.rows());
  EXPECT_LT((moved - bump.Feature.Points).cwiseAbs().maxCoeff(), 1e-3 * bump.Edge);
}

TEST(SoupTarget, DataComeFromWhereThePointsWere)
{
  const Bump bump;
  const shape::Mesh soup = Apart(Unoriented(shapetest::Icosphere(3)), 0.0);
  const shape::PastedFeature pasted = Paste(bump, soup, { 0.3, -0.8, 0.5 });
  const Eigen::Index feature = bump.Feature.Points.rows();
  const Eigen::Index rest = pasted.Surface.Points.rows() - feature;
  const Eigen::MatrixXd positions = pasted.Target.Weights * soup.Points;
  EXPECT_LT(
    (positions.topRows(rest) - pasted.Surface.Points.topRows(rest)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_TRUE(pasted.Target.Cells.head(SoupTriangles(pasted)).minCoeff() >= 0);
  // Each triangle of the rest lies in the one it comes from.
  for (Eigen::Index t = 0; t < SoupTriangles(pasted); ++t)
  {
    const Eigen::Matrix3d given =
      soup.Points(soup.Triangles.row(pasted.Target.Cells(t)), Eigen::all);
    const RowVector3d centre =
      pasted.Surface.Points(pasted.Surface.Triangles.row(t), Eigen::all).colwise().mean();
    const RowVector3d closest = shape::FindClosestPointInTriangle(given, centre) * given;
    ASSERT_LT((closest - centre).norm(), 1e-9);
  }
}

TEST(SoupTarget, RefusesWhatDoesNotFit)
{
  const Bump bump;
  const shape::Mesh soup = Unoriented(shapetest::FlatSquare(20, 0.2));
  EXPECT_REFUSED(
    Paste(bump, soup, { 0.9, 0.0, 0.0 }), "beyond the polygons", "lower Scale or move Seed");
  EXPECT_REFUSED(Paste(bump, soup, { 0.0, 0.0, 0.0 }, 4.0), "lower Scale");
  EXPECT_REFUSED(Paste(bump, soup, { 0.0, 0.0, 0.0 }, 0.0), "Scale is 0");
  shape::Mesh bad = soup;
  bad.Points(3, 0) = std::nan("");
  EXPECT_THROW(shape::SoupTarget{ bad }, shape::InvalidInput);
}
