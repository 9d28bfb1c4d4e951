#include "Base/Errors.h"
#include "Geometry/PositiveTetrahedron.h"
#include "Support/CellCubes.h"
#include "Support/Refusals.h"
#include "Untangle/Private/TutteEmbedding.h"
#include "Untangle/Untangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace
{

double Volume(const shape::Cells& solid, int cell)
{
  const int first = solid.Offsets(cell);
  const auto p = [&](int k) -> Eigen::RowVector3d
  { return solid.Points.row(solid.Corners(first + k)); };
  return (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6.0;
}

/// Tetrahedra that are not positive, told exactly, without the kernel's own count.
int CountNegative(const shape::Cells& solid)
{
  int count = 0;
  for (int cell = 0; cell < solid.Kinds.size(); ++cell)
  {
    count += !shape::IsPositive(solid.Points, solid.Corners.data() + solid.Offsets(cell));
  }
  return count;
}

TEST(MeanPositions, PointsInsideAreTheMeansOfTheirNeighbours)
{
  shape::Cells cells = shapetest::BuildCube(4, 12);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  const shape::SolidCells regular(cells, {}, "the cube");
  for (int point = 0; point < regular.PointCount(); ++point)
  {
    if (!regular.OnBoundary(point))
    {
      cells.Points.row(point) << uniform(random), uniform(random), uniform(random);
    }
  }
  // Wherever they were: in a cube of hexahedra, neighbours lie evenly around.
  const Eigen::MatrixXd means =
    shape::SolveTutteEmbedding(shape::SolidCells(cells, {}, "the cube"), {});
  EXPECT_LT((means - regular.Points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Untangle, MakesEveryKindOfCellPositive)
{
  for (const int kind : { 10, 12, 13, 14 })
  {
    shape::Cells cells = shapetest::BuildCube(5, kind);
    const Eigen::MatrixXd rest = cells.Points;
    cells.Points = shapetest::ShakeInCube(rest, 0.5, 7);
    for (const bool withRest : { true, false })
    {
      const shape::UntangleResult result =
        shape::Untangle(cells, withRest ? rest : Eigen::MatrixXd());
      EXPECT_GT(result.InvertedBefore, cells.Kinds.size() / 4) << kind;
      EXPECT_EQ(result.InvertedAfter, 0) << kind;
      EXPECT_EQ(result.Inverted.sum(), 0);
      EXPECT_EQ(result.SplitCells, 0) << kind;
      EXPECT_EQ(result.Solid.Corners, cells.Corners);
      for (Eigen::Index i = 0; i < rest.rows(); ++i)
      {
        if (!shapetest::IsInCube(rest.row(i)))
        {
          EXPECT_EQ(result.Solid.Points.row(i), cells.Points.row(i)) << "the boundary stays";
        }
      }
    }
  }
}

TEST(Untangle, LeavesWhatIsNotInvertedToTheBit)
{
  shape::Cells cells = shapetest::BuildCube(4, 10);
  cells.Points = shapetest::ShakeInCube(cells.Points, 0.03, 1);
  ASSERT_EQ(CountNegative(cells), 0);
  const shape::UntangleResult whole = shape::Untangle(cells);
  EXPECT_EQ(whole.Solid.Points, cells.Points);
  EXPECT_EQ(whole.Iterations, 0);
  // One point across its neighbours: only what is near it moves.
  cells = shapetest::BuildCube(8, 10);
  const Eigen::Index middle = (4 * 9 + 4) * 9 + 4;
  cells.Points.row(middle) += Eigen::RowVector3d(0.3, 0.01, 0.02);
  const shape::UntangleResult result = shape::Untangle(cells);
  EXPECT_GT(result.InvertedBefore, 0);
  EXPECT_EQ(result.InvertedAfter, 0);
  EXPECT_LE(result.MovedPoints, 27);
}

TEST(Untangle, IsTheSameInEveryScaleAndPlace)
{
  shape::Cells cells = shapetest::BuildCube(5, 10);
  const Eigen::MatrixXd rest = cells.Points;
  cells.Points = shapetest::ShakeInCube(rest, 0.4, 11);
  const shape::UntangleResult result = shape::Untangle(cells, rest);
  // A power of two loses no bit.
  shape::Cells small = cells;
  small.Points *= 1.0 / 1024.0;
  const shape::UntangleResult smaller = shape::Untangle(small, rest);
  EXPECT_EQ(smaller.InvertedAfter, 0);
  EXPECT_LT((1024.0 * smaller.Solid.Points - result.Solid.Points).cwiseAbs().maxCoeff(), 1e-6);
  const shape::UntangleResult again = shape::Untangle(cells, rest);
  EXPECT_EQ(again.Solid.Points, result.Solid.Points) << "the same bits";
}

TEST(Untangle, ReportsProgressThatOnlyRises)
{
  shape::Cells cells = shapetest::BuildCube(5, 10);
  const Eigen::MatrixXd rest = cells.Points;
  cells.Points = shapetest::ShakeInCube(rest, 0.6, 3);
  // A corner beyond the opposite one: cells stay inverted, so that everything is tried.
  cells.Points.row(0) << 1.2, 1.3, 1.4;
  double last = 0.0;
  int falls = 0, reports = 0;
  const shape::Progress progress(
    [&](double share)
    {
      // Sums of shares are rounded.
      falls += share < last - 1e-12;
      last = share;
      return ++reports > 0;
    });
  EXPECT_GT(shape::Untangle(cells, rest, {}, progress).InvertedAfter, 0);
  EXPECT_GT(reports, 1000);
  EXPECT_EQ(falls, 0);
  EXPECT_EQ(last, 1.0);
}

TEST(Untangle, SplitsWhatHasNoRoom)
{
  // Four tetrahedra around the axis 0-1, every point on the boundary.
  shape::Cells cells{ Eigen::MatrixXd(6, 3), Eigen::VectorXi::Constant(4, 10), Eigen::VectorXi(5),
    Eigen::VectorXi(16) };
  const Eigen::RowVector3d ring[4] = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 0, -1 }, { -1, 0, 0 } };
  cells.Points.row(0) << 0, -1, 0;
  cells.Points.row(1) << 0, 1, 0;
  for (int k = 0; k < 4; ++k)
  {
    cells.Points.row(2 + k) = ring[k];
    cells.Offsets(k) = 4 * k;
    cells.Corners.segment<4>(4 * k) << 0, 1, 2 + k, 2 + (k + 1) % 4;
  }
  cells.Offsets(4) = 16;
  ASSERT_EQ(CountNegative(cells), 0);
  const Eigen::MatrixXd rest = cells.Points;
  // The roof's ridge sinks below the axis 0-1: the two tetrahedra beside it turn inside out.
  cells.Points.row(2) << 0, 0, -0.2;
  const int before = CountNegative(cells);
  ASSERT_EQ(before, 2);
  const shape::UntangleResult result = shape::Untangle(cells, rest);
  EXPECT_EQ(result.InvertedBefore, 2);
  EXPECT_EQ(result.InvertedAfter, 0);
  EXPECT_EQ(CountNegative(result.Solid), 0);
  EXPECT_GT(result.SplitCells, 0);
  EXPECT_EQ(result.Solid.Points.topRows(6), cells.Points);
  double sum = 0.0;
  for (int cell = 0; cell < result.Solid.Kinds.size(); ++cell)
  {
    sum += Volume(result.Solid, cell);
  }
  double given = 0.0;
  for (int cell = 0; cell < 4; ++cell)
  {
    given += Volume(cells, cell);
  }
  EXPECT_NEAR(sum, given, 1e-12) << "the boundary is the same";
  const shape::Provenance& provenance = result.Provenance;
  ASSERT_EQ(result.Solid.Points.rows(), provenance.Points.size());
  EXPECT_EQ(provenance.Points.head(6), Eigen::VectorXi::LinSpaced(6, 0, 5));
  EXPECT_TRUE((provenance.Points.tail(provenance.Points.size() - 6).array() == -1).all());
  EXPECT_LT((provenance.Weights * Eigen::VectorXd::Ones(6) -
              Eigen::VectorXd::Ones(provenance.Points.size()))
              .cwiseAbs()
              .maxCoeff(),
    1e-15);
  EXPECT_EQ(provenance.Cells.head(4), Eigen::Vector4i(0, 1, 2, 3));
  EXPECT_LT(provenance.Cells.maxCoeff(), 4);
}

TEST(Untangle, SaysWhatMustStayInverted)
{
  shape::Cells cells = shapetest::BuildCube(3, 12);
  const Eigen::MatrixXd rest = cells.Points;
  // A corner of the boundary beyond its opposite: no inner point can mend its own hexahedron.
  cells.Points.row(0) << 0.9, 0.9, 0.9;
  shape::UntangleOptions options;
  options.MaximumIterations = 20;
  const shape::UntangleResult result = shape::Untangle(cells, rest, options);
  EXPECT_GT(result.InvertedAfter, 0);
  EXPECT_EQ(result.Inverted.sum(), result.InvertedAfter);
  EXPECT_EQ(result.Inverted(0), 1);
  EXPECT_EQ(result.Solid.Points.row(0), cells.Points.row(0));
  EXPECT_TRUE(result.Solid.Points.allFinite());
}

// The work is counted step by step, so a limit of it is met exactly, and a smaller one than that of
// a step moves nothing.
TEST(Untangle, DoesNoMoreWorkThanItMay)
{
  shape::Cells cells = shapetest::BuildCube(6, 10);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    const Eigen::Array3d position = cells.Points.row(i).transpose();
    if (position.minCoeff() > 1e-9 && position.maxCoeff() < 1.0 - 1e-9)
    {
      cells.Points.row(i) = 1.0 - position.transpose();
    }
  }
  shape::UntangleOptions options;
  const shape::UntangleResult free = shape::Untangle(cells, {}, options);
  EXPECT_EQ(free.InvertedAfter, 0);
  EXPECT_GT(free.Work, 0.0);
  options.MaximumWork = free.Work;
  EXPECT_EQ(shape::Untangle(cells, {}, options).Solid.Points, free.Solid.Points);
  options.MaximumWork = 0.8 * free.Work;
  const shape::UntangleResult less = shape::Untangle(cells, {}, options);
  EXPECT_GT(less.Work, 0.0);
  EXPECT_LE(less.Work, options.MaximumWork);
  options.MaximumWork = 1.0;
  EXPECT_EQ(shape::Untangle(cells, {}, options).Iterations, 0);
  options.MaximumWork = 0.0;
  EXPECT_REFUSED(shape::Untangle(cells, {}, options), "MaximumWork");
}

TEST(Untangle, SlidesAlongTheBoundaryAndItsCreases)
{
  shape::Cells cells = shapetest::BuildCube(4, 10);
  const auto at = [](int i, int j, int k) { return (k * 5 + j) * 5 + i; };
  // Points of a face and of an edge are beyond their neighbours in it.
  cells.Points.row(at(2, 2, 0)) << 0.9, 0.55, 0.0;
  cells.Points.row(at(2, 0, 0)) << 0.8, 0.0, 0.0;
  shape::UntangleOptions options;
  EXPECT_GT(shape::Untangle(cells, {}, options).InvertedAfter, 0) << "they cannot stay";
  options.FixBoundary = false;
  const shape::UntangleResult result = shape::Untangle(cells, {}, options);
  EXPECT_EQ(result.InvertedAfter, 0);
  EXPECT_EQ(CountNegative(result.Solid), 0);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double before = cells.Points(i, k);
      if (before == 0.0 || before == 1.0)
      {
        EXPECT_NEAR(result.Solid.Points(i, k), before, 1e-12) << "still on its face";
      }
    }
  }
}

TEST(Untangle, RefusesWhatItCannotUse)
{
  shape::Cells cells = shapetest::BuildCube(2, 10);
  EXPECT_REFUSED(shape::Untangle(cells, cells.Points.topRows(3), {}), "the RestShape has 3 points");
  shape::UntangleOptions options;
  options.MaximumIterations = 0;
  EXPECT_REFUSED(shape::Untangle(cells, {}, options), "MaximumIterations is 0");
  shape::Cells twice = cells;
  twice.Corners(1) = twice.Corners(0);
  EXPECT_REFUSED(shape::Untangle(twice, {}, {}), "cell 0 repeats a point");
  twice = cells;
  twice.Kinds(3) = 7;
  EXPECT_REFUSED(shape::Untangle(twice, {}, {}), "cell 3 is no tetrahedron");
  twice = cells;
  twice.Points(4, 1) = std::nan("");
  EXPECT_REFUSED(shape::Untangle(twice, {}, {}), "not finite");
}

} // namespace
