#include "Base/Errors.h"
#include "Fill/FillHoles.h"
#include "Fill/LoopChoice.h"
#include "Fill/Private/PatchSelfIntersections.h"
#include "Support/HoleShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

TEST(HoleLoops, SmallLoops)
{
  // Three and four points: one triangle, and two or more.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  for (const int removed : { 1, 2 })
  {
    shape::Mesh open = sphere;
    int kept = 0;
    for (int t = 0; t < sphere.Triangles.rows(); ++t)
    {
      // Two that share the edge of the first one's first two corners.
      const bool isNextTo = (sphere.Triangles.row(t).array() == sphere.Triangles(0, 0)).any() &&
        (sphere.Triangles.row(t).array() == sphere.Triangles(0, 1)).any();
      if (!(t == 0 || (removed == 2 && isNextTo)))
      {
        open.Triangles.row(kept++) = sphere.Triangles.row(t);
      }
    }
    open.Triangles.conservativeResize(kept, 3);
    ASSERT_EQ(kept, sphere.Triangles.rows() - removed);
    const shape::FilledSurface filled = shape::FillHoles(open);
    EXPECT_EQ(filled.Holes[0].Loop.size(), 2u + removed);
    shapetest::ExpectSound(open, filled, 0, 2);
    EXPECT_EQ(filled.Holes[0].Triangles, removed);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
  }
}

TEST(HoleLoops, PointsOnOneLineAndTwiceAtAPlace)
{
  // A square hole whose sides have many points, one corner of it twice.
  shape::Mesh flat = shapetest::Without(shapetest::FlatSquare(20, 0.0),
    [](const Eigen::RowVector3d& p) { return p.cwiseAbs().maxCoeff() < 0.5; });
  std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(flat).Loops;
  ASSERT_EQ(loops.size(), 2u);
  const shape::FilledSurface plain = shape::FillLoops(flat, { loops[1] });
  shapetest::ExpectSound(flat, plain, 1, 1);
  EXPECT_EQ(plain.Surface.Points.col(2).cwiseAbs().maxCoeff(), 0.0);

  // The corner's triangles on one side take a point of their own at the same place.
  const int corner = loops[1][0], next = loops[1][1];
  shape::Mesh doubled = flat;
  doubled.Points.conservativeResize(flat.Points.rows() + 1, 3);
  doubled.Points.bottomRows(1) = flat.Points.row(corner);
  std::vector<int> around;
  for (int t = 0; t < flat.Triangles.rows(); ++t)
  {
    if ((flat.Triangles.row(t).array() == corner).any() &&
      (flat.Triangles.row(t).array() == next).any())
    {
      around.push_back(t);
    }
  }
  ASSERT_EQ(around.size(), 1u);
  for (int& point : doubled.Triangles.row(around[0]).reshaped())
  {
    point = point == corner ? static_cast<int>(flat.Points.rows()) : point;
  }
  const std::vector<std::vector<int>> split = shape::FindBoundaryLoops(doubled).Loops;
  ASSERT_EQ(split.size(), 2u);
  EXPECT_EQ(split[1].size(), loops[1].size() + 1);
  const shape::FilledSurface filled = shape::FillLoops(doubled, { split[1] });
  EXPECT_EQ(shapetest::Crossings(filled), 0);
  // Every side of the hole has a triangle by number, the one without length, too.
  const shape::Topology topology = shape::ComputeTopology(filled.Surface);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.MisorientedEdges, 0);
}

TEST(HoleLoops, LoopsThatTouchThemselvesAreFilledApart)
{
  // Two triangles opposite each other around a point are missing.
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const int pole = static_cast<int>(sphere.Points.rows()) - 1;
  std::vector<int> fan;
  for (int t = 0; t < sphere.Triangles.rows(); ++t)
  {
    if ((sphere.Triangles.row(t).array() == pole).any())
    {
      fan.push_back(t);
    }
  }
  shape::Mesh open = sphere;
  const auto touch = [&](int a, int b)
  {
    int shared = 0;
    for (const int corner : sphere.Triangles.row(a))
    {
      shared += (sphere.Triangles.row(b).array() == corner).any() ? 1 : 0;
    }
    return shared;
  };
  const int other =
    *std::find_if(fan.begin() + 1, fan.end(), [&](int t) { return touch(fan[0], t) == 1; });
  int kept = 0;
  for (int t = 0; t < sphere.Triangles.rows(); ++t)
  {
    if (t != fan[0] && t != other)
    {
      open.Triangles.row(kept++) = sphere.Triangles.row(t);
    }
  }
  open.Triangles.conservativeResize(kept, 3);
  ASSERT_EQ(shape::ComputeTopology(open).NonManifoldPoints, 1);
  const shape::FilledSurface filled = shape::FillHoles(open);
  EXPECT_EQ(filled.Holes.size(), 2u);
  shapetest::ExpectSound(open, filled, 0, 2);
}

TEST(HoleLoops, AnEdgeThatIsThereIsNotMadeTwice)
{
  // A hexagon whose first and third point the surface joins by an edge of its own.
  shape::Mesh mesh = shapetest::Without(
    shapetest::FlatDisk(3), [](const Eigen::RowVector3d& p) { return p.norm() < 1.0 / 3.0; });
  std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(mesh).Loops;
  ASSERT_EQ(loops[1].size(), 6u);
  const int a = loops[1][0], b = loops[1][2];
  const auto top = static_cast<int>(mesh.Points.rows());
  mesh.Points.conservativeResize(top + 2, 3);
  mesh.Points.bottomRows(2) << 0.1, 0.1, 1.0, -0.1, 0.2, 1.0;
  const Eigen::Index old = mesh.Triangles.rows();
  mesh.Triangles.conservativeResize(old + 2, 3);
  mesh.Triangles.bottomRows(2) << a, b, top, b, a, top + 1;
  for (const shape::FillMethod method :
    { shape::FillMethod::Fair, shape::FillMethod::Deformation, shape::FillMethod::Membrane })
  {
    shape::FillHolesOptions options;
    options.Method = method;
    const shape::FilledSurface filled = shape::FillLoops(mesh, { loops[1] }, options);
    EXPECT_EQ(shape::ComputeTopology(filled.Surface).NonManifoldEdges, 0);
  }
}

TEST(HoleLoops, StronglyBentLoops)
{
  constexpr int count = 90;
  Eigen::MatrixXd saddle(count, 3), helix(count, 3), outwards(count, 3), beside(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    saddle.row(i) << std::cos(angle), std::sin(angle), 0.6 * std::cos(2.0 * angle);
    outwards.row(i) << 0.07 * std::cos(angle), 0.07 * std::sin(angle), 0.0;
    // Up two turns of a spring, and down another one.
    const double turn = i < count / 2 ? 2.0 * angle : 4.0 * M_PI - 2.0 * angle;
    const double radius = i < count / 2 ? 1.0 : 0.5;
    helix.row(i) << radius * std::cos(turn), radius * std::sin(turn), 0.25 * turn;
    beside.row(i) << (i < count / 2 ? 0.05 : -0.05) * std::cos(turn),
      (i < count / 2 ? 0.05 : -0.05) * std::sin(turn), 0.0;
  }
  for (const auto& [curve, away] : { std::pair<Eigen::MatrixXd, Eigen::MatrixXd>(saddle, outwards),
         std::pair<Eigen::MatrixXd, Eigen::MatrixXd>(helix, beside) })
  {
    const shape::Mesh ribbon = shapetest::Ribbon(curve, away);
    const std::vector<std::vector<int>> loop = shapetest::LoopOfPointZero(ribbon);
    ASSERT_EQ(loop.size(), 1u);
    const shape::FilledSurface filled = shape::FillLoops(ribbon, loop);
    shapetest::ExpectSound(ribbon, filled, 1, 1);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
    EXPECT_GT(filled.Holes[0].Nonplanarity, 0.1);
  }
}

TEST(HoleLoops, SmallCornersOfTheSurfaceThatReachInAreNotCovered)
{
  // A funnel's narrow end with tips a tenth as large as the sides between them: a triangle across
  // one would lie on it.
  constexpr int tips = 24;
  Eigen::MatrixXd curve(4 * tips, 3), away(4 * tips, 3);
  for (int i = 0; i < curve.rows(); ++i)
  {
    const std::array<double, 4> steps = { 0.0, 0.45, 0.5, 0.55 };
    const double angle = 2.0 * M_PI * (i / 4 + steps[i % 4]) / tips;
    const double up = i % 4 == 2 ? 0.005 : 0.0;
    const Eigen::RowVector3d out(std::cos(angle), std::sin(angle), 0.0);
    curve.row(i) = (1.0 + 0.5 * up) * out + up * Eigen::RowVector3d::UnitZ();
    away.row(i) = -0.05 * out - 0.1 * Eigen::RowVector3d::UnitZ();
  }
  const shape::Mesh funnel = shapetest::Ribbon(curve, away);
  for (const shape::FillMethod method :
    { shape::FillMethod::Deformation, shape::FillMethod::Fair, shape::FillMethod::Membrane })
  {
    shape::FillHolesOptions options;
    options.Method = method;
    const shape::FilledSurface filled =
      shape::FillLoops(funnel, shapetest::LoopOfPointZero(funnel), options);
    shapetest::ExpectSound(funnel, filled, 1, 1);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
    for (const auto& triangle :
      filled.Surface.Triangles.bottomRows(filled.Holes[0].Triangles).rowwise())
    {
      EXPECT_GE(triangle.maxCoeff(), 4 * tips) << "three corners on the rim";
    }
  }
}

TEST(HoleLoops, FillsOfAScanMeetNeitherItNorEachOther)
{
  const shape::Mesh open = shapetest::ReadModel("elephant-with-holes");
  const shape::FilledSurface filled = shape::FillHoles(open);
  // 106 loops, some of which touch themselves.
  EXPECT_EQ(filled.Holes.size(), 171u);
  EXPECT_EQ(shapetest::Crossings(filled), 0);
  EXPECT_EQ(filled.Surface.Triangles.topRows(open.Triangles.rows()), open.Triangles);
  EXPECT_EQ(shape::RequireManifold(filled.Surface, "the filled scan").BoundaryLoops, 0);
}

TEST(HoleLoops, FillsThatWouldMeetEachOtherAreReplacedBothOrOne)
{
  // Two caps are missing, one above the other: two domes through one another, or none.
  const shape::Mesh sphere = shapetest::Icosphere(3);
  shape::Mesh open =
    shapetest::Without(sphere, [](const Eigen::RowVector3d& p) { return p.z() > 0.2; });
  const auto points = static_cast<int>(open.Points.rows());
  const Eigen::Index triangles = open.Triangles.rows();
  open.Points.conservativeResize(2 * points, 3);
  open.Triangles.conservativeResize(2 * triangles, 3);
  open.Points.bottomRows(points) = open.Points.topRows(points);
  open.Points.bottomRows(points).col(2) = 1.6 - open.Points.topRows(points).col(2).array();
  open.Triangles.bottomRows(triangles) =
    open.Triangles.topRows(triangles).rowwise().reverse().array() + points;
  const shape::FilledSurface filled = shape::FillHoles(open);
  ASSERT_EQ(filled.Holes.size(), 2u);
  shapetest::ExpectSound(open, filled, 0, 4);
  EXPECT_EQ(shapetest::Crossings(filled), 0);
  for (const shape::FillMethod method : { shape::FillMethod::Fair, shape::FillMethod::Deformation })
  {
    shape::FillHolesOptions options;
    options.Method = method;
    EXPECT_GT(shapetest::Crossings(shape::FillHoles(open, options)), 0);
  }
}

TEST(HoleLoops, AutomaticTakesWhatMeetsTheSurfaceLeast)
{
  // Around a sheet's only border: a balloon that does not settle, or what goes through its waves.
  shape::Mesh sheet = shapetest::FlatDisk(12);
  for (auto row : sheet.Points.rowwise())
  {
    row(2) = 0.5 * std::pow(1.0 - row.squaredNorm(), 2) * std::sin(5.0 * row(0));
  }
  const auto filledBy = [&](shape::FillMethod method)
  {
    shape::FillHolesOptions options;
    options.Method = method;
    return shape::FillHoles(sheet, options);
  };
  const shape::FilledSurface filled = filledBy(shape::FillMethod::Automatic);
  shapetest::ExpectSound(sheet, filled, 0, 2);
  EXPECT_EQ(filled.Holes[0].Method, shape::FillMethod::Fair);
  EXPECT_NE(filled.Holes[0].Reason.find("did not converge"), std::string::npos);
  const int minimum = shapetest::Crossings(filled);
  EXPECT_EQ(shapetest::Crossings(filledBy(shape::FillMethod::Fair)), minimum);
  EXPECT_GT(shapetest::Crossings(filledBy(shape::FillMethod::Deformation)), minimum);
  EXPECT_GT(shapetest::Crossings(filledBy(shape::FillMethod::Membrane)), minimum);
}

TEST(HoleLoops, WhereTheFairSurfaceWouldMeetAnotherAnotherMethodIsTaken)
{
  // A wall through what the cap was.
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 60);
  const Eigen::RowVector3d axis = shapetest::CapAxis();
  const Eigen::RowVector3d side = Eigen::RowVector3d(0.5, 0.3, 0.0).normalized();
  const Eigen::RowVector3d other = axis.cross(side);
  shape::Mesh walled = open;
  const auto first = static_cast<int>(open.Points.rows());
  walled.Points.conservativeResize(first + 3, 3);
  walled.Points.row(first) = 0.8 * axis + 0.3 * side;
  walled.Points.row(first + 1) = 0.8 * axis - 0.3 * side;
  walled.Points.row(first + 2) = 1.5 * axis + 0.1 * other;
  walled.Triangles.conservativeResize(open.Triangles.rows() + 1, 3);
  walled.Triangles.bottomRows(1) << first, first + 1, first + 2;
  const std::vector<std::vector<int>> loops = { shape::FindBoundaryLoops(open).Loops };
  const shape::FilledSurface filled = shape::FillLoops(walled, loops);
  EXPECT_EQ(filled.Holes[0].Method, shape::FillMethod::Membrane);
  EXPECT_NE(filled.Holes[0].Reason.find("intersects itself or the surface"), std::string::npos);
  EXPECT_EQ(shapetest::Crossings(filled), 0);
  // Asked for, it is made all the same, and what it meets is counted.
  shape::FillHolesOptions options;
  options.Method = shape::FillMethod::Fair;
  const shape::FilledSurface fair = shape::FillLoops(walled, loops, options);
  EXPECT_GT(fair.Holes[0].SelfIntersections, 0);
  EXPECT_EQ(static_cast<std::size_t>(fair.Holes[0].SelfIntersections),
    shape::FindPatchSelfIntersections(fair.Surface, static_cast<int>(walled.Triangles.rows()))
      .size());
}

TEST(HoleLoops, EdgesGrowWhereALargeLoopWouldTakeTooManyPoints)
{
  // 2,000 points around, which edges of one length would fill with 360,000.
  constexpr int count = 2000;
  Eigen::MatrixXd circle(count, 3), away(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    away.row(i) << std::cos(angle), std::sin(angle), -0.5;
    circle.row(i) << std::cos(angle), std::sin(angle), 0.0;
  }
  const shape::Mesh ribbon = shapetest::Ribbon(circle, 1e-3 * away);
  shape::FillHolesOptions options;
  options.Filler.MaximumPoints = 5000;
  for (const shape::FillMethod method :
    { shape::FillMethod::Membrane, shape::FillMethod::Automatic })
  {
    options.Method = method;
    const shape::FilledSurface filled =
      shape::FillLoops(ribbon, shapetest::LoopOfPointZero(ribbon), options);
    EXPECT_LT(filled.Holes[0].Points, 10000);
    EXPECT_GT(filled.Holes[0].Points, 1000);
    shapetest::ExpectSound(ribbon, filled, 1, 1);
  }
}

TEST(HoleLoops, LoopsAreChosen)
{
  const shape::Mesh open = shapetest::Without(shapetest::Icosphere(4),
    [](const Eigen::RowVector3d& p) { return p.z() > 0.8 || p.z() < -0.9 || p.x() > 0.95; });
  const std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(open).Loops;
  ASSERT_EQ(loops.size(), 3u);
  shape::LoopChoice choice;
  using Type = shape::LoopChoice::LoopsType;
  EXPECT_EQ(shape::ChooseLoops(open.Points, loops, choice), (std::vector<int>{ 0, 1, 2 }));
  choice.Loops = Type::Longest;
  EXPECT_EQ(shape::ChooseLoops(open.Points, loops, choice), (std::vector<int>{ 0 }));
  choice.Loops = Type::Chosen;
  choice.Indices = { 2, 1, 2 };
  EXPECT_EQ(shape::ChooseLoops(open.Points, loops, choice), (std::vector<int>{ 1, 2 }));
  choice.Indices = { 3 };
  EXPECT_THROW(shape::ChooseLoops(open.Points, loops, choice), shape::InvalidInput);
  choice = {};
  choice.MaximumLength = 0.5 *
    (shape::ComputeLoopLength(open.Points, loops[0]) +
      shape::ComputeLoopLength(open.Points, loops[1]));
  EXPECT_EQ(shape::ChooseLoops(open.Points, loops, choice), (std::vector<int>{ 1, 2 }));
}
