#include "Hex/SmoothBlockMap.h"
#include "Hex/StructuredBlocks.h"
#include "Mesh/Extent.h"
#include "Mesh/HexMesh.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

const Eigen::RowVector3i Counts(9, 7, 12);

/// A map that is a cubic polynomial along each axis.
Eigen::MatrixXd Cubic(const Eigen::MatrixXd& at)
{
  Eigen::MatrixXd values(at.rows(), 3);
  const auto x = at.col(0).array(), y = at.col(1).array(), z = at.col(2).array();
  values.col(0) = x + 0.3 * y.cube() * z - 0.2 * x.square() * z;
  values.col(1) = y - 0.1 * x.cube() * y.square() * z.cube();
  values.col(2) = 2.0 * z + 0.4 * x * y * z - 0.5;
  return values;
}

Eigen::MatrixXd Waves(const Eigen::MatrixXd& at)
{
  return (3.0 * at.array()).sin() + 0.2 * (at.rowwise().reverse().array() * 5.0).cos();
}

double LargestError(int factor)
{
  const Eigen::RowVector3i counts = (Counts.array() - 1) * factor + 1;
  const Eigen::MatrixXd at = shape::NodeParameters(counts);
  const shape::BlockSpline spline = shape::FitBlockSpline(counts, Waves(at));
  return (shape::Evaluate(spline, at) - Waves(at)).rowwise().norm().maxCoeff();
}

} // namespace

TEST(StructuredBlocks, CubicMapsAreReproduced)
{
  const Eigen::MatrixXd nodes = shape::NodeParameters(Counts);
  const shape::BlockSpline spline = shape::FitBlockSpline(Counts, Cubic(nodes));
  EXPECT_EQ(spline.Counts, Eigen::RowVector3i(5, 4, 6));
  EXPECT_EQ(spline.Controls.rows(), 5 * 4 * 6);
  EXPECT_LT((shape::Evaluate(spline, nodes) - Cubic(nodes)).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd between = shape::NodeParameters({ 14, 3, 8 });
  EXPECT_LT((shape::Evaluate(spline, between) - Cubic(between)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(StructuredBlocks, TheErrorFallsWithTheFourthPowerOfTheDistance)
{
  // Splines of degree 3 approximate smooth functions with the order 4.
  const double coarse = LargestError(2), fine = LargestError(4);
  EXPECT_GT(std::log2(coarse / fine), 3.5);
}

TEST(StructuredBlocks, AsManyControlPointsAsNodesInterpolate)
{
  const Eigen::MatrixXd nodes = shape::NodeParameters(Counts);
  Eigen::MatrixXd values = Waves(nodes);
  values(100, 1) += 1.0;
  const shape::BlockSpline spline = shape::FitBlockSpline(Counts, values, { 3, 1.0 });
  EXPECT_LT((shape::Evaluate(spline, nodes) - values).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(StructuredBlocks, BlocksAgreeOnTheSideThatTheyShare)
{
  // The upper side of one block along the first axis is the lower side of the other one.
  Eigen::MatrixXd at = shape::NodeParameters(Counts);
  const shape::BlockSpline one = shape::FitBlockSpline(Counts, Waves(at));
  const Eigen::RowVector3i counts(4, Counts(1), Counts(2));
  at = shape::NodeParameters(counts);
  at.col(0).array() += 1.0;
  const shape::BlockSpline other = shape::FitBlockSpline(counts, Waves(at));
  Eigen::MatrixXd side = shape::NodeParameters({ 2, 11, 23 });
  side.col(0).setConstant(1.0);
  const Eigen::MatrixXd first = shape::Evaluate(one, side);
  side.col(0).setZero();
  EXPECT_LT((first - shape::Evaluate(other, side)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(StructuredBlocks, CellsThatFillNoBoxAreRefused)
{
  // Two cells of a row of two, of which both have the same index, or one is missing.
  Eigen::MatrixXd positions(12, 3);
  for (int i = 0; i < 12; ++i)
  {
    positions.row(i) << i % 3, i / 3 % 2, i / 6;
  }
  Eigen::MatrixXi cells(2, 8), indices(2, 3);
  cells << 0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10;
  indices << 0, 0, 0, 1, 0, 0;
  const Eigen::VectorXi block = Eigen::VectorXi::Zero(2);
  const std::vector<shape::GridBlock> blocks =
    shape::FindGridBlocks(cells, positions, block, indices);
  ASSERT_EQ(blocks.size(), 1);
  EXPECT_EQ(blocks[0].Counts, Eigen::RowVector3i(3, 2, 2));
  EXPECT_EQ(blocks[0].Nodes, Eigen::VectorXi::LinSpaced(12, 0, 11));
  indices(1, 0) = 2;
  EXPECT_REFUSED(shape::FindGridBlocks(cells, positions, block, indices), "block 0 has 2 cells",
    "do not fill a box");
  EXPECT_REFUSED(shape::FitBlockSpline(Counts, positions, { 0, 2.0 }), "Degree is 0");
}

namespace
{

/// The cells of a box of nodes.
Eigen::MatrixXi CellsOf(const Eigen::RowVector3i& counts)
{
  const Eigen::RowVector3i cells = counts.array() - 1;
  Eigen::MatrixXi corners(cells.prod(), 8);
  for (int cell = 0; cell < static_cast<int>(corners.rows()); ++cell)
  {
    const int i = cell % cells(0), j = cell / cells(0) % cells(1), k = cell / cells(0) / cells(1);
    const int first = i + counts(0) * (j + counts(1) * k), layer = counts(0) * counts(1);
    corners.row(cell) << first, first + 1, first + counts(0) + 1, first + counts(0), first + layer,
      first + layer + 1, first + layer + counts(0) + 1, first + layer + counts(0);
  }
  return corners;
}

double SplineError(const std::vector<shape::GridBlock>& blocks, const Eigen::MatrixXd& targets)
{
  return (shape::EvaluateAtNodes(blocks, targets) - targets).rowwise().norm().maxCoeff();
}

} // namespace

TEST(StructuredBlocks, PlacesOfNodesOnASurfaceNeedNotBeFollowed)
{
  // Every second node of a cube moves along its side, which splines with half the nodes cannot
  // follow. The shape, a cube, they can.
  const Eigen::RowVector3i counts(13, 13, 13);
  const Eigen::MatrixXi cells = CellsOf(counts);
  Eigen::MatrixXd targets = shape::NodeParameters(counts);
  const shape::GridBlock block{ counts,
    Eigen::VectorXi::LinSpaced(counts.prod(), 0, counts.prod() - 1) };
  const Eigen::MatrixXd straight = targets;
  for (Eigen::Index node = 0; node < targets.rows(); ++node)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double& at = targets(node, axis);
      at += at > 0.0 && at < 1.0 ? (node % 2 == 0 ? 0.015 : -0.015) : 0.0;
    }
  }
  const shape::Mesh cube = shapetest::Box({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  const shape::SmoothBlockMap smooth = shape::SmoothMapOfBlocks({ block }, cells, targets, cube);
  EXPECT_GT(SplineError({ block }, targets), 1e-2);
  EXPECT_LT((smooth.Splines - smooth.Targets).rowwise().norm().maxCoeff(), 1e-6);
  EXPECT_LT(SplineError({ block }, smooth.Splines), 1e-8);
  EXPECT_EQ(smooth.Inverted, 0);
  EXPECT_NEAR(smooth.LargestMotion, (smooth.Targets - targets).rowwise().norm().maxCoeff(), 1e-15);
  // Nodes stay on their side, edge or corner.
  for (Eigen::Index i = 0; i < targets.size(); ++i)
  {
    if (const double at = straight.data()[i]; at == 0.0 || at == 1.0)
    {
      EXPECT_NEAR(smooth.Targets.data()[i], at, 1e-12);
    }
  }
  shape::SmoothBlockMapOptions options;
  options.FeatureAngle = 0.0;
  EXPECT_REFUSED(
    shape::SmoothMapOfBlocks({ block }, cells, targets, cube, options), "FeatureAngle is 0");
}

TEST(StructuredBlocks, WeightsLowerTheLargestDistanceFromABentSolid)
{
  // A bent ellipsoid, whose block has an eighth as many control points as nodes.
  const auto bend = [](Eigen::MatrixXd points)
  {
    points.col(2) = 0.8 * points.col(2) + 0.2 * points.col(0).cwiseAbs2();
    points.col(0) *= 1.3;
    return points;
  };
  const Eigen::RowVector3i counts(24, 24, 24);
  Eigen::MatrixXd ball = 2.0 * shape::NodeParameters(counts).array() - 1.0;
  for (Eigen::Index node = 0; node < ball.rows(); ++node)
  {
    ball.row(node) *= ball.row(node).cwiseAbs().maxCoeff() / ball.row(node).norm();
  }
  shape::Mesh surface = shapetest::Icosphere(5);
  surface.Points = bend(surface.Points);
  const Eigen::MatrixXd targets = bend(ball);
  const shape::GridBlock block{ counts,
    Eigen::VectorXi::LinSpaced(counts.prod(), 0, counts.prod() - 1) };
  const shape::SmoothBlockMap smooth =
    shape::SmoothMapOfBlocks({ block }, CellsOf(counts), targets, surface);
  const double diagonal = shape::ComputeBoxDiagonal(surface);
  const double largest = (smooth.Splines - smooth.Targets).rowwise().norm().maxCoeff() / diagonal;
  EXPECT_GT(SplineError({ block }, targets) / diagonal, 2e-3);
  EXPECT_LE(largest, 1e-3);
  EXPECT_LT(SplineError({ block }, smooth.Splines), 1e-8 * diagonal) << "splines go through them";
}
