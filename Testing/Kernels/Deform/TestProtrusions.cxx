#include "Deform/Private/Protrusions.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace
{

/// A strip along x with two bumps of height 0.8, of `cells` edges along its length of 2.
shape::Mesh StripWithBumps(int cells, double shake = 0.0)
{
  shape::Mesh strip = shapetest::FlatSquare(cells, shake);
  strip.Points.col(1) *= 0.4;
  for (auto point : strip.Points.rowwise())
  {
    for (const double x : { -0.3, 0.3 })
    {
      const double r = std::hypot(point(0) - x, point(1));
      if (r < 0.25)
      {
        point(2) = 0.8 * std::pow(std::cos(0.5 * M_PI * r / 0.25), 2.0);
      }
    }
  }
  return strip;
}

/// A flat hand in the plane: a palm, y from 0 to 4 and x from 0 to 9, with five fingers of width 1
/// and the given lengths. The wrist is the edge y = 0. Squares of size 1 / cells in two triangles.
shape::Mesh Hand(int cells, const std::vector<int>& lengths)
{
  constexpr int width = 9, palm = 4;
  const auto isIn = [&](int i, int j)
  {
    const int x = i / cells, y = j / cells;
    return y < palm || (x % 2 == 0 && y - palm < lengths[x / 2]);
  };
  const int height = palm + *std::max_element(lengths.begin(), lengths.end());
  shape::Mesh grid{ Eigen::MatrixXd((width * cells + 1) * (height * cells + 1), 3), {} };
  std::vector<Eigen::RowVector3i> triangles;
  const auto number = [&](int i, int j) { return j * (width * cells + 1) + i; };
  for (int j = 0; j <= height * cells; ++j)
  {
    for (int i = 0; i <= width * cells; ++i)
    {
      grid.Points.row(number(i, j)) << static_cast<double>(i) / cells,
        static_cast<double>(j) / cells, 0.0;
      if (i < width * cells && j < height * cells && isIn(i, j))
      {
        triangles.emplace_back(number(i, j), number(i + 1, j), number(i + 1, j + 1));
        triangles.emplace_back(number(i, j), number(i + 1, j + 1), number(i, j + 1));
      }
    }
  }
  shape::Mesh hand;
  std::vector<int> newNumber(grid.Points.rows(), -1), used;
  hand.Triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      int& own = newNumber[triangles[t](k)];
      if (own < 0)
      {
        own = static_cast<int>(used.size());
        used.push_back(triangles[t](k));
      }
      hand.Triangles(static_cast<Eigen::Index>(t), k) = own;
    }
  }
  hand.Points = grid.Points(used, Eigen::all);
  return hand;
}

struct Labelled
{
  Labelled(const shape::Mesh& mesh, const std::vector<int>& sources, double share)
    : Graph(shape::BuildPointGraph(mesh))
    , Sweep(shape::SweepFront(this->Graph, sources))
    , Labels(shape::FindProtrusions(this->Graph, this->Sweep, share * this->Sweep.Arrivals.back()))
  {
  }

  double ArrivalAt(int node) const { return this->Sweep.Arrivals[this->Sweep.Ranks[node]]; }
  int Count() const { return this->Labels.maxCoeff() + 1; }

  shape::PointGraph Graph;
  shape::FrontSweep Sweep;
  Eigen::VectorXi Labels;
};

/// The nodes for which a condition on their position holds.
template <typename Condition>
std::vector<int> NodesWhere(const shape::Mesh& mesh, const Condition& condition)
{
  std::vector<int> nodes;
  for (int i = 0; i < static_cast<int>(mesh.Points.rows()); ++i)
  {
    if (condition(mesh.Points.row(i)))
    {
      nodes.push_back(i);
    }
  }
  return nodes;
}

std::vector<int> BoundaryOfStrip(const shape::Mesh& strip)
{
  return NodesWhere(strip,
    [](const Eigen::RowVector3d& at)
    { return std::abs(at(0)) > 1.0 - 1e-9 || std::abs(at(1)) > 0.4 - 1e-9; });
}

std::vector<int> Wrist(const shape::Mesh& hand)
{
  return NodesWhere(hand, [](const Eigen::RowVector3d& at) { return at(1) == 0.0; });
}

} // namespace

TEST(Protrusions, TwoBumpsOnASheet)
{
  for (const int cells : { 40, 60, 90, 140 })
  {
    const shape::Mesh strip = StripWithBumps(cells);
    const Labelled found(strip, BoundaryOfStrip(strip), 0.1);
    EXPECT_EQ(found.Count(), 3) << cells;
    for (int node = 0; node < found.Labels.size(); ++node)
    {
      const Eigen::RowVector3d at = strip.Points.row(node);
      const int label = found.Labels(node);
      // Bump by bump, and all of the upper half of each.
      if (label > 0)
      {
        EXPECT_LT(std::hypot(std::abs(at(0)) - 0.3, at(1)), 0.3 + 2.0 / cells);
      }
      if (at(2) > 0.4)
      {
        EXPECT_GT(label, 0);
      }
    }
    const auto labelsAt = [&](double sign)
    {
      std::set<int> labels;
      for (const int node : NodesWhere(strip,
             [&](const Eigen::RowVector3d& at) { return at(2) > 0.4 && sign * at(0) > 0.0; }))
      {
        labels.insert(found.Labels(node));
      }
      return labels;
    };
    EXPECT_EQ(labelsAt(1.0).size(), 1U);
    EXPECT_EQ(labelsAt(-1.0).size(), 1U);
    EXPECT_NE(labelsAt(1.0), labelsAt(-1.0));
  }
}

TEST(Protrusions, AHandIsAPalmAndFiveFingers)
{
  for (const int cells : { 2, 4, 7 })
  {
    // The gaps between fingers end at y = 4, and so do the labels, exactly: the front along edges
    // from the wrist arrives at the time y in the palm.
    const shape::Mesh hand = Hand(cells, { 3, 5, 6, 5, 2 });
    const Labelled found(hand, Wrist(hand), 0.1);
    EXPECT_EQ(found.Count(), 6);
    for (int node = 0; node < found.Labels.size(); ++node)
    {
      EXPECT_EQ(found.Labels(node) > 0, hand.Points(node, 1) > 4.0);
    }
    // The longest finger is 1; the shortest is 5.
    for (int finger = 0; finger < 5; ++finger)
    {
      for (const int node : NodesWhere(hand,
             [&](const Eigen::RowVector3d& at)
             { return at(1) > 4.0 && static_cast<int>(at(0) / 2.0 + 1e-9) == finger; }))
      {
        if (finger == 2)
        {
          EXPECT_EQ(found.Labels(node), 1);
        }
        if (finger == 4)
        {
          EXPECT_EQ(found.Labels(node), 5);
        }
      }
    }
  }
}

TEST(Protrusions, TheMinimumDecidesWhatIsOne)
{
  const shape::Mesh hand = Hand(3, { 3, 5, 6, 5, 2 }); // the last arrival time is 10
  const auto count = [&](double share) { return Labelled(hand, Wrist(hand), share).Count(); };
  EXPECT_EQ(count(0.19), 6);
  EXPECT_EQ(count(0.21), 5); // without the finger of length 2
  EXPECT_EQ(count(0.31), 4);
  EXPECT_EQ(count(0.51), 1); // one long finger alone does not join another
  EXPECT_EQ(count(1.0), 1);
}

TEST(Protrusions, AnArmBetweenHandAndShoulderIsASegment)
{
  // Two fingers on a palm that is 4 long, twice: the palm's row of gaps is the only saddle. The
  // part below it reaches the wrist and is the base.
  const shape::Mesh hand = Hand(2, { 3, 0, 3, 0, 0 });
  EXPECT_EQ(Labelled(hand, Wrist(hand), 0.1).Count(), 3);
  // From the tip of one finger, the rest of that finger and the palm are one base, and the other
  // finger is the only protrusion beside the end of the palm.
  const Labelled across(hand,
    NodesWhere(hand, [](const Eigen::RowVector3d& at) { return at(1) == 7.0 && at(0) < 2.0; }),
    0.1);
  EXPECT_EQ(across.Count(), 3);
}

TEST(Protrusions, NoiseBelowTheMinimumAddsNone)
{
  // Heights change by up to 0.02, which changes arrival times by a few hundredths of the last one
  // (1.2 and more).
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    std::mt19937 random(seed);
    shape::Mesh strip = StripWithBumps(60, 0.3);
    for (auto point : strip.Points.rowwise())
    {
      point(2) += 0.02 * static_cast<double>(random()) / 4294967296.0;
    }
    const std::vector<int> boundary = BoundaryOfStrip(strip);
    EXPECT_EQ(Labelled(strip, boundary, 0.1).Count(), 3);
    EXPECT_GT(Labelled(strip, boundary, 0.0).Count(), 3); // each tip is one
  }
}

TEST(Protrusions, ANewNumberingMovesTheLabelsOnly)
{
  const shape::Mesh strip = StripWithBumps(50, 0.3);
  const Labelled own(strip, BoundaryOfStrip(strip), 0.1);
  std::vector<int> order(strip.Points.rows()), number(strip.Points.rows());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  shape::Mesh other{ strip.Points(order, Eigen::all), strip.Triangles };
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number[order[i]] = static_cast<int>(i);
  }
  for (int& corner : other.Triangles.reshaped())
  {
    corner = number[corner];
  }
  const Labelled moved(other, BoundaryOfStrip(other), 0.1);
  EXPECT_EQ(Eigen::VectorXi(moved.Labels(number)), own.Labels);
}

TEST(Protrusions, BumpsDoNotStickTogether)
{
  // The strip is bent. As in TestSegmentHierarchy, each bump ought to lean outwards with the strip
  // below it; the tips are as far apart as with labels made by hand.
  constexpr double radius = 0.8;
  const shape::Mesh strip = StripWithBumps(60);
  const shape::BoundaryHandle loop = shapetest::LoopOf(strip);
  const shape::HandlePose pose = shape::PoseHandle(loop, shapetest::Bent(loop.Positions, radius));
  const shape::PointGraph graph = shape::BuildPointGraph(strip);
  Eigen::VectorXi byHand = Eigen::VectorXi::Zero(strip.Points.rows());
  int tips[2] = { 0, 0 };
  for (int i = 0; i < byHand.size(); ++i)
  {
    const Eigen::RowVector3d at = strip.Points.row(i);
    byHand(i) = at(2) > 0.0 ? (at(0) > 0.0 ? 1 : 2) : 0;
    int& tip = tips[at(0) > 0.0 ? 0 : 1];
    tip = at(2) > strip.Points(tip, 2) ? i : tip;
  }
  shape::DeformOptions options;
  options.Multiresolution = shape::DeformOptions::MultiresolutionType::Off;
  const auto gap = [&](const shape::DeformedShape& shape)
  { return (shape.Points.row(tips[0]) - shape.Points.row(tips[1])).norm(); };
  const double together = gap(shape::ShapeDeformation(graph, loop, options).Deform(pose));
  shape::DeformFields fields;
  fields.Segments = byHand;
  const double apart = gap(shape::ShapeDeformation(graph, loop, options, fields).Deform(pose));
  options.SegmentBy = shape::DeformOptions::SegmentByType::Protrusions;
  const shape::ShapeDeformation automatic(graph, loop, options);
  EXPECT_EQ(automatic.Facts().Segments, 3);
  EXPECT_EQ(automatic.Protrusions().maxCoeff(), 2);
  const double found = gap(automatic.Deform(pose));
  std::cout << "together " << together << " by hand " << apart << " automatic " << found << "\n";
  EXPECT_GT(found, 1.3 * together);
  EXPECT_NEAR(found, apart, 0.1 * apart);
}

TEST(Protrusions, WithoutOneNothingChanges)
{
  const shape::Mesh cap = shapetest::Cap(12);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::HandlePose pose = shape::PoseHandle(loop, shapetest::Bent(loop.Positions, 1.0));
  shape::DeformOptions options;
  options.SegmentBy = shape::DeformOptions::SegmentByType::Protrusions;
  const shape::ShapeDeformation one(graph, loop, options);
  EXPECT_EQ(one.Facts().Segments, 1);
  EXPECT_LT(shapetest::Largest(
              one.Deform(pose).Points - shape::ShapeDeformation(graph, loop).Deform(pose).Points),
    1e-13);
}
