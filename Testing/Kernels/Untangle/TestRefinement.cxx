#include "Quality/MapQuality.h"
#include "Support/CellCubes.h"
#include "Untangle/Untangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace
{

/// The mean of a measure of the map from `rest` to the solid, as Map Quality computes it.
double MeanMeasure(
  const shape::Cells& solid, const Eigen::MatrixXd& rest, shape::MapMeasure measure)
{
  shape::CellSimplices simplices;
  for (Eigen::Index cell = 0; cell < solid.Kinds.size(); ++cell)
  {
    simplices.Add(
      solid.Kinds(cell) == 10 ? shape::CellShape::Tetrahedron : shape::CellShape::Hexahedron,
      solid.Corners.data() + solid.Offsets(cell));
    simplices.EndCell();
  }
  const auto extent = shape::ComputeMapExtent(rest, solid.Points, simplices);
  const auto quality = shape::EvaluateMapQuality(rest, solid.Points, simplices, extent);
  return quality.Sizes.dot(quality.Measures.col(static_cast<int>(measure))) / quality.Sizes.sum();
}

TEST(Refinement, RecoversARigidMotionFromItsBoundary)
{
  using Refine = shape::RefineType;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  for (const int kind : { 10, 12, 13, 14 })
  {
    shape::Cells cells = shapetest::BuildCube(4, kind);
    const Eigen::MatrixXd rest = cells.Points, truth = rest * turn.transpose();
    cells.Points = shapetest::ShakeInCube(rest, 0.3, 5) * turn.transpose();
    for (const auto& [refine, least] : { std::pair(Refine::SymmetricDirichlet, 6.0),
           std::pair(Refine::ExponentialSymmetricDirichlet, std::exp(6.0)),
           std::pair(Refine::AMIPS, std::exp(1.5)), std::pair(Refine::ConformalAMIPS, 3.0),
           std::pair(Refine::Hencky, 0.0), std::pair(Refine::ARAP, 0.0) })
    {
      shape::UntangleOptions options;
      options.Refine = refine;
      const shape::UntangleResult result = shape::Untangle(cells, rest, options);
      const int name = static_cast<int>(refine);
      EXPECT_EQ(result.InvertedAfter, 0) << name;
      EXPECT_GE(result.MeasureBefore, result.MeasureAfter) << name;
      EXPECT_NEAR(result.MeasureAfter, least, 1e-4 * std::max(1.0, least)) << name << ' ' << kind;
      EXPECT_LT((result.Solid.Points - truth).cwiseAbs().maxCoeff(), 0.01) << name << ' ' << kind;
    }
  }
}

TEST(Refinement, LowersTheMeasureOfMapQuality)
{
  using Refine = shape::RefineType;
  using Measure = shape::MapMeasure;
  for (const int kind : { 10, 12 })
  {
    // The boundary is sheared and bent, so that no inner points give an isometry.
    shape::Cells cells = shapetest::BuildCube(5, kind);
    const Eigen::MatrixXd rest = cells.Points;
    cells.Points = shapetest::ShakeInCube(rest, 0.3, 3);
    cells.Points.col(0) += cells.Points.col(2).cwiseAbs2();
    for (const auto& [refine, measure] :
      { std::pair(Refine::SymmetricDirichlet, Measure::SymmetricDirichlet),
        std::pair(Refine::AMIPS, Measure::AMIPS), std::pair(Refine::Hencky, Measure::Hencky),
        std::pair(Refine::ARAP, Measure::ARAP) })
    {
      shape::UntangleOptions options;
      options.Refine = refine;
      const shape::UntangleResult result = shape::Untangle(cells, rest, options);
      EXPECT_EQ(result.InvertedAfter, 0);
      EXPECT_LT(result.MeasureAfter, result.MeasureBefore);
      EXPECT_NEAR(MeanMeasure(result.Solid, rest, measure) / result.MeasureAfter, 1.0, 1e-9);
      // Stationary: no inner point moved alone lowers the mean.
      for (const int point : { 86, 93, 128 })
      {
        shape::Cells moved = result.Solid;
        ASSERT_TRUE(shapetest::IsInCube(rest.row(point)));
        for (int axis = 0; axis < 3; ++axis)
        {
          double slope = 0.0;
          for (const double sign : { 1.0, -1.0 })
          {
            moved.Points = result.Solid.Points;
            moved.Points(point, axis) += sign * 1e-5;
            slope += sign * MeanMeasure(moved, rest, measure) / 2e-5;
          }
          EXPECT_NEAR(slope / result.MeasureAfter, 0.0, 0.01) << static_cast<int>(measure);
        }
      }
    }
  }
}

TEST(Refinement, SlidesBoundaryPointsIfTheyAreNotFixed)
{
  // Points of the faces are shaken in their planes; regular hexahedra are recovered only if these
  // points slide.
  shape::Cells cells = shapetest::BuildCube(4, 12);
  const Eigen::MatrixXd regular = cells.Points;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-0.07, 0.07);
  for (Eigen::Index i = 0; i < regular.rows(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = regular(i, axis);
      cells.Points(i, axis) += x > 0.0 && x < 1.0 ? uniform(random) : 0.0;
    }
  }
  shape::UntangleOptions options;
  options.Refine = shape::RefineType::SymmetricDirichlet;
  const double fixed = shape::Untangle(cells, regular, options).MeasureAfter;
  options.FixBoundary = false;
  const shape::UntangleResult result = shape::Untangle(cells, regular, options);
  EXPECT_LT(result.MeasureAfter - 6.0, 0.02 * (fixed - 6.0));
  EXPECT_LT((result.Solid.Points - regular).cwiseAbs().maxCoeff(), 0.02);
  for (Eigen::Index i = 0; i < regular.rows(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (regular(i, axis) == 0.0 || regular(i, axis) == 1.0)
      {
        EXPECT_NEAR(result.Solid.Points(i, axis), regular(i, axis), 1e-12) << "faces stay plane";
      }
    }
  }
}

TEST(Refinement, LeavesThePointsOfInvertedCells)
{
  // A corner of the cube is pushed through to the other side, so its cells stay inverted.
  shape::Cells cells = shapetest::BuildCube(4, 12);
  cells.Points = shapetest::ShakeInCube(cells.Points, 0.05, 2);
  cells.Points.row(0) << 0.6, 0.6, 0.6;
  const shape::UntangleResult before = shape::Untangle(cells);
  shape::UntangleOptions options;
  options.Refine = shape::RefineType::SymmetricDirichlet;
  const shape::UntangleResult result = shape::Untangle(cells, {}, options);
  ASSERT_GT(result.InvertedAfter, 0);
  EXPECT_EQ(result.Inverted, before.Inverted);
  EXPECT_LT(result.MeasureAfter, result.MeasureBefore);
  for (int cell = 0; cell < result.Inverted.size(); ++cell)
  {
    for (int k = 0; result.Inverted(cell) && k < 8; ++k)
    {
      const int point = result.Solid.Corners(8 * cell + k);
      EXPECT_EQ(result.Solid.Points.row(point), before.Solid.Points.row(point));
    }
  }
}

} // namespace
