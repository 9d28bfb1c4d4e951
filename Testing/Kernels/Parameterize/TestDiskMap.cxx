#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Parameterize/DiskMap.h"
#include "Quality/ConformalDistortion.h"
#include "Support/FlatMaps.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <string>

using shape::CombinationWeights;
using shape::DiskMapOptions;
using shape::DiskMapResult;
using shape::DiskOutline;
using shapetest::FlatDisk;
using shapetest::FlatSquare;

namespace
{

constexpr CombinationWeights AllWeights[] = { CombinationWeights::Uniform,
  CombinationWeights::Cotangent, CombinationWeights::MeanValue };

/// The flat disk raised to the half of the unit sphere above its rim, by stereographic projection.
shape::Mesh Hemisphere(int rings)
{
  shape::Mesh mesh = FlatDisk(rings);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const double square = mesh.Points.row(i).squaredNorm();
    mesh.Points.row(i) *= 2.0;
    mesh.Points(i, 2) = 1.0 - square;
    mesh.Points.row(i) /= 1.0 + square;
  }
  return mesh;
}

/// A bumpy cap of no symmetry, with obtuse angles.
shape::Mesh Bumps(int rings)
{
  shape::Mesh mesh = FlatDisk(rings);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const double x = mesh.Points(i, 0), y = mesh.Points(i, 1);
    mesh.Points(i, 2) = 0.6 * std::sin(5.0 * x + 1.0) * std::cos(4.0 * y) + 0.3 * std::sin(9.0 * y);
    mesh.Points(i, 0) *= 1.4 + 0.5 * std::sin(3.0 * y);
  }
  return mesh;
}

void ExpectNoFlip(const shape::Mesh& mesh, const DiskMapResult& map, const std::string& what)
{
  for (const auto& corners : mesh.Triangles.rowwise())
  {
    EXPECT_EQ(shape::EvaluateOrientation(map.Points.row(corners(0)).head<2>(),
                map.Points.row(corners(1)).head<2>(), map.Points.row(corners(2)).head<2>()),
      1)
      << what;
  }
  EXPECT_EQ(map.FlippedTriangles, 0);
  EXPECT_EQ(map.Points.col(2).cwiseAbs().maxCoeff(), 0.0);
  // All triangles counter-clockwise and the polygon of the loop around them: the areas add up.
  const double areas =
    0.5 * shape::ComputeAreaVectors({ map.Points, mesh.Triangles }).col(2).array().sum();
  double polygon = 0.0;
  for (std::size_t i = 0; i < map.Loop.size(); ++i)
  {
    const auto a = map.Points.row(map.Loop[i]);
    const auto b = map.Points.row(map.Loop[(i + 1) % map.Loop.size()]);
    polygon += 0.5 * (a(0) * b(1) - a(1) * b(0));
  }
  EXPECT_NEAR(areas, polygon, 1e-10) << what;
}

/// The mesh without its first triangle that has the corner `point`.
shape::Mesh WithoutTriangleAt(const shape::Mesh& mesh, int point)
{
  shape::Mesh open = mesh;
  int kept = 0;
  bool left = true;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const bool drop = left && (mesh.Triangles.row(t).array() == point).any();
    left = left && !drop;
    if (!drop)
    {
      open.Triangles.row(kept++) = mesh.Triangles.row(t);
    }
  }
  open.Triangles.conservativeResize(kept, 3);
  return open;
}

} // namespace

TEST(DiskMap, UniformPutsEachPointAtTheMeanOfItsNeighbours)
{
  const shape::Mesh mesh = Bumps(4);
  DiskMapOptions options;
  options.Weights = CombinationWeights::Uniform;
  const Eigen::MatrixXd image = shape::MapToDisk(mesh, options).Points;
  // Around the middle are the six points of the first ring.
  EXPECT_LT((image.middleRows(1, 6).colwise().mean() - image.row(0)).norm(), 1e-14);
}

TEST(DiskMap, AFlatDiskAndAFlatSquareStayWhereTheyAre)
{
  for (const CombinationWeights weights :
    { CombinationWeights::Cotangent, CombinationWeights::MeanValue })
  {
    const shape::Mesh disk = FlatDisk(9);
    const DiskMapResult round = shape::MapToDisk(disk, { weights, DiskOutline::Circle });
    EXPECT_LT((round.Points - disk.Points).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_NEAR(round.LoopLength, 2.0 * 54 * std::sin(M_PI / 54), 1e-12);
    const shape::Mesh square = FlatSquare(10, 0.3);
    const DiskMapResult straight = shape::MapToDisk(square, { weights, DiskOutline::Square });
    EXPECT_LT((straight.Points - square.Points).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_NEAR(straight.LoopLength, 8.0, 1e-13);
  }
}

TEST(DiskMap, TheLoopGoesRoundTheCircleByArcLengthFromTheGreatestPoint)
{
  const shape::Mesh mesh = Bumps(7);
  const DiskMapResult map = shape::MapToDisk(mesh);
  ASSERT_EQ(map.Loop.size(), 42u);
  EXPECT_EQ(map.Points.row(map.Loop[0]), Eigen::RowVector3d(1.0, 0.0, 0.0));
  double along = 0.0;
  for (std::size_t i = 0; i < map.Loop.size(); ++i)
  {
    const Eigen::RowVector3d p = map.Points.row(map.Loop[i]);
    EXPECT_LE(mesh.Points(map.Loop[i], 0), mesh.Points(map.Loop[0], 0));
    EXPECT_NEAR(p.norm(), 1.0, 1e-15);
    const double angle = std::atan2(p(1), p(0));
    EXPECT_NEAR(
      angle < 0.0 ? angle + 2.0 * M_PI : angle, 2.0 * M_PI * along / map.LoopLength, 1e-12);
    along += (mesh.Points.row(map.Loop[(i + 1) % 42]) - mesh.Points.row(map.Loop[i])).norm();
  }
  EXPECT_NEAR(along, map.LoopLength, 1e-12);
}

TEST(DiskMap, TheSquareHasItsFourCornersAndEachSideByArcLength)
{
  const shape::Mesh mesh = Bumps(7);
  const DiskMapResult map =
    shape::MapToDisk(mesh, { CombinationWeights::MeanValue, DiskOutline::Square });
  ExpectNoFlip(mesh, map, "square");
  EXPECT_EQ(map.Points.row(map.Loop[0]), Eigen::RowVector3d(1.0, 1.0, 0.0));
  int corners = 0;
  double sides[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < map.Loop.size(); ++i)
  {
    const Eigen::RowVector3d p = map.Points.row(map.Loop[i]);
    EXPECT_EQ(p.cwiseAbs().maxCoeff(), 1.0);
    corners += p.head<2>().cwiseAbs().minCoeff() == 1.0;
    sides[corners - 1] +=
      (mesh.Points.row(map.Loop[(i + 1) % 42]) - mesh.Points.row(map.Loop[i])).norm();
  }
  EXPECT_EQ(corners, 4);
  // A side is a quarter of the length to within an edge, and its points divide it in proportion.
  double longest = 0.0;
  for (std::size_t i = 0; i < map.Loop.size(); ++i)
  {
    const int a = map.Loop[i], b = map.Loop[(i + 1) % 42];
    longest = std::max(longest, (mesh.Points.row(a) - mesh.Points.row(b)).norm());
  }
  corners = 0;
  for (std::size_t i = 0; i < map.Loop.size(); ++i)
  {
    const int a = map.Loop[i], b = map.Loop[(i + 1) % 42];
    corners += map.Points.row(a).head<2>().cwiseAbs().minCoeff() == 1.0;
    EXPECT_NEAR(sides[corners - 1], map.LoopLength / 4.0, longest);
    EXPECT_NEAR((map.Points.row(a) - map.Points.row(b)).norm(),
      2.0 * (mesh.Points.row(a) - mesh.Points.row(b)).norm() / sides[corners - 1], 1e-12);
  }
}

TEST(DiskMap, ASquareOfFourPointsKeepsItsFourCornersWhateverTheirPlaces)
{
  // Three of the four points lie within a hundredth of the loop's length.
  const shape::Mesh kite{
    (Eigen::MatrixXd(4, 3) << 1, 0, 0, 1, 0.01, 0, 0.99, 0.02, 0, -1, 0, 0).finished(),
    (Eigen::MatrixXi(2, 3) << 0, 1, 3, 1, 2, 3).finished()
  };
  const DiskMapResult map =
    shape::MapToDisk(kite, { CombinationWeights::MeanValue, DiskOutline::Square });
  ExpectNoFlip(kite, map, "kite");
  EXPECT_EQ(map.Points.leftCols(2).cwiseAbs().minCoeff(), 1.0);
}

TEST(DiskMap, HemispheresBecomeMoreConformalWithTheMesh)
{
  // The exact harmonic map with this rim is the stereographic projection, which is conformal.
  double before = 10.0;
  for (const int rings : { 5, 10, 20 })
  {
    const shape::Mesh mesh = Hemisphere(rings);
    const DiskMapResult map =
      shape::MapToDisk(mesh, { CombinationWeights::Cotangent, DiskOutline::Circle });
    const shape::Mesh flat = FlatDisk(rings);
    const double error = (map.Points - flat.Points).cwiseAbs().maxCoeff();
    EXPECT_LT(error, 0.35 * before) << rings;
    EXPECT_LT(shapetest::MeanDistortion(mesh, map.Points) - 1.0, 0.3 / (rings * rings)) << rings;
    before = error;
  }
}

TEST(DiskMap, PositiveWeightsNeverFlipHoweverBadTheTriangles)
{
  for (const double squeeze : { 1.0, 0.1, 0.001 })
  {
    shape::Mesh mesh = Bumps(10);
    mesh.Points.col(1) *= squeeze;
    for (const CombinationWeights weights :
      { CombinationWeights::Uniform, CombinationWeights::MeanValue })
    {
      for (const DiskOutline outline : { DiskOutline::Circle, DiskOutline::Square })
      {
        ExpectNoFlip(mesh, shape::MapToDisk(mesh, { weights, outline }), std::to_string(squeeze));
      }
    }
  }
  // Triangles without area, and points at one place.
  shape::Mesh flat = Bumps(8);
  flat.Points.row(0) = flat.Points.row(1);
  flat.Points.row(20) = 0.5 * (flat.Points.row(21) + flat.Points.row(19));
  flat.Points.row(2) = flat.Points.row(3) = flat.Points.row(1);
  ExpectNoFlip(flat, shape::MapToDisk(flat), "degenerate");
}

TEST(DiskMap, FlipsOfCotangentWeightsAreAnErrorWithTheirNumberAndTheRemedy)
{
  // Squeezed until most triangles are obtuse.
  shape::Mesh mesh = Bumps(10);
  mesh.Points.col(1) *= 0.02;
  EXPECT_UNSOLVED(shape::MapToDisk(mesh, { CombinationWeights::Cotangent, DiskOutline::Circle }),
    "Cotangent weights flip ", " of 600 triangles (first triangle ", "use MeanValue weights");
}

TEST(DiskMap, ALimbThatShrinksBelowDoublePrecisionIsAnError)
{
  // A closed tube of radius 1 and length 60: its end shrinks to exp(-60) of the disk.
  const int around = 12, across = 121;
  shape::Mesh tube{ Eigen::MatrixXd(around * across + 1, 3),
    Eigen::MatrixXi(2 * around * (across - 1) + around, 3) };
  int t = 0;
  for (int j = 0; j < across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * M_PI * i / around;
      // Of no symmetry: an end at the origin would keep its digits there.
      tube.Points.row(j * around + i) << std::cos(angle) + 0.3 * std::cos(2.0 * angle),
        std::sin(angle) + 0.1 * std::cos(angle), 0.5 * j;
      const int right = j * around + (i + 1) % around, here = j * around + i;
      if (j + 1 < across)
      {
        tube.Triangles.row(t++) << here, right, right + around;
        tube.Triangles.row(t++) << here, right + around, here + around;
      }
      else
      {
        tube.Triangles.row(t++) << here, right, around * across;
      }
    }
  }
  tube.Points.row(around * across) << 0.0, 0.0, 0.5 * across;
  for (const CombinationWeights weights :
    { CombinationWeights::Uniform, CombinationWeights::MeanValue })
  {
    EXPECT_UNSOLVED(shape::MapToDisk(tube, { weights, DiskOutline::Circle }),
      "an extremity shrinks exponentially");
  }
}

TEST(DiskMap, AnEdgeAcrossOneSideOfTheSquareIsRefusedAndTakenByTheCircle)
{
  // A flat square with an ear on the middle of one side.
  shape::Mesh mesh = FlatSquare(8, 0.2);
  const Eigen::Index n = mesh.Points.rows(), m = mesh.Triangles.rows();
  mesh.Points.conservativeResize(n + 1, 3);
  mesh.Points.row(n) << -1.0 - 1e-3, 0.125, 0.0;
  mesh.Triangles.conservativeResize(m + 1, 3);
  mesh.Triangles.row(m) << 4, 5, static_cast<int>(n);
  if (shape::ComputeAreaVectors(mesh)(m, 2) < 0.0)
  {
    mesh.Triangles.row(m) << 5, 4, static_cast<int>(n);
  }
  EXPECT_REFUSED(shape::MapToDisk(mesh, { CombinationWeights::MeanValue, DiskOutline::Square }),
    "1 inner edge that joins two points of one side of the square (first from point 4 to 5)");
  ExpectNoFlip(mesh, shape::MapToDisk(mesh), "ear");
}

TEST(DiskMap, DoesNotDependOnTheNumberingNorOnPlaceAndScale)
{
  const shape::Mesh mesh = Bumps(8);
  const int n = static_cast<int>(mesh.Points.rows());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  shape::Mesh shuffled = mesh;
  for (int i = 0; i < n; ++i)
  {
    shuffled.Points.row(order[i]) = mesh.Points.row(i);
  }
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      shuffled.Triangles(mesh.Triangles.rows() - 1 - t, (corner + 1) % 3) =
        order[mesh.Triangles(t, corner)];
    }
  }
  for (const CombinationWeights weights : AllWeights)
  {
    for (const DiskOutline outline : { DiskOutline::Circle, DiskOutline::Square })
    {
      const DiskMapOptions options{ weights, outline };
      const Eigen::MatrixXd image = shape::MapToDisk(mesh, options).Points;
      EXPECT_EQ(image, shape::MapToDisk(mesh, options).Points);
      const Eigen::MatrixXd other = shape::MapToDisk(shuffled, options).Points;
      for (int i = 0; i < n; ++i)
      {
        EXPECT_LT((image.row(i) - other.row(order[i])).norm(), 1e-12);
      }
      for (const double scale : { 1e-9, 1e9 })
      {
        shape::Mesh moved = mesh;
        moved.Points = scale * (mesh.Points.rowwise() + Eigen::RowVector3d(10.0, -20.0, 30.0));
        EXPECT_LT((shape::MapToDisk(moved, options).Points - image).cwiseAbs().maxCoeff(), 1e-10);
      }
    }
  }
}

TEST(DiskMap, RefusesWhatIsNoDiskAndSaysWhy)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  EXPECT_EQ(shapetest::Refusal([&] { shape::MapToDisk(sphere); }),
    "the surface is closed; cut it first with Shape Cut Feature");
  const shape::Mesh twoHoles = WithoutTriangleAt(WithoutTriangleAt(sphere, 0), 3);
  EXPECT_REFUSED(shape::MapToDisk(twoHoles),
    "the surface has 2 open loops (first at point 0); "
    "fill all but the outer one with Shape Fill Holes");
  EXPECT_REFUSED(shape::MapToDisk(WithoutTriangleAt(shapetest::Torus(1.0, 0.3, 20, 10), 7)),
    "the surface has Euler number -1 (genus 1)");
  const shape::Mesh disk = FlatDisk(3);
  const Eigen::Index n = disk.Points.rows();
  EXPECT_REFUSED(shape::MapToDisk(shapetest::Twice(disk)), "2 components");
  shape::Mesh unused = disk;
  unused.Points.conservativeResize(n + 1, 3);
  unused.Points.row(n).setZero();
  EXPECT_REFUSED(shape::MapToDisk(unused), "1 point that no triangle uses (first at point ");
  shape::Mesh turned = disk;
  turned.Triangles.row(0).reverseInPlace();
  EXPECT_REFUSED(shape::MapToDisk(turned), "edges between triangles of opposite orientation");
  shape::Mesh doubled = disk;
  doubled.Points.row(n - 2) = doubled.Points.row(n - 3);
  EXPECT_REFUSED(shape::MapToDisk(doubled), "open loop has 1 edge without length");
  shape::Mesh infinite = disk;
  infinite.Points(4, 1) = INFINITY;
  EXPECT_REFUSED(shape::MapToDisk(infinite), "first at point 4");
  EXPECT_REFUSED(shape::MapToDisk({ disk.Points, Eigen::MatrixXi(0, 3) }), "no triangles");
  EXPECT_REFUSED(
    shape::MapToDisk({ disk.Points.topRows(3), (Eigen::MatrixXi(1, 3) << 0, 1, 2).finished() },
      { CombinationWeights::MeanValue, DiskOutline::Square }),
    "use the outline Circle");
}

TEST(DiskMap, ProgressRisesAndCanStop)
{
  const shape::Mesh mesh = Bumps(6);
  const auto call = [&](const shape::Progress& progress) { shape::MapToDisk(mesh, {}, progress); };
  EXPECT_GT(shapetest::ExpectProgressRises(call), 4);
  shapetest::ExpectStopsAt(3, call);
}

TEST(DiskMap, ModelsWithOneLoopMapOneToOne)
{
  const std::string folder = SHAPEMAP_MODELS;
  if (!std::ifstream(folder + "/lion-head.off"))
  {
    GTEST_SKIP() << "no models in " << folder;
  }
  for (const char* name : { "blob", "corner_tris_with_hole", "cylinder", "cylinder_locally_refined",
         "lion-head", "mannequin-devil", "mesh_with_border", "mushroom", "nefertiti", "patch-01",
         "patch-30", "three_peaks" })
  {
    const shape::Mesh mesh = shapetest::ReadOff(folder + "/" + name + ".off");
    for (const CombinationWeights weights :
      { CombinationWeights::Uniform, CombinationWeights::MeanValue })
    {
      ExpectNoFlip(mesh, shape::MapToDisk(mesh, { weights, DiskOutline::Circle }), name);
    }
  }
  // A closed head with a hole cut into it.
  const shape::Mesh bear = WithoutTriangleAt(shapetest::ReadOff(folder + "/bear.off"), 0);
  ExpectNoFlip(bear, shape::MapToDisk(bear), "bear");
}
