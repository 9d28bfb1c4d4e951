#include "Base/Errors.h"
#include "Fill/CurveNetwork.h"
#include "Fill/FillHoles.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace
{

using Lines = std::vector<std::vector<int>>;

/// A grid of lines in the plane z = 0: squares x squares of side 1.
std::pair<Eigen::MatrixXd, Lines> FlatGrid(int squares)
{
  const int side = squares + 1;
  Eigen::MatrixXd points(side * side, 3);
  Lines lines;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const int point = y * side + x;
      points.row(point) << x, y, 0.0;
      if (x < squares)
      {
        lines.push_back({ point, point + 1 });
      }
      if (y < squares)
      {
        lines.push_back({ point + side, point });
      }
    }
  }
  return { points, lines };
}

/// The edges of a cube, each in so many segments.
std::pair<Eigen::MatrixXd, Lines> WireCube(int segments)
{
  std::vector<Eigen::RowVector3d> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  }
  Lines lines;
  for (int a = 0; a < 8; ++a)
  {
    for (const int bit : { 1, 2, 4 })
    {
      const int b = a | bit;
      if (b == a)
      {
        continue;
      }
      lines.push_back({ a });
      for (int i = 1; i < segments; ++i)
      {
        const double share = static_cast<double>(i) / segments;
        lines.back().push_back(static_cast<int>(points.size()));
        points.emplace_back((1.0 - share) * points[a] + share * points[b]);
      }
      lines.back().push_back(b);
    }
  }
  Eigen::MatrixXd positions(points.size(), 3);
  std::copy(points.begin(), points.end(), positions.rowwise().begin());
  return { positions, lines };
}

double AreaAlong(
  const Eigen::MatrixXd& points, const std::vector<int>& loop, const Eigen::RowVector3d& normal)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Eigen::RowVector3d a = points.row(loop[i]), b = points.row(loop[(i + 1) % loop.size()]);
    area += 0.5 * normal.dot(a.cross(b));
  }
  return area;
}

} // namespace

TEST(CurveNetwork, AClosedCurveRunsAroundItsNormals)
{
  constexpr int count = 24;
  Eigen::MatrixXd points(count + 1, 3), up = Eigen::MatrixXd::Zero(count + 1, 3);
  up.col(2).setOnes();
  Lines line(1);
  for (int i = 0; i <= count; ++i) // the last point is at the first's place, but another
  {
    const double angle = 2.0 * M_PI * (i % count) / count;
    points.row(i) << std::cos(angle), std::sin(angle), 0.1 * std::cos(2.0 * angle);
    line[0].push_back(i);
  }
  Lines turned = line;
  std::reverse(turned[0].begin(), turned[0].end());
  const Eigen::MatrixXd none(0, 3);
  for (const Lines& lines : { line, turned })
  {
    // As the normals say, whatever the sense of the line.
    const shape::CurveNetwork with = shape::FindCurveLoops(points, lines, 3.0 * up);
    ASSERT_EQ(with.Loops.size(), 1u);
    EXPECT_EQ(with.Loops[0].size(), 24u);
    EXPECT_GT(AreaAlong(points, with.Loops[0], { 0, 0, 1 }), 3.0);
    EXPECT_LT((with.Normals.topRows(count) - up.topRows(count)).norm(), 1e-12);
    const shape::CurveNetwork down = shape::FindCurveLoops(points, lines, -up);
    EXPECT_LT(AreaAlong(points, down.Loops[0], { 0, 0, 1 }), -3.0);
    // Without, as the line runs, around its own plane's normal.
    const shape::CurveNetwork own = shape::FindCurveLoops(points, lines, none);
    ASSERT_EQ(own.Loops.size(), 1u);
    const double area = AreaAlong(points, own.Loops[0], own.Normals.row(0));
    EXPECT_GT(area, 3.0);
    EXPECT_NEAR(std::abs(own.Normals(0, 2)), 1.0, 1e-9);
  }
  EXPECT_GT(shape::FindCurveLoops(points, line, none).Normals(0, 2), 0.0);
  EXPECT_LT(shape::FindCurveLoops(points, turned, none).Normals(0, 2), 0.0);
}

TEST(CurveNetwork, AFlatGridHasItsInnerFaces)
{
  const auto [points, lines] = FlatGrid(3);
  const shape::CurveNetwork network = shape::FindCurveLoops(points, lines, Eigen::MatrixXd(0, 3));
  EXPECT_EQ(network.Loops.size(), 9u); // the outer face is none
  for (const std::vector<int>& loop : network.Loops)
  {
    EXPECT_EQ(loop.size(), 4u);
    EXPECT_NEAR(AreaAlong(points, loop, { 0, 0, 1 }), 1.0, 1e-12);
  }
  EXPECT_EQ(network.SkippedFaces, 0);
  EXPECT_EQ(network.LooseSegments, 0);
}

TEST(CurveNetwork, LooseEndsAreLeftOut)
{
  auto [points, lines] = FlatGrid(2);
  const auto old = static_cast<int>(points.rows());
  points.conservativeResize(old + 3, 3);
  points.bottomRows(3) << 0.4, 0.4, 0, 0.6, 0.5, 0, 5, 5, 5;
  lines.push_back({ 0, old, old + 1 }); // into the first square
  lines.push_back({ 8, old + 2 });      // and away from a corner
  const shape::CurveNetwork network = shape::FindCurveLoops(points, lines, Eigen::MatrixXd(0, 3));
  EXPECT_EQ(network.Loops.size(), 4u);
  EXPECT_EQ(network.LooseSegments, 3);
}

TEST(CurveNetwork, FacesThatComeBackToAPlaceAreSkipped)
{
  // A square within a square, joined by one segment: the face between them is a ring.
  Eigen::MatrixXd points(8, 3);
  points << 0, 0, 0, 3, 0, 0, 3, 3, 0, 0, 3, 0, 1, 1, 0, 2, 1, 0, 2, 2, 0, 1, 2, 0;
  const Lines lines = { { 0, 1, 2, 3, 0 }, { 4, 5, 6, 7, 4 }, { 0, 4 } };
  const shape::CurveNetwork network = shape::FindCurveLoops(points, lines, Eigen::MatrixXd(0, 3));
  ASSERT_EQ(network.Loops.size(), 1u);
  EXPECT_NEAR(AreaAlong(points, network.Loops[0], { 0, 0, 1 }), 1.0, 1e-12);
  EXPECT_EQ(network.SkippedFaces, 1);
}

TEST(CurveNetwork, ACubesWiresBoundSixPatches)
{
  const auto [points, lines] = WireCube(7);
  const shape::CurveNetwork network = shape::FindCurveLoops(points, lines, points);
  ASSERT_EQ(network.Loops.size(), 6u);
  for (const std::vector<int>& loop : network.Loops)
  {
    EXPECT_EQ(loop.size(), 28u);
  }
  shape::FillHolesOptions options;
  for (const shape::FillMethod method :
    { shape::FillMethod::Automatic, shape::FillMethod::Membrane })
  {
    options.Method = method;
    shape::SurfaceFiller filler({ points, Eigen::MatrixXi(0, 3) }, network.Loops, network.Normals);
    const shape::FilledSurface filled = filler.Fill(options);
    const shape::Topology topology = shape::RequireClosedSurface(filled.Surface, "the patches");
    EXPECT_EQ(topology.EulerNumber, 2);
    EXPECT_EQ(topology.Components, 1);
    for (const shape::FilledHole& hole : filled.Holes)
    {
      EXPECT_EQ(hole.SelfIntersections, 0);
    }
    const double volume = shape::ComputeEnclosedVolume(filled.Surface);
    if (method == shape::FillMethod::Membrane)
    {
      EXPECT_NEAR(volume, 8.0, 1e-9);
    }
    else
    {
      EXPECT_GT(volume, 8.5); // the normals lean outwards, so the patches bulge
    }
  }
}

TEST(CurveNetwork, NamesWhatIsWrong)
{
  const auto [points, lines] = WireCube(2);
  const Eigen::MatrixXd none(0, 3);
  EXPECT_THROW(
    shape::FindCurveLoops(points, lines, none), shape::InvalidInput); // no plane, no normals
  EXPECT_THROW(shape::FindCurveLoops(points, { { 0, 1000 } }, none), shape::InvalidInput);
  Eigen::MatrixXd bad = points;
  bad(3, 1) = std::nan("");
  EXPECT_THROW(shape::FindCurveLoops(bad, lines, points), shape::InvalidInput);
}
