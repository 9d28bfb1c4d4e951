#include "Base/Errors.h"
#include "Fill/FillHoles.h"
#include "Mesh/Surface.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace
{

/// RMS over the points of the first fill.
double RadiusError(const shape::FilledSurface& filled)
{
  const shape::FilledHole& hole = filled.Holes[0];
  const Eigen::ArrayXd errors =
    filled.Surface.Points.middleRows(hole.FirstPoint, hole.Points).rowwise().norm().array() - 1.0;
  return std::sqrt(errors.square().mean());
}

/// Each from its least corner on, in order.
std::vector<std::array<int, 3>> SortedTriangles(const shape::Mesh& mesh)
{
  std::vector<std::array<int, 3>> triangles;
  for (const auto& row : mesh.Triangles.rowwise())
  {
    std::array<int, 3> triangle = { row(0), row(1), row(2) };
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

} // namespace

TEST(FillHoles, ASpheresCapComesBack)
{
  for (const auto& [degrees, bound] :
    { std::pair<double, double>{ 20, 1e-4 }, { 40, 1e-4 }, { 70, 1e-4 }, { 110, 3e-4 } })
  {
    const shape::Mesh open = shapetest::SphereWithoutCap(4, degrees);
    const shape::FilledSurface filled = shape::FillHoles(open);
    ASSERT_EQ(filled.Holes.size(), 1u);
    EXPECT_EQ(filled.Holes[0].Method, shape::FillMethod::Fair);
    EXPECT_EQ(filled.Holes[0].Reason, "");
    EXPECT_LT(RadiusError(filled), bound) << degrees;
    EXPECT_LT(filled.Holes[0].DeviationAfter, 0.5);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
    const shape::Topology topology = shape::RequireClosedSurface(filled.Surface, "the sphere");
    EXPECT_EQ(topology.EulerNumber, 2);
    // Triangles as large as the others, on the average.
    const Eigen::VectorXd areas = shape::ComputeAreaVectors(filled.Surface).rowwise().norm();
    const double old = areas.head(open.Triangles.rows()).mean();
    const double made = areas.tail(filled.Holes[0].Triangles).mean();
    EXPECT_GT(made, 0.4 * old) << degrees;
    EXPECT_LT(made, 1.5 * old) << degrees;
  }
}

TEST(FillHoles, EachMethodKeepsTheInputAndClosesIt)
{
  shape::Mesh torus = shapetest::Torus(1.0, 0.4, 60, 24);
  torus = shapetest::Without(torus,
    [](const Eigen::RowVector3d& p)
    {
      return (p - Eigen::RowVector3d(1.4, 0, 0)).norm() < 0.35 ||
        (p - Eigen::RowVector3d(-0.6, 0, 0)).norm() < 0.25 ||
        (p - Eigen::RowVector3d(0, 1.0, 0.4)).norm() < 0.3;
    });
  for (const shape::FillMethod method : { shape::FillMethod::Automatic,
         shape::FillMethod::Deformation, shape::FillMethod::Fair, shape::FillMethod::Membrane })
  {
    shape::FillHolesOptions options;
    options.Method = method;
    const shape::FilledSurface filled = shape::FillHoles(torus, options);
    EXPECT_EQ(filled.Holes.size(), 3u);
    shapetest::ExpectSound(torus, filled, 0, 0);
    EXPECT_EQ(shapetest::Crossings(filled), 0);
    for (const shape::FilledHole& hole : filled.Holes)
    {
      EXPECT_LE(hole.DeviationAfter, hole.DeviationBefore);
      if (method != shape::FillMethod::Membrane)
      {
        EXPECT_LT(hole.DeviationAfter, method == shape::FillMethod::Deformation ? 6.0 : 3.0);
      }
    }
    // Some loops only.
    const std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(torus).Loops;
    shapetest::ExpectSound(torus, shape::FillLoops(torus, { loops[1] }, options), 2, -2);
  }
}

TEST(FillHoles, InAPlaneFillsLieInIt)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 2).normalized()).toRotationMatrix();
  shape::Mesh flat = shapetest::Without(shapetest::FlatSquare(30, 0.3),
    [](const Eigen::RowVector3d& p) {
      return p.norm() < 0.4 || (p - Eigen::RowVector3d(0.7, 0.5, 0)).cwiseAbs().maxCoeff() < 0.2;
    });
  for (const bool isTurned : { false, true })
  {
    if (isTurned)
    {
      flat.Points =
        (100.0 * flat.Points * turn.transpose()).rowwise() + Eigen::RowVector3d(500.0, 0.0, -300.0);
    }
    std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(flat).Loops;
    loops.erase(loops.begin()); // the outer one
    ASSERT_GE(loops.size(), 2u);
    for (const shape::FillMethod method :
      { shape::FillMethod::Deformation, shape::FillMethod::Fair, shape::FillMethod::Membrane })
    {
      shape::FillHolesOptions options;
      options.Method = method;
      const shape::FilledSurface filled = shape::FillLoops(flat, loops, options);
      EXPECT_EQ(shapetest::Crossings(filled), 0);
      const Eigen::RowVector3d normal =
        isTurned ? Eigen::RowVector3d(turn.col(2).transpose()) : Eigen::RowVector3d(0, 0, 1);
      const Eigen::VectorXd heights =
        (filled.Surface.Points.rowwise() - filled.Surface.Points.row(0)) * normal.transpose();
      if (isTurned)
      {
        EXPECT_LT(heights.cwiseAbs().maxCoeff(), 1e-10 * 600.0);
      }
      else
      {
        EXPECT_LT(heights.cwiseAbs().maxCoeff(), 1e-14);
      }
      EXPECT_NEAR(0.5 * shape::ComputeAreaVectors(filled.Surface).rowwise().norm().sum(),
        isTurned ? 4e4 : 4.0, isTurned ? 1e-4 : 1e-8);
    }
  }
}

TEST(FillHoles, ACylindersWallGoesOn)
{
  // Around x, with the quads' triangles by turns.
  shape::Mesh wall = shapetest::FlatSquare(40, 0.25);
  wall.Points.leftCols<2>() *= 1.2;
  wall.Points.col(2) = wall.Points.col(1).array().cos();
  wall.Points.col(1) = wall.Points.col(1).array().sin().eval();
  const shape::Mesh open = shapetest::Without(wall,
    [](const Eigen::RowVector3d& p)
    { return std::hypot(p.x(), std::asin(std::clamp(p.y(), -1.0, 1.0))) < 0.6; });
  std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(open).Loops;
  ASSERT_EQ(loops.size(), 2u);
  const shape::FilledSurface filled = shape::FillLoops(open, { loops[1] });
  double worst = 0.0;
  for (int i = 0; i < filled.Holes[0].Points; ++i)
  {
    const auto p = filled.Surface.Points.row(filled.Holes[0].FirstPoint + i);
    worst = std::max(worst, std::abs(std::hypot(p(1), p(2)) - 1.0));
  }
  EXPECT_LT(worst, 2e-3);
}

TEST(FillHoles, MovesWithTheSurface)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.1, Eigen::Vector3d(-1, 3, 2).normalized()).toRotationMatrix();
  for (const double degrees : { 30.0, 70.0 })
  {
    const shape::Mesh open = shapetest::SphereWithoutCap(4, degrees);
    for (const double scale : { 1e-6, 20.0, 1e9 })
    {
      const Eigen::RowVector3d shift = scale * Eigen::RowVector3d(0.3, -1.5, 0.6);
      shape::Mesh moved = open;
      moved.Points = (scale * open.Points * turn.transpose()).rowwise() + shift;
      for (const shape::FillMethod method :
        { shape::FillMethod::Deformation, shape::FillMethod::Fair, shape::FillMethod::Membrane })
      {
        shape::FillHolesOptions options;
        options.Method = method;
        const shape::Mesh here = shape::FillHoles(open, options).Surface;
        const shape::Mesh there = shape::FillHoles(moved, options).Surface;
        ASSERT_EQ(there.Points.rows(), here.Points.rows());
        const Eigen::MatrixXd back = (there.Points.rowwise() - shift) * turn / scale;
        EXPECT_LT((back - here.Points).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_EQ(SortedTriangles(there), SortedTriangles(here));
      }
    }
  }
}

TEST(FillHoles, ParametersShapeTheFillLive)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 50);
  const Eigen::RowVector3d axis = shapetest::CapAxis();
  const std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(open).Loops;
  shape::SurfaceFiller filler(open, loops);
  shape::FillHolesOptions options;
  options.Method = shape::FillMethod::Deformation;
  const auto height = [&](const shape::FilledSurface& filled)
  {
    return (filled.Surface.Points.bottomRows(filled.Holes[0].Points) * axis.transpose()).maxCoeff();
  };
  const shape::FilledSurface plain = filler.Fill(options);
  // More rigid, it keeps the slope of the rim longer; a larger scale bulges, too.
  std::vector<double> heights;
  for (const double rigidity : { 0.4, 0.7, 1.0, 1.4, 2.0 })
  {
    options.Deformation.Rigidity = rigidity;
    heights.push_back(height(filler.Fill(options)));
  }
  EXPECT_TRUE(std::is_sorted(heights.begin(), heights.end()));
  EXPECT_GT(heights.back(), heights.front() + 0.01);
  options.Deformation = {};
  heights.clear();
  for (const double scale : { 0.8, 1.0, 1.2 })
  {
    options.Deformation.Scale = scale;
    heights.push_back(height(filler.Fill(options)));
  }
  EXPECT_TRUE(std::is_sorted(heights.begin(), heights.end()));
  // Normals that are drawn along the axis flatten it.
  options.Deformation = {};
  options.Frames.BiasFrame = { axis.x(), axis.y(), axis.z() };
  options.Frames.BiasWeight = 0.5;
  EXPECT_LT(height(filler.Fill(options)), height(plain) - 0.02);
  // With all frames those of the flat disk, the fill is as flat as its loop.
  options.Frames.BiasBy = shape::PoseOptions::BiasByType::Frame;
  options.Frames.BiasWeight = 1.0;
  const Eigen::VectorXd loop = open.Points(loops[0], Eigen::all) * axis.transpose();
  EXPECT_LT(height(filler.Fill(options)), 2.0 * loop.maxCoeff() - loop.minCoeff());
  // What was tuned before leaves no trace.
  options.Frames = {};
  EXPECT_EQ(filler.Fill(options).Surface.Points, plain.Surface.Points);
  EXPECT_EQ(shape::FillLoops(open, loops, options).Surface.Points, plain.Surface.Points);
}

TEST(FillHoles, FramesAreTurnedUntilNormalsAreMet)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 40);
  shape::FillHolesOptions options;
  options.Method = shape::FillMethod::Deformation;
  const shape::FilledHole with = shape::FillHoles(open, options).Holes[0];
  EXPECT_LT(with.DeviationAfter, 2.5);
  EXPECT_LT(with.DeviationAfter, with.DeviationBefore / 3.0);
  options.Filler.OptimizeNormals = false;
  const shape::FilledHole without = shape::FillHoles(open, options).Holes[0];
  EXPECT_NEAR(without.DeviationAfter, without.DeviationBefore, 1e-6);
  EXPECT_EQ(without.DeviationBefore, with.DeviationBefore);
}

TEST(FillHoles, DataGoOnFromTheRim)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 40);
  const shape::FilledSurface filled = shape::FillHoles(open);
  const shape::FilledHole& hole = filled.Holes[0];
  // Coordinates are harmonic on a minimal surface; on a sphere nearly so.
  const Eigen::MatrixXd own =
    shape::ExtendValuesOntoFill(filled.Surface, hole, filled.Surface.Points(hole.Loop, Eigen::all));
  const Eigen::MatrixXd positions = filled.Surface.Points.middleRows(hole.FirstPoint, hole.Points);
  EXPECT_LT((own - positions).rowwise().norm().maxCoeff(), 0.3);
  double low = 1.0, high = -1.0;
  for (const int point : hole.Loop)
  {
    low = std::min(low, filled.Surface.Points(point, 0));
    high = std::max(high, filled.Surface.Points(point, 0));
  }
  EXPECT_GE(own.col(0).minCoeff(), low);
  EXPECT_LE(own.col(0).maxCoeff(), high);
  const shape::Provenance& provenance = filled.Provenance;
  EXPECT_GE(provenance.Cells.minCoeff(), 0);
  EXPECT_LT(provenance.Cells.maxCoeff(), open.Triangles.rows());
  EXPECT_TRUE((provenance.Points.tail(hole.Points).array() == -1).all());
  // No point of the loop is nearer than the one whose data a point has.
  const Eigen::MatrixXd sources = provenance.Weights.bottomRows(hole.Points) * open.Points;
  for (Eigen::Index i = 0; i < hole.Points; ++i)
  {
    EXPECT_NEAR((sources.row(i) - positions.row(i)).norm(),
      (open.Points(hole.Loop, Eigen::all).rowwise() - positions.row(i)).rowwise().norm().minCoeff(),
      1e-15);
  }
}

TEST(FillHoles, NamesWhatIsWrong)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(3, 40);
  EXPECT_REFUSED(shape::FillLoops(open, { { 0, 1 } }), "a loop has 2 points");
  EXPECT_REFUSED(shape::FillLoops(open, { { 0, 1, 100000 } }), "contains point 100000");
  shape::FillHolesOptions options;
  options.Filler.EdgeGrowth = -0.1;
  EXPECT_REFUSED(shape::FillHoles(open, options), "EdgeGrowth is -0.1");
  options = {};
  options.Filler.MaximumPoints = 0;
  EXPECT_REFUSED(shape::FillHoles(open, options), "MaximumPoints is 0");
  options = {};
  options.Method = shape::FillMethod::Deformation;
  options.Deformation.UpwindRadius = 0.0;
  EXPECT_REFUSED(shape::FillHoles(open, options), "UpwindRadius is 0");
  shape::Mesh bad = open;
  bad.Points(0, 0) = std::nan("");
  EXPECT_REFUSED(shape::FillHoles(bad), "first at point 0");
}

TEST(FillHoles, StopsWhenTold)
{
  const shape::Mesh open = shapetest::SphereWithoutCap(4, 60);
  for (const double until : { 0.0, 0.2, 0.5, 0.75 })
  {
    const shape::Progress stop([&](double fraction) { return fraction < until; });
    EXPECT_THROW(shape::FillHoles(open, {}, stop), shape::Aborted);
  }
}
