// Facts checked: rows sum to 1, also of means of means; identity leaves everything; composition is
// associative, and data carried by a composed provenance are those carried in two steps; two
// provenances of one joined mesh sum to 1 together; a row has no entry of weight 0.

#include "Mesh/Provenance.h"

#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{

Eigen::VectorXd RowSums(const shape::Provenance& provenance)
{
  return provenance.Weights * Eigen::VectorXd::Ones(provenance.Weights.cols());
}

/// Copies, points on triangles, points at nearest ones and means of all of these, in random order.
shape::Provenance SomeProvenance(int oldPoints, int newPoints, int oldCells, int newCells, int seed)
{
  std::mt19937 random(seed);
  const auto below = [&](int count) { return static_cast<int>(random() % count); };
  const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  shape::ProvenanceWriter writer(oldPoints);
  for (int i = 0; i < newPoints; ++i)
  {
    const int kind = i < 2 ? 0 : below(4);
    if (kind == 0)
    {
      writer.AddCopy(below(oldPoints));
    }
    else if (kind == 1)
    {
      writer.AddNearest(below(oldPoints));
    }
    else if (kind == 2)
    {
      const int first = below(oldPoints - 2);
      const double a = share(), b = (1.0 - a) * share();
      writer.AddOnTriangle({ first + 2, first, first + 1 }, { a, b, 1.0 - a - b });
    }
    else
    {
      writer.AddMean({ below(i), below(i), below(i) });
    }
  }
  Eigen::VectorXi cells(newCells);
  std::generate(cells.begin(), cells.end(), [&] { return below(oldCells + 1) - 1; });
  return writer.Finish(cells);
}

} // namespace

TEST(Provenance, RowsSumToOne)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const shape::Provenance provenance = SomeProvenance(30, 200, 10, 10, seed);
    EXPECT_LT((RowSums(provenance).array() - 1.0).abs().maxCoeff(), 1e-14);
    EXPECT_GT(provenance.Weights.coeffs().minCoeff(), 0.0);
    for (Eigen::Index i = 0; i < provenance.Points.size(); ++i)
    {
      if (provenance.Points(i) >= 0)
      {
        EXPECT_EQ(provenance.Weights.row(i).nonZeros(), 1);
        EXPECT_EQ(provenance.Weights.coeff(i, provenance.Points(i)), 1.0);
      }
    }
  }
}

TEST(Provenance, CarriesInTwoStepsAsComposed)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const shape::Provenance first = SomeProvenance(20, 50, 30, 40, seed);
    const shape::Provenance second = SomeProvenance(50, 70, 40, 60, seed + 100);
    const shape::Provenance third = SomeProvenance(70, 90, 60, 80, seed + 200);
    const shape::Provenance both = shape::Compose(first, second);
    const Eigen::MatrixXd values = Eigen::MatrixXd::Random(20, 3);
    const Eigen::MatrixXd between = first.Weights * values;
    EXPECT_LT((both.Weights * values - second.Weights * between).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((RowSums(both).array() - 1.0).abs().maxCoeff(), 1e-14);
    for (Eigen::Index i = 0; i < second.Points.size(); ++i)
    {
      EXPECT_EQ(both.Points(i), second.Points(i) < 0 ? -1 : first.Points(second.Points(i)));
    }
    for (Eigen::Index i = 0; i < second.Cells.size(); ++i)
    {
      EXPECT_EQ(both.Cells(i), second.Cells(i) < 0 ? -1 : first.Cells(second.Cells(i)));
    }

    const shape::Provenance left = shape::Compose(both, third);
    const shape::Provenance right = shape::Compose(first, shape::Compose(second, third));
    EXPECT_LT((left.Weights - right.Weights).norm(), 1e-14);
    EXPECT_EQ(left.Points, right.Points);
    EXPECT_EQ(left.Cells, right.Cells);

    for (const shape::Provenance& same : { shape::Compose(shape::TraceIdentity(20, 30), first),
           shape::Compose(first, shape::TraceIdentity(50, 40)) })
    {
      EXPECT_EQ((same.Weights - first.Weights).norm(), 0.0);
      EXPECT_EQ(same.Points, first.Points);
      EXPECT_EQ(same.Cells, first.Cells);
    }
  }
}

TEST(Provenance, PointsWithoutASourceHaveEmptyRows)
{
  // Two meshes joined: a copy of each, and the midpoint between the two.
  shape::ProvenanceWriter ofOne(4), ofOther(7);
  ofOne.AddCopy(2);
  ofOther.AddNone(1);
  ofOne.AddNone(1);
  ofOther.AddCopy(5);
  ofOne.AddMean({ 0, 1 });
  ofOther.AddMean({ 0, 1 });
  const shape::Provenance one = ofOne.Finish({}), other = ofOther.Finish({});
  EXPECT_EQ(RowSums(one), Eigen::Vector3d(1.0, 0.0, 0.5));
  EXPECT_EQ(RowSums(other), Eigen::Vector3d(0.0, 1.0, 0.5));
  EXPECT_EQ(one.Points, Eigen::Vector3i(2, -1, -1));
  EXPECT_EQ(other.Points, Eigen::Vector3i(-1, 5, -1));
  // A corner that has no weight is not a source.
  shape::ProvenanceWriter onEdge(3);
  onEdge.AddOnTriangle({ 2, 0, 1 }, { 0.25, 0.0, 0.75 });
  const shape::Provenance edge = onEdge.Finish({});
  EXPECT_EQ(edge.Weights.nonZeros(), 2);
  EXPECT_EQ(edge.Weights.coeff(0, 1), 0.75);
  EXPECT_EQ(edge.Weights.coeff(0, 2), 0.25);
}

TEST(Provenance, OfASurfaceThatIsCutOpen)
{
  // A fan of four triangles around point 0, cut along two edges that meet there.
  shape::Mesh fan{ Eigen::MatrixXd(5, 3), Eigen::MatrixXi(4, 3) };
  fan.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0;
  fan.Triangles << 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1;
  const shape::CutSurface cut = shape::CutAlongEdges(fan, { { 0, 1 }, { 3, 0 } });
  ASSERT_EQ(cut.Surface.Points.rows(), 8); // the ends of the cut are on the boundary
  EXPECT_EQ(cut.Provenance.Points.head(5), Eigen::VectorXi::LinSpaced(5, 0, 4));
  Eigen::VectorXi copies = cut.Provenance.Points.tail(3);
  std::sort(copies.begin(), copies.end());
  EXPECT_EQ(copies, Eigen::Vector3i(0, 1, 3));
  EXPECT_EQ(Eigen::MatrixXd(cut.Provenance.Weights * fan.Points), cut.Surface.Points);
  EXPECT_EQ(cut.Provenance.Cells, Eigen::VectorXi::LinSpaced(4, 0, 3));
}
