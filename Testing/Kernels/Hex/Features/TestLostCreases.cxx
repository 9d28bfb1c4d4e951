#include "Hex/Features/LostCreases.h"

#include "Base/Errors.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/HexRemesh.h"
#include "Mesh/QuadSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace
{

using Steps = std::vector<double>;

/// The boxes between steps along each axis that are chosen by their indices.
shape::HexMesh Boxes(const Steps& x, const Steps& y, const Steps& z,
  const std::function<bool(int i, int j, int k)>& isInside)
{
  const auto columns = static_cast<int>(x.size()), rows = static_cast<int>(y.size()),
             layers = static_cast<int>(z.size());
  shape::HexMesh mesh;
  mesh.Points.resize(columns * rows * layers, 3);
  const auto at = [&](int i, int j, int k) { return i + columns * (j + rows * k); };
  std::vector<Eigen::Matrix<int, 1, 8>> cells;
  for (int k = 0; k < layers; ++k)
  {
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        mesh.Points.row(at(i, j, k)) << x[i], y[j], z[k];
        if (i + 1 < columns && j + 1 < rows && k + 1 < layers && isInside(i, j, k))
        {
          cells.emplace_back();
          cells.back() << at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
            at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1);
        }
      }
    }
  }
  mesh.Hexahedra.resize(static_cast<Eigen::Index>(cells.size()), 8);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    mesh.Hexahedra.row(static_cast<Eigen::Index>(i)) = cells[i];
  }
  return mesh;
}

/// The surface of boxes, without the points inside.
shape::Surface SurfaceOf(const shape::HexMesh& boxes)
{
  shape::SurfaceFeatures one;
  const shape::Mesh whole{ boxes.Points, shape::SplitQuads(shape::FindBoundaryQuads(boxes)) };
  one.Patches = 1;
  one.PatchOf = Eigen::VectorXi::Zero(whole.Triangles.rows());
  return shape::Surface(shape::SplitIntoPatches(whole, one).front());
}

shape::HexMesh Cube(int cells, double size)
{
  Steps steps;
  for (int i = 0; i <= cells; ++i)
  {
    steps.push_back(size * i / cells);
  }
  return Boxes(steps, steps, steps, [](int, int, int) { return true; });
}

/// A cube of size 3 with a small cube of size 0.1 on its top.
shape::Surface CubeWithBoss()
{
  return SurfaceOf(Boxes({ 0.0, 1.5, 1.6, 3.0 }, { 0.0, 1.5, 1.6, 3.0 }, { 0.0, 3.0, 3.1 },
    [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); }));
}

/// The bars along the edges of a box. Six patches meet at the inner end of each.
shape::Surface Frame()
{
  return SurfaceOf(Boxes({ 0.0, 0.4, 2.6, 3.0 }, { 0.0, 0.4, 2.0, 2.4 }, { 0.0, 0.4, 1.6, 2.0 },
    [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) <= 1; }));
}

} // namespace

TEST(LostCreases, APatchThatJoinsAnotherGivesUpTheCurveBetweenThem)
{
  const shape::Surface cube = SurfaceOf(Cube(3, 1.0));
  const shape::SurfaceFeatures all = shape::FindFeatures(cube, 40.0, 0.0);
  ASSERT_EQ(all.Curves.size(), 12U);
  const std::vector<shape::CreaseLine> lines = shape::BuildCreaseLines(cube, all);
  EXPECT_NEAR(shape::ComputeLength(lines), 12.0, 1e-12);
  for (int curve = 0; curve < 12; ++curve)
  {
    const shape::SurfaceFeatures fewer = shape::WithoutCurves(cube, all, { curve });
    EXPECT_EQ(fewer.Patches, 5);
    // Its ends are no corners any more: two curves go on there, between the same patches.
    EXPECT_EQ(fewer.Corners.size(), 6U);
    EXPECT_EQ(fewer.Curves.size(), 9U);
    EXPECT_EQ(fewer.CreaseLength, all.CreaseLength);
    const auto lost = shape::FindUncovered(lines, shape::BuildCreaseLines(cube, fewer), 1e-9);
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost.front(), lines[curve]);
  }
  EXPECT_TRUE(shape::FindUncovered(lines, lines, 1e-9).empty());
  EXPECT_EQ(shape::FindUncovered(lines, {}, 1e-9).size(), 12U);
}

TEST(LostCreases, TheNearestCurveOfAPositionBesideItsMiddleIsItself)
{
  const shape::Surface cube = SurfaceOf(Cube(3, 1.0));
  const shape::SurfaceFeatures all = shape::FindFeatures(cube, 40.0, 0.0);
  const std::vector<shape::CreaseLine> lines = shape::BuildCreaseLines(cube, all);
  const Eigen::RowVector3d centre(0.5, 0.5, 0.5);
  for (int curve = 0; curve < 12; ++curve)
  {
    // A tenth of the way into the cube, and beyond the surface.
    const Eigen::RowVector3d middle = shape::FindMidpoint(lines[curve]);
    Eigen::MatrixXd positions(2, 3);
    positions << 0.9 * middle + 0.1 * centre, 1.1 * middle - 0.1 * centre;
    EXPECT_EQ(shape::FindNearestCurves(cube, all, positions), std::set<int>{ curve });
  }
  EXPECT_TRUE(shape::FindNearestCurves(cube, all, Eigen::MatrixXd(0, 3)).empty());
  EXPECT_TRUE(
    shape::FindNearestCurves(cube, shape::RemoveCurves(all), Eigen::MatrixXd::Zero(1, 3)).empty());
}

TEST(LostCreases, CellsTooCoarseForSomeCreasesFollowTheOthers)
{
  const shape::Surface surface = CubeWithBoss();
  const shape::SurfaceFeatures features = shape::FindFeatures(surface, 40.0, 0.0);
  ASSERT_EQ(features.Curves.size(), 24U);
  const shape::HexFit fit = shape::FitHexahedra(Cube(6, 3.0), surface, features);
  EXPECT_EQ(fit.Inverted, 0);
  EXPECT_FALSE(fit.CreasesKept);
  // Those of the large cube have the length 36, those of the small one 1.2.
  EXPECT_NEAR(shape::ComputeLength(fit.Followed), 36.0, 1e-9);
  EXPECT_NEAR(shape::ComputeFollowedShare(fit, surface, features), 36.0 / 37.2, 1e-9);
  EXPECT_EQ(fit.PatchOf.maxCoeff(), 5);
  shape::HexFitOptions all;
  all.NeedsCreases = true;
  EXPECT_THROW(shape::FitHexahedra(Cube(6, 3.0), surface, features, all), shape::SolveFailure);
}

TEST(LostCreases, AreNamedWithTheirPlace)
{
  const shape::Surface surface = CubeWithBoss();
  shape::HexRemeshOptions options;
  options.Method = shape::HexRemeshOptions::MethodType::Grid;
  options.CellSize = 0.6;
  const shape::HexRemeshResult result = shape::RemeshHexahedra(surface, options);
  ASSERT_EQ(result.LostCreases.size(), 12U);
  EXPECT_NEAR(shape::ComputeLength(result.LostCreases), 1.2, 1e-9);
  for (const shape::CreaseLine& line : result.LostCreases)
  {
    const Eigen::MatrixXd fromBoss = line.rowwise() - Eigen::RowVector3d(1.55, 1.55, 3.05);
    EXPECT_LE(fromBoss.cwiseAbs().maxCoeff(), 0.05 + 1e-9);
  }
  EXPECT_NE(result.Reason.find("12 creases are lost"), std::string::npos) << result.Reason;
}

// A face of four flat cells has a crease of its own, around a needle: the angle in its tip lets no
// hexahedron have a scaled Jacobian above 0.17. That crease alone is given up.
TEST(LostCreases, OnlyCreasesAtBadHexahedraAreGivenUp)
{
  Eigen::MatrixXd points(11, 3);
  points << 0, 0, 0, 3, 0, 0, 3, 3, 0, 0, 3, 0, 0, 0, 0.6, 3, 0, 0.6, 3, 3, 0.6, 0, 3, 0.6, //
    0.5, 1.32, 0.6, 2.6, 1.5, 0.6, 0.5, 1.68, 0.6;
  Eigen::MatrixXi triangles(18, 3);
  triangles << 0, 2, 1, 0, 3, 2,                                                // below
    0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7,     // around
    4, 5, 8, 5, 9, 8, 5, 6, 9, 6, 10, 9, 6, 7, 10, 7, 4, 8, 7, 8, 10, 8, 9, 10; // above
  const shape::Surface surface(shape::Mesh{ points, triangles });
  Eigen::VectorXi patches(18);
  patches << 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5, 6;
  const shape::SurfaceFeatures features = shape::FindFeatures(surface, patches, 0.0);
  ASSERT_EQ(features.Curves.size(), 13U);
  Steps wide, high;
  for (int i = 0; i <= 20; ++i)
  {
    wide.push_back(0.15 * i);
  }
  high.assign(wide.begin(), wide.begin() + 5);
  const shape::HexFit fit = shape::FitHexahedra(
    Boxes(wide, wide, high, [](int, int, int) { return true; }), surface, features);
  EXPECT_FALSE(fit.CreasesKept);
  EXPECT_GT(fit.MinimumScaledJacobian, 0.2);
  const auto lost =
    shape::FindUncovered(shape::BuildCreaseLines(surface, features), fit.Followed, 1e-9);
  ASSERT_EQ(lost.size(), 1U);
  const double needle = 0.36 + 2.0 * std::hypot(2.1, 0.18);
  EXPECT_NEAR(shape::ComputeLength(lost), needle, 1e-9);
  EXPECT_NEAR(shape::ComputeLength(fit.Followed), 26.4, 1e-9);
  // The other twelve are kept exactly.
  const shape::SurfaceFeatures others =
    shape::FindFeatures(surface, patches.cwiseMin(5).eval(), 0.0);
  EXPECT_LT(
    shape::CompareCreases(surface, others, fit.Solid.Points, fit.Quads, fit.PatchOf).Distance,
    1e-9);
}

// Cells along the bars have their centres slightly outside, where rows of cells end unevenly: the
// corners of six patches are found on cells that are chosen by their centres.
TEST(LostCreases, AFrameKeepsTheCornersOfSixPatches)
{
  shape::HexRemeshOptions options;
  options.Method = shape::HexRemeshOptions::MethodType::Grid;
  options.CellSize = std::cbrt(3.712 / 5000.0);
  const shape::HexRemeshResult result = shape::RemeshHexahedra(Frame(), options);
  EXPECT_TRUE(result.Fit.CreasesKept);
  EXPECT_TRUE(result.LostCreases.empty());
  EXPECT_EQ(result.Fit.Creases.CornerPoints.size(), 40U);
  EXPECT_LT(result.Fit.Creases.Distance, 1e-9);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.5);
}

TEST(LostCreases, TheMidpointIsHalfWayAlongTheLine)
{
  shape::CreaseLine line(2, 3);
  line << 0, 0, 0, 2, 4, 6;
  EXPECT_EQ(shape::FindMidpoint(line), Eigen::RowVector3d(1, 2, 3));
  line.resize(3, 3);
  line << 0, 0, 0, 1, 0, 0, 1, 3, 0;
  EXPECT_EQ(shape::FindMidpoint(line), Eigen::RowVector3d(1, 1, 0));
}
