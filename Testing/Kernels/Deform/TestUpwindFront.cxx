#include "Base/Errors.h"
#include "Deform/UpwindFront.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// A graph, its sweep from the sources and the front with one power.
struct Swept
{
  Swept(const shape::Mesh& mesh, const std::vector<int>& sources, double power = 2.0,
    const shape::UpwindFrontOptions& options = {})
    : Graph(shape::BuildPointGraph(mesh))
    , Sweep(shape::SweepFront(this->Graph, sources))
    , Front(this->Graph, this->Sweep, Eigen::VectorXd::Constant(this->Graph.Size(), power), options)
  {
  }
  Swept(const Swept&) = delete;

  std::vector<float> Row(int rank) const
  {
    std::vector<float> row(this->Front.End(rank) - this->Front.Begin(rank));
    EXPECT_TRUE(this->Front.Row(rank, row.data()));
    return row;
  }

  shape::PointGraph Graph;
  shape::FrontSweep Sweep;
  shape::UpwindFront Front;
};

/// The points of a square on its side x = -1.
std::vector<int> LeftSide(const shape::Mesh& square)
{
  std::vector<int> side;
  for (int i = 0; i < square.Points.rows(); ++i)
  {
    if (square.Points(i, 0) < -1.0 + 1e-9)
    {
      side.push_back(i);
    }
  }
  return side;
}

} // namespace

TEST(UpwindFront, ArrivalsAreDistancesAlongStraightRows)
{
  const shape::Mesh square = shapetest::FlatSquare(20, 0.0);
  const Swept swept(square, LeftSide(square));
  for (int rank = 0; rank < swept.Graph.Size(); ++rank)
  {
    const int node = swept.Sweep.Nodes[rank];
    EXPECT_EQ(swept.Sweep.Ranks[node], rank);
    EXPECT_NEAR(swept.Sweep.Arrivals[rank], square.Points(node, 0) + 1.0, 1e-12);
    if (rank > 0)
    {
      EXPECT_LE(swept.Sweep.Arrivals[rank - 1], swept.Sweep.Arrivals[rank]);
    }
    const int parent = swept.Sweep.Parents[rank];
    EXPECT_EQ(parent < 0, rank < swept.Sweep.Sources);
    if (parent >= 0)
    {
      EXPECT_NEAR(
        swept.Sweep.Arrivals[parent] + swept.Sweep.Steps[rank], swept.Sweep.Arrivals[rank], 1e-15);
    }
  }
}

TEST(UpwindFront, BandsAndWeightsAreThoseOfTheEquations)
{
  const shape::Mesh square = shapetest::FlatSquare(12, 0.3);
  for (const double power : { 0.0, 2.0, 5.0 })
  {
    const Swept swept(square, LeftSide(square), power);
    const double radius = 2.1 * swept.Graph.MeanLength;
    const auto fall = [](double x, double r)
    { return std::pow(std::max(1.0 - x * x / (r * r), 0.0), 3.0); };
    for (int rank = swept.Sweep.Sources; rank < swept.Graph.Size(); rank += 7)
    {
      const int node = swept.Sweep.Nodes[rank];
      const double wide = std::max(radius, 1.25 * swept.Sweep.Steps[rank]);
      double nearest = 1e9;
      for (int k = swept.Graph.First[node]; k < swept.Graph.First[node + 1]; ++k)
      {
        nearest = std::min(nearest, swept.Graph.Lengths[k]);
      }
      const std::vector<float> row = swept.Row(rank);
      std::vector<double> wanted(swept.Graph.Size(), 0.0);
      for (int j = 0; j < swept.Graph.Size(); ++j)
      {
        const double before = swept.Sweep.Arrivals[rank] - swept.Sweep.Arrivals[j];
        const bool inBand = before > 0.0 && before < wide;
        EXPECT_EQ(inBand, j >= swept.Front.Begin(rank) && j < swept.Front.End(rank));
        if (inBand)
        {
          const double d =
            (square.Points.row(node) - square.Points.row(swept.Sweep.Nodes[j])).norm();
          wanted[j] = fall(before, wide) * (1.0 - fall(before, nearest)) *
            swept.Graph.Weights(swept.Sweep.Nodes[j]) / std::pow(d, power);
        }
      }
      const double largest = *std::max_element(wanted.begin(), wanted.end());
      for (int j = swept.Front.Begin(rank); j < swept.Front.End(rank); ++j)
      {
        EXPECT_NEAR(row[j - swept.Front.Begin(rank)], wanted[j] / largest, 1e-4);
      }
    }
  }
}

TEST(UpwindFront, PointsThatArriveTogetherDoNotCount)
{
  // A row of a regular grid whose arrivals differ by rounding, or by a thousandth of an edge: the
  // neighbours in the row, which are the nearest points, have hardly any weight.
  shape::Mesh square = shapetest::FlatSquare(20, 0.0);
  for (int i = 0; i < square.Points.rows(); ++i)
  {
    square.Points(i, 0) += 1e-4 * std::sin(37.0 * i); // edges are 0.1
  }
  std::vector<int> side;
  for (int i = 0; i < square.Points.rows(); ++i)
  {
    if (square.Points(i, 0) < -0.99)
    {
      side.push_back(i);
    }
  }
  const Swept swept(square, side);
  for (int rank = swept.Sweep.Sources; rank < swept.Graph.Size(); ++rank)
  {
    const std::vector<float> row = swept.Row(rank);
    double together = 0.0, all = 0.0;
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      const int j = swept.Front.Begin(rank) + static_cast<int>(k);
      all += row[k];
      together += swept.Sweep.Arrivals[rank] - swept.Sweep.Arrivals[j] < 0.03 ? row[k] : 0.0F;
    }
    EXPECT_LT(together, 1e-3 * all);
  }
}

TEST(UpwindFront, LongEdgesHaveBandsAllTheSame)
{
  // A square stretched twenty times beyond x = 0: edges there are longer than the radius.
  shape::Mesh square = shapetest::FlatSquare(10, 0.0);
  for (auto row : square.Points.rowwise())
  {
    row(0) = row(0) > 0.0 ? 20.0 * row(0) : row(0);
    row(1) *= 0.1;
  }
  const Swept swept(square, LeftSide(square), 2.0, { 0.5, shape::FrontDistance::Euclidean });
  EXPECT_GT(swept.Front.EmptyBands(), 40);
  for (int rank = swept.Sweep.Sources; rank < swept.Graph.Size(); ++rank)
  {
    EXPECT_LT(swept.Front.Begin(rank), swept.Front.End(rank));
    EXPECT_LE(swept.Front.Begin(rank), swept.Sweep.Parents[rank]);
    EXPECT_GT(swept.Front.End(rank), swept.Sweep.Parents[rank]);
    swept.Row(rank);
  }
}

TEST(UpwindFront, GeodesicBandsDoNotJumpGaps)
{
  // Two strips side by side, joined at their left ends: what arrives at the same time on the other
  // one counts by straight distance, but no link of the band leads there.
  const int cells = 40;
  shape::Mesh mesh = shapetest::FlatSquare(cells, 0.0);
  std::vector<int> kept;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d centre = shape::GetCorners(mesh, t).colwise().mean();
    if (centre(0) < -0.9 || std::abs(centre(1)) > 0.05)
    {
      kept.push_back(t);
    }
  }
  mesh.Triangles = Eigen::MatrixXi(mesh.Triangles(kept, Eigen::all));
  const std::vector<int> side = LeftSide(mesh);
  shape::PointGraph graph = shape::BuildPointGraph(mesh, { 2 });
  const shape::FrontSweep sweep = shape::SweepFront(graph, side);
  const Eigen::VectorXd powers = Eigen::VectorXd::Constant(graph.Size(), 2.0);
  for (const auto distance : { shape::FrontDistance::Euclidean, shape::FrontDistance::Geodesic })
  {
    const shape::UpwindFront front(graph, sweep, powers, { 2.1, distance });
    double across = 0.0;
    for (int rank = sweep.Sources; rank < graph.Size(); ++rank)
    {
      if (graph.Positions(sweep.Nodes[rank], 0) > -0.5)
      {
        std::vector<float> row(front.End(rank) - front.Begin(rank));
        EXPECT_TRUE(front.Row(rank, row.data()));
        for (int j = front.Begin(rank); j < front.End(rank); ++j)
        {
          const bool other =
            graph.Positions(sweep.Nodes[rank], 1) * graph.Positions(sweep.Nodes[j], 1) < 0.0;
          across += other ? row[j - front.Begin(rank)] : 0.0F;
        }
      }
    }
    EXPECT_EQ(across > 0.0, distance == shape::FrontDistance::Euclidean);
  }
}

TEST(UpwindFront, ADisconnectedGraphIsRefused)
{
  const shape::Mesh mesh = shapetest::Twice(shapetest::Icosphere(0));
  EXPECT_THROW(shape::SweepFront(shape::BuildPointGraph(mesh), { 0 }), shape::InvalidInput);
}
