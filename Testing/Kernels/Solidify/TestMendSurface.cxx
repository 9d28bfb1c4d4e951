#include "Geometry/SelfIntersections.h"
#include "Mesh/Surface.h"
#include "Solidify/MendSurface.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace
{

using shape::TriangleOrigin;

const Eigen::RowVector3d Nought = Eigen::RowVector3d::Zero(), Unit = Eigen::RowVector3d::Ones();

int CountOrigin(const shape::MendedSurface& mended, TriangleOrigin origin)
{
  return static_cast<int>((mended.Origin.array() == static_cast<int>(origin)).count());
}

/// Closed, a manifold, oriented, without intersections, of this volume and Euler number; kept
/// triangles are those of the input.
shape::MendedSurface ExpectSolid(const shape::Mesh& input, double volume, double tolerance,
  int euler, const shape::SurfaceDefectOptions& options = {})
{
  const shape::MendedSurface mended = shape::MendSurface(input, options);
  const shape::Topology topology = shape::RequireClosedSurface(mended.Surface, "the result");
  EXPECT_EQ(topology.EulerNumber, euler);
  EXPECT_TRUE(shape::FindDegenerateTriangles(mended.Surface).empty());
  EXPECT_TRUE(shape::FindSelfIntersections(mended.Surface).empty());
  EXPECT_NEAR(shape::ComputeEnclosedVolume(mended.Surface), volume, tolerance);
  EXPECT_EQ(mended.Origin.size(), mended.Surface.Triangles.rows());
  EXPECT_EQ(mended.Provenance.Cells.size(), mended.Surface.Triangles.rows());
  EXPECT_EQ(mended.Provenance.Weights.rows(), mended.Surface.Points.rows());
  int before = -1;
  for (Eigen::Index t = 0; t < mended.Origin.size(); ++t)
  {
    if (mended.Origin(t) == static_cast<int>(TriangleOrigin::Kept))
    {
      const int source = mended.Provenance.Cells(t);
      EXPECT_EQ(shape::GetCorners(mended.Surface, t), shape::GetCorners(input, source));
      EXPECT_GT(source, before);
      before = source;
    }
  }
  // Mended once, it has no defects.
  EXPECT_TRUE(shape::FindSurfaceDefects(mended.Surface).Defects.empty());
  return mended;
}

shape::Mesh ToSoup(const shape::Mesh& mesh)
{
  std::vector<shape::Mesh> parts;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    parts.push_back({ shape::GetCorners(mesh, t), Eigen::RowVector3i(0, 1, 2) });
  }
  return shapetest::Joined(parts);
}

/// Reverses random triangles.
shape::Mesh WithReversed(shape::Mesh mesh, double share)
{
  std::mt19937 random(3);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (std::uniform_real_distribution<double>()(random) < share)
    {
      std::swap(mesh.Triangles(t, 1), mesh.Triangles(t, 2));
    }
  }
  return mesh;
}

} // namespace

TEST(MendSurface, ARightSurfaceStaysBitForBit)
{
  const shape::Mesh solid = shapetest::Joined(
    { shapetest::Sphere(2, 2.0), shapetest::Reversed(shapetest::Sphere(2, 1.0)) });
  const shape::MendedSurface mended = shape::MendSurface(solid);
  EXPECT_EQ(mended.Surface.Points, solid.Points);
  EXPECT_EQ(mended.Surface.Triangles, solid.Triangles);
  EXPECT_EQ(mended.Origin.cwiseAbs().sum(), 0);
}

TEST(MendSurface, ASoupBecomesTheSurfaceThatItWas)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 40, 20);
  const double volume = shape::ComputeEnclosedVolume(torus);
  const shape::MendedSurface joined = ExpectSolid(ToSoup(torus), volume, 1e-12, 0);
  EXPECT_EQ(CountOrigin(joined, TriangleOrigin::Kept), torus.Triangles.rows());
  EXPECT_EQ(joined.Surface.Points.rows(), torus.Points.rows());

  // A third of the triangles reversed.
  const shape::Mesh reversed = WithReversed(ToSoup(torus), 0.3);
  const shape::MendedSurface oriented = ExpectSolid(reversed, volume, 1e-12, 0);
  EXPECT_EQ(CountOrigin(oriented, TriangleOrigin::Mended), oriented.ReversedTriangles);
  EXPECT_GT(oriented.ReversedTriangles, 300);

  // Points apart by up to 0.001.
  shape::Mesh loose = ToSoup(torus);
  std::mt19937 random(1);
  for (double& coordinate : loose.Points.reshaped())
  {
    coordinate += std::uniform_real_distribution<double>(0.0, 0.0005)(random);
  }
  ExpectSolid(loose, volume, 0.01, 0, { 0.001, 0.0 });
}

TEST(MendSurface, PiecesFaceOutwardsAndVoidsInwards)
{
  const shape::Mesh outer = shapetest::Sphere(2, 2.0), inner = shapetest::Sphere(2, 1.0);
  const double volume = shape::ComputeEnclosedVolume(outer) - shape::ComputeEnclosedVolume(inner);
  for (const bool isOuterReversed : { false, true })
  {
    for (const bool isInnerReversed : { false, true })
    {
      if (isOuterReversed || !isInnerReversed)
      {
        ExpectSolid(shapetest::Joined({ isOuterReversed ? shapetest::Reversed(outer) : outer,
                      isInnerReversed ? shapetest::Reversed(inner) : inner }),
          volume, 1e-12, 4);
      }
    }
  }
}

TEST(MendSurface, HolesAreFilled)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 30);
  const double whole = shape::ComputeEnclosedVolume(shapetest::Icosphere(4));
  const shape::MendedSurface mended = ExpectSolid(ToSoup(open), whole, 0.001, 2);
  EXPECT_EQ(mended.GapsClosed, 1);
  EXPECT_EQ(CountOrigin(mended, TriangleOrigin::Kept), open.Triangles.rows());
  EXPECT_EQ(CountOrigin(mended, TriangleOrigin::Mended), 0);
}

TEST(MendSurface, LargeHolesAreFilledByMembranesOfFewPoints)
{
  // Half of a sphere is missing. Its hole is a third of both: neither a sheet nor a small hole. The
  // sphere that a smooth fill would continue has about 5000 points there.
  const shape::Mesh open = shapetest::SphereWithoutCap(5, 90.0);
  const shape::MendedSurface mended = ExpectSolid(open, 2.0 / 3.0 * M_PI, 0.05, 2);
  constexpr int most = 2 * 2000; // two triangles for each point
  EXPECT_LT(CountOrigin(mended, TriangleOrigin::Made), 1.2 * most);
}

TEST(MendSurface, ATriangleWithoutAreaLeavesNoCrack)
{
  // A box with a point on an edge. The triangle on one side of the edge is split at this point, the
  // one on the other side is not, and a triangle without area connects them.
  shape::Mesh box = shapetest::Box(Nought, Unit);
  box.Points.conservativeResize(9, 3);
  box.Points.row(8) << 0.5, 0.0, 0.0;
  box.Triangles.conservativeResize(14, 3);
  box.Triangles.row(1) << 0, 3, 8;
  box.Triangles.row(12) << 0, 8, 1;
  box.Triangles.row(13) << 8, 3, 1;
  const shape::MendedSurface mended = ExpectSolid(box, 1.0, 1e-12, 2);
  EXPECT_EQ(mended.GapsClosed, 0);
  EXPECT_EQ(mended.RemovedTriangles, 1);
  EXPECT_EQ(CountOrigin(mended, TriangleOrigin::Kept), 12);
  EXPECT_EQ(CountOrigin(mended, TriangleOrigin::Mended), 2);
}

TEST(MendSurface, WallsAndFinsAreRemoved)
{
  // Two boxes that share a face: the wall between them occurs twice.
  const shape::Mesh boxes = shapetest::Joined(
    { shapetest::Box(Nought, Unit), shapetest::Box({ 1.0, 0.0, 0.0 }, { 2.0, 1.0, 1.0 }) });
  const shape::MendedSurface united = ExpectSolid(boxes, 2.0, 1e-12, 2);
  EXPECT_EQ(united.RemovedTriangles, 4);
  EXPECT_EQ(CountOrigin(united, TriangleOrigin::Kept), 20);

  // The wall occurs once; and a fin stands on an edge.
  shape::Mesh single = boxes;
  int removed = 0;
  for (Eigen::Index t = 0; t < single.Triangles.rows(); ++t)
  {
    if (t < 12 && (shape::GetCorners(single, t).col(0).array() == 1.0).all())
    {
      ++removed;
      continue;
    }
    single.Triangles.row(t - removed) = single.Triangles.row(t).eval();
  }
  ASSERT_EQ(removed, 2);
  single.Triangles.conservativeResize(22, 3);
  ExpectSolid(single, 2.0, 1e-12, 2);
  const shape::Mesh fin = { (Eigen::Matrix3d() << 0, 0, 0, 1, 0, 0, 0.5, -1, -1).finished(),
    Eigen::RowVector3i(0, 1, 2) };
  ExpectSolid(shapetest::Joined({ fin, single }), 2.0, 1e-12, 2);
}

TEST(MendSurface, SolidsThatTouchAreSeparated)
{
  const shape::Mesh box = shapetest::Box(Nought, Unit);
  // At a corner, along an edge, and both at once by three boxes.
  const shape::MendedSurface corner =
    ExpectSolid(shapetest::Joined({ box, shapetest::Box(Unit, 2.0 * Unit) }), 2.0, 0.01, 4);
  EXPECT_EQ(corner.SplitPoints, 1);
  const shape::Mesh along = shapetest::Box({ 1.0, 1.0, 0.0 }, { 2.0, 2.0, 1.0 });
  const shape::MendedSurface edge = ExpectSolid(shapetest::Joined({ box, along }), 2.0, 0.01, 4);
  EXPECT_EQ(edge.SplitPoints, 2);
  EXPECT_GT(CountOrigin(edge, TriangleOrigin::Kept), 4);
  ExpectSolid(shapetest::Joined({ WithReversed(box, 0.4), along,
                shapetest::Box({ 2.0, 2.0, 1.0 }, { 3.0, 3.0, 2.0 }) }),
    3.0, 0.01, 6);
}

TEST(MendSurface, HolesThatTouchAreFilledEach)
{
  // Two triangles around a point of valence 6 that share no edge are missing.
  const shape::Mesh sphere = shapetest::Sphere(3, 1.0);
  const int point = static_cast<int>(sphere.Points.rows()) - 1;
  std::vector<int> around;
  for (int t = 0; t < sphere.Triangles.rows(); ++t)
  {
    if ((sphere.Triangles.row(t).array() == point).any())
    {
      around.push_back(t);
    }
  }
  ASSERT_EQ(around.size(), 6u);
  const auto isApart = [&](int one, int other)
  {
    int shared = 0;
    for (const int corner : sphere.Triangles.row(one))
    {
      shared += (sphere.Triangles.row(other).array() == corner).any();
    }
    return shared == 1;
  };
  const int other =
    *std::find_if(around.begin(), around.end(), [&](int t) { return isApart(around[0], t); });
  const Eigen::MatrixXd centres = shape::ComputeCentroids(sphere);
  const shape::Mesh open = shapetest::Without(sphere,
    [&](const Eigen::RowVector3d& centre)
    { return centre == centres.row(around[0]) || centre == centres.row(other); });
  const shape::MendedSurface mended =
    ExpectSolid(open, shape::ComputeEnclosedVolume(sphere), 0.01, 2);
  EXPECT_EQ(mended.GapsClosed, 2);
  EXPECT_EQ(mended.SplitPoints, 0);
}

TEST(MendSurface, PointsThatAreNotFiniteAndSmallPiecesGo)
{
  shape::Mesh debris =
    shapetest::Joined({ shapetest::Sphere(3, 1.0), shapetest::Sphere(1, 0.01, 3.0 * Unit),
      shapetest::WithoutLast(shapetest::Sphere(1, 0.01, 2.0 * Unit), 3) });
  const double volume = shape::ComputeEnclosedVolume(shapetest::Sphere(3, 1.0));
  debris.Points(5, 2) = std::numeric_limits<double>::infinity();
  const shape::MendedSurface mended = ExpectSolid(debris, volume, 0.01, 2, { 0.0, 0.1 });
  EXPECT_EQ(mended.RemovedPieces, 2);
  EXPECT_EQ(mended.GapsClosed, 1);
}

TEST(MendSurface, AFewTrianglesThatCrossAreReplaced)
{
  // One point is moved by two edges along the sphere: its triangles cross others.
  shape::Mesh folded = shapetest::Sphere(4, 1.0);
  const double volume = shape::ComputeEnclosedVolume(folded);
  const double edge =
    (folded.Points.row(folded.Triangles(0, 0)) - folded.Points.row(folded.Triangles(0, 1))).norm();
  Eigen::RowVector3d moved = folded.Points.row(100);
  moved += 2.0 * edge * moved.unitOrthogonal();
  folded.Points.row(100) = moved.normalized();
  ASSERT_FALSE(shape::FindSelfIntersections(folded).empty());
  const shape::MendedSurface mended = ExpectSolid(folded, volume, 0.001, 2);
  EXPECT_GT(CountOrigin(mended, TriangleOrigin::Kept), 0.95 * folded.Triangles.rows());
  EXPECT_EQ(CountOrigin(mended, TriangleOrigin::Mended), 0);
}

TEST(MendSurface, RefusesWhatEnclosesNoSolid)
{
  EXPECT_REFUSED(shape::MendSurface(shapetest::Joined(
                   { shapetest::Sphere(2, 1.0), shapetest::Sphere(2, 1.0, 0.5 * Unit) })),
    "intersects itself", "pairs of triangles", "Report");
  shape::Mesh strip = shapetest::FlatSquare(1, 0.0);
  EXPECT_REFUSED(shape::MendSurface(strip, { 10.0, 0.0 }), "no triangle of the surface is left");
  const shape::Mesh sheet = shapetest::FlatSquare(4, 0.0);
  EXPECT_REFUSED(shape::MendSurface(sheet), "1 sheet(s)", "Wrap");
  // A Moebius strip of 12 quads.
  constexpr int quads = 12;
  shape::Mesh moebius{ Eigen::MatrixXd(2 * quads, 3), Eigen::MatrixXi(2 * quads, 3) };
  for (int i = 0; i < quads; ++i)
  {
    const double angle = 2.0 * M_PI * i / quads;
    for (const int end : { 0, 1 })
    {
      const double across = end == 0 ? -0.3 : 0.3, radius = 1.0 + across * std::cos(0.5 * angle);
      moebius.Points.row(2 * i + end) << radius * std::cos(angle), radius * std::sin(angle),
        across * std::sin(0.5 * angle);
    }
    const int next = (i + 1) % quads, turn = i + 1 == quads ? 1 : 0;
    const int a = 2 * i, b = 2 * i + 1, c = 2 * next + turn, d = 2 * next + 1 - turn;
    moebius.Triangles.row(2 * i) << a, b, c;
    moebius.Triangles.row(2 * i + 1) << b, d, c;
  }
  EXPECT_REFUSED(shape::MendSurface(moebius), "only one side");
}
