#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Quality/MapQuality.h"
#include "Support/Refusals.h"
#include "Untangle/Private/TutteEmbedding.h"
#include "Untangle/Untangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <map>
#include <random>
#include <string>

namespace
{

/// A cube [0, 1]^3 of n^3 cells: hexahedra, or six tetrahedra, two wedges or six pyramids each.
shape::Cells Cube(int n, int kind)
{
  std::vector<Eigen::RowVector3d> points;
  std::vector<std::vector<int>> cells;
  const auto at = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        points.push_back(Eigen::RowVector3d(i, j, k) / n);
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int h[8] = { at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) };
        if (kind == 12)
        {
          cells.emplace_back(h, h + 8);
        }
        else if (kind == 13)
        {
          cells.push_back({ h[0], h[1], h[2], h[4], h[5], h[6] });
          cells.push_back({ h[0], h[2], h[3], h[4], h[6], h[7] });
        }
        else if (kind == 10)
        {
          const int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
          for (int t = 0; t < 6; ++t)
          {
            cells.push_back({ h[0], h[around[t]], h[around[t + 1]], h[6] });
          }
        }
        else
        {
          const int faces[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 3, 2, 6, 7 },
            { 0, 3, 7, 4 }, { 1, 5, 6, 2 } };
          points.push_back((points[h[0]] + points[h[6]]) / 2.0);
          for (const auto& f : faces)
          {
            cells.push_back(
              { h[f[0]], h[f[1]], h[f[2]], h[f[3]], static_cast<int>(points.size()) - 1 });
          }
        }
      }
    }
  }
  const int count = static_cast<int>(cells.size()), corners = static_cast<int>(cells[0].size());
  shape::Cells solid{ Eigen::MatrixXd(points.size(), 3), Eigen::VectorXi::Constant(count, kind),
    Eigen::VectorXi(count + 1), Eigen::VectorXi(count * corners) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    solid.Points.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  for (int c = 0; c <= count; ++c)
  {
    solid.Offsets(c) = corners * c;
    for (int k = 0; k < corners && c < count; ++k)
    {
      solid.Corners(corners * c + k) = cells[c][k];
    }
  }
  return solid;
}

bool Inside(const Eigen::RowVector3d& p)
{
  return p.minCoeff() > 1e-9 && p.maxCoeff() < 1.0 - 1e-9;
}

/// Inner points moved anywhere within `reach`.
Eigen::MatrixXd Shaken(Eigen::MatrixXd points, double reach, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (Inside(points.row(i)))
    {
      points.row(i) += Eigen::RowVector3d(uniform(random), uniform(random), uniform(random));
    }
  }
  return points;
}

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
    const auto* c = solid.Corners.data() + solid.Offsets(cell);
    count += shape::EvaluateOrientation(solid.Points.row(c[0]), solid.Points.row(c[1]),
               solid.Points.row(c[2]), solid.Points.row(c[3])) <= 0;
  }
  return count;
}

TEST(MeanPositions, PointsInsideAreTheMeansOfTheirNeighbours)
{
  shape::Cells cells = Cube(4, 12);
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
    shape::Cells cells = Cube(5, kind);
    const Eigen::MatrixXd rest = cells.Points;
    cells.Points = Shaken(rest, 0.5, 7);
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
        if (!Inside(rest.row(i)))
        {
          EXPECT_EQ(result.Solid.Points.row(i), cells.Points.row(i)) << "the boundary stays";
        }
      }
    }
  }
}

TEST(Untangle, LeavesWhatIsNotInvertedToTheBit)
{
  shape::Cells cells = Cube(4, 10);
  cells.Points = Shaken(cells.Points, 0.03, 1);
  ASSERT_EQ(CountNegative(cells), 0);
  const shape::UntangleResult whole = shape::Untangle(cells);
  EXPECT_EQ(whole.Solid.Points, cells.Points);
  EXPECT_EQ(whole.Iterations, 0);
  // One point across its neighbours: only what is near it moves.
  cells = Cube(8, 10);
  const Eigen::Index middle = (4 * 9 + 4) * 9 + 4;
  cells.Points.row(middle) += Eigen::RowVector3d(0.3, 0.01, 0.02);
  const shape::UntangleResult result = shape::Untangle(cells);
  EXPECT_GT(result.InvertedBefore, 0);
  EXPECT_EQ(result.InvertedAfter, 0);
  EXPECT_LE(result.MovedPoints, 27);
}

TEST(Untangle, IsTheSameInEveryScaleAndPlace)
{
  shape::Cells cells = Cube(5, 10);
  const Eigen::MatrixXd rest = cells.Points;
  cells.Points = Shaken(rest, 0.4, 11);
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
  shape::Cells cells = Cube(5, 10);
  const Eigen::MatrixXd rest = cells.Points;
  cells.Points = Shaken(rest, 0.6, 3);
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
  shape::Cells cells = Cube(3, 12);
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
  shape::Cells cells = Cube(6, 10);
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
  shape::Cells cells = Cube(4, 10);
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

TEST(Untangle, RefinementRecoversARigidMotionFromItsBoundary)
{
  using Refine = shape::RefineType;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  for (const int kind : { 10, 12, 13, 14 })
  {
    shape::Cells cells = Cube(4, kind);
    const Eigen::MatrixXd rest = cells.Points, truth = rest * turn.transpose();
    cells.Points = Shaken(rest, 0.3, 5) * turn.transpose();
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

TEST(Untangle, RefinementLowersTheMeasureOfMapQuality)
{
  using Refine = shape::RefineType;
  using Measure = shape::MapMeasure;
  for (const int kind : { 10, 12 })
  {
    // The boundary is sheared and bent, so that no inner points give an isometry.
    shape::Cells cells = Cube(5, kind);
    const Eigen::MatrixXd rest = cells.Points;
    cells.Points = Shaken(rest, 0.3, 3);
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
        ASSERT_TRUE(Inside(rest.row(point)));
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

TEST(Untangle, RefinementSlidesBoundaryPointsIfTheyAreNotFixed)
{
  // Points of the faces are shaken in their planes; regular hexahedra are recovered only if these
  // points slide.
  shape::Cells cells = Cube(4, 12);
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

TEST(Untangle, RefinementLeavesThePointsOfInvertedCells)
{
  // A corner of the cube is pushed through to the other side, so its cells stay inverted.
  shape::Cells cells = Cube(4, 12);
  cells.Points = Shaken(cells.Points, 0.05, 2);
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

TEST(Untangle, RefusesWhatItCannotUse)
{
  shape::Cells cells = Cube(2, 10);
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
