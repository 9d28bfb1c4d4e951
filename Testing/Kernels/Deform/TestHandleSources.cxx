// Facts checked: a handle that is made of a shape's nodes has these as sources, and only the nodes
// within the tolerance of it; a source lies where its shares of the samples say, each node is one
// source at most; a coarse handle has no gaps, and all its sources are linked with the shape; they
// weigh what the handle does: as much as the nodes of a regular border, three times the area of
// triangles; motions and scales change none of that; wrong handles are refused.

#include "Deform/Private/HandleAttachment.h"

#include "Base/Errors.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3d;

/// Rows of triangles with sides of 1, row 0 along the x axis; point i of row j is i + 21 j.
shape::Mesh RegularStrip()
{
  constexpr int columns = 21, rows = 6;
  shape::Mesh strip{ MatrixXd::Zero(columns * rows, 3),
    Eigen::MatrixXi(2 * (columns - 1) * (rows - 1), 3) };
  int t = 0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int here = i + columns * j;
      strip.Points.row(here) << i + 0.5 * j, std::sqrt(0.75) * j, 0.0;
      if (i + 1 < columns && j + 1 < rows)
      {
        strip.Triangles.row(t++) << here, here + 1, here + columns;
        strip.Triangles.row(t++) << here + 1, here + columns + 1, here + columns;
      }
    }
  }
  return strip;
}

MatrixXd Line(const RowVector3d& from, const RowVector3d& to, int samples)
{
  MatrixXd positions(samples, 3);
  for (int i = 0; i < samples; ++i)
  {
    positions.row(i) = from + i * (to - from) / (samples - 1);
  }
  return positions;
}

/// One triangle as a handle.
shape::BoundaryHandle TriangleHandle(
  const RowVector3d& a, const RowVector3d& b, const RowVector3d& c)
{
  shape::BoundaryHandle handle;
  handle.Positions.resize(3, 3);
  handle.Positions << a, b, c;
  handle.Triangles = Eigen::RowVector3i(0, 1, 2);
  return handle;
}

std::set<int> NodesOf(const shape::HandleSources& sources)
{
  return { sources.Nodes.begin(), sources.Nodes.end() };
}

double WeightOf(const shape::HandleSources& sources)
{
  return sources.Graph.Weights(sources.Nodes).sum();
}

/// What holds of any sources: the shape's nodes first, each source once, where its shares say.
void ExpectSound(const shape::PointGraph& shape, const shape::BoundaryHandle& handle,
  const shape::HandleSources& sources)
{
  EXPECT_EQ(sources.Graph.Positions.topRows(shape.Size()), shape.Positions);
  EXPECT_EQ(NodesOf(sources).size(), sources.Nodes.size());
  ASSERT_EQ(sources.Samples.rows(), static_cast<Eigen::Index>(sources.Nodes.size()));
  EXPECT_GE(sources.Shares.minCoeff(), 0.0);
  EXPECT_LT((sources.Shares.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-14);
  const double size = std::max(
    shape::ComputeBoxDiagonal(shape.Positions), shape::ComputeBoxDiagonal(handle.Positions));
  std::set<std::pair<int, int>> toShape;
  for (const auto& [a, b] : shape::ListLinks(sources.Graph))
  {
    if (a < shape.Size())
    {
      toShape.insert({ b, a });
    }
  }
  for (Eigen::Index k = 0; k < sources.Samples.rows(); ++k)
  {
    RowVector3d position = RowVector3d::Zero();
    for (int c = 0; c < 3; ++c)
    {
      position += sources.Shares(k, c) * handle.Positions.row(sources.Samples(k, c));
    }
    const int node = sources.Nodes[k];
    EXPECT_LE((sources.Graph.Positions.row(node) - position).norm(), 1.01e-6 * size);
    if (node >= shape.Size()) // linked with the nearest node of the shape
    {
      Eigen::Index nearest = 0;
      (shape.Positions.rowwise() - position).rowwise().norm().minCoeff(&nearest);
      EXPECT_EQ(toShape.count({ node, static_cast<int>(nearest) }), 1U);
    }
  }
  std::vector<std::pair<int, int>> links = shape::ListLinks(shape), all;
  all = shape::ListLinks(sources.Graph);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), links.begin(), links.end()));
}

TEST(HandleSources, ABorderOfTheShapeIsItsNodes)
{
  const shape::PointGraph shape = shape::BuildPointGraph(RegularStrip());
  for (const int step : { 1, 4, 20 }) // every node, some, the ends: the rest lies on the segments
  {
    const shape::BoundaryHandle handle =
      shape::BuildCurveHandle(shape.Positions(Eigen::seq(0, 20, step), Eigen::all), false);
    const shape::HandleSources sources = shape::AttachHandle(shape, handle);
    ExpectSound(shape, handle, sources);
    std::vector<int> nodes(sources.Nodes), row(21);
    std::sort(nodes.begin(), nodes.end());
    std::iota(row.begin(), row.end(), 0);
    EXPECT_EQ(nodes, row);
    EXPECT_EQ(sources.Graph.Neighbours, shape.Neighbours);
    // The handle weighs what the shape does there.
    for (int i = 1; i < 20; ++i)
    {
      EXPECT_NEAR(sources.Graph.Weights(i), shape.Weights(i), 2e-3 * shape.Weights(i));
    }
    EXPECT_EQ(sources.Graph.Weights.tail(105), shape.Weights.tail(105));
  }
  // A place that the curve comes back to is one source, on the shape and above it.
  for (const double height : { 0.0, 1.0 })
  {
    MatrixXd positions(5, 3);
    positions << shape.Positions.row(0), shape.Positions.row(1), shape.Positions.row(21),
      shape.Positions.row(1), shape.Positions.row(0);
    positions.col(2).array() += height;
    const shape::BoundaryHandle handle = shape::BuildCurveHandle(positions, false);
    const shape::HandleSources sources = shape::AttachHandle(shape, handle);
    ExpectSound(shape, handle, sources);
    EXPECT_EQ(sources.Nodes.size(), 3U);
  }
}

TEST(HandleSources, ACoarseCurveHasNoGapsAndAWeightByItsLength)
{
  const shape::PointGraph shape = shape::BuildPointGraph(RegularStrip());
  const RowVector3d from(3.2, 1.1, 0.4), to(17.9, 3.3, 0.4);
  double weight = 0.0;
  for (const int samples : { 2, 3, 8, 50 })
  {
    const shape::BoundaryHandle handle = shape::BuildCurveHandle(Line(from, to, samples), false);
    const shape::HandleSources sources = shape::AttachHandle(shape, handle);
    ExpectSound(shape, handle, sources);
    std::vector<std::pair<double, int>> along;
    for (const int node : sources.Nodes)
    {
      EXPECT_GE(node, shape.Size()); // above the shape
      along.emplace_back((sources.Graph.Positions.row(node) - from).norm(), node);
    }
    std::sort(along.begin(), along.end());
    EXPECT_EQ(along.front().first, 0.0);
    EXPECT_NEAR(along.back().first, (to - from).norm(), 1e-12);
    const std::vector<std::pair<int, int>> links = shape::ListLinks(sources.Graph);
    for (std::size_t i = 1; i < along.size(); ++i)
    {
      EXPECT_LE(along[i].first - along[i - 1].first, 1.5 * shape.MeanLength);
      const std::pair<int, int> link = std::minmax(along[i].second, along[i - 1].second);
      EXPECT_TRUE(std::binary_search(links.begin(), links.end(), link));
    }
    weight = weight > 0.0 ? weight : WeightOf(sources);
    EXPECT_NEAR(WeightOf(sources), weight, 1e-12 * weight);
  }
  const shape::BoundaryHandle half =
    shape::BuildCurveHandle(Line(from, (from + to) / 2.0, 2), false);
  EXPECT_NEAR(WeightOf(shape::AttachHandle(shape, half)), weight / 2.0, 1e-12 * weight);
}

TEST(HandleSources, ATriangleHasTheNodesInItAndNoGapsElsewhere)
{
  const shape::PointGraph shape = shape::BuildPointGraph(RegularStrip());
  const RowVector3d a(4.1, 0.3, 0.0), u(9.0, 0.4, 0.0), v(4.2, 3.1, 0.0);
  const shape::BoundaryHandle handle = TriangleHandle(a, a + u, a + v);
  const shape::HandleSources sources = shape::AttachHandle(shape, handle);
  ExpectSound(shape, handle, sources);
  std::set<int> within;
  for (int i = 0; i < shape.Size(); ++i)
  {
    const RowVector3d w = shape.Positions.row(i) - a;
    const double s = w.cross(v).z() / u.cross(v).z(), t = u.cross(w).z() / u.cross(v).z();
    if (s > 0.0 && t > 0.0 && s + t < 1.0)
    {
      within.insert(i);
    }
  }
  EXPECT_GT(within.size(), 8U);
  std::set<int> own = NodesOf(sources);
  own.erase(own.lower_bound(shape.Size()), own.end());
  EXPECT_EQ(own, within);
  // Above the shape it has none of these, and others near each of their places.
  const RowVector3d up(0, 0, 2);
  const shape::BoundaryHandle above = TriangleHandle(a + up, a + u + up, a + v + up);
  const shape::HandleSources filled = shape::AttachHandle(shape, above);
  ExpectSound(shape, above, filled);
  EXPECT_GE(*std::min_element(filled.Nodes.begin(), filled.Nodes.end()), shape.Size());
  const MatrixXd positions = filled.Graph.Positions(filled.Nodes, Eigen::all);
  for (const int node : within)
  {
    const RowVector3d position = shape.Positions.row(node) + up;
    EXPECT_LT((positions.rowwise() - position).rowwise().norm().minCoeff(), shape.MeanLength);
  }
}

TEST(HandleSources, AFineSurfaceWeighsThreeTimesItsArea)
{
  // As the shape's nodes do; with twice as many triangles no more.
  const shape::PointGraph shape = shape::BuildPointGraph(RegularStrip());
  const RowVector3d shift(9.0, 2.2, 0.7);
  for (const int cells : { 6, 12 })
  {
    const shape::Mesh square = shapetest::FlatSquare(cells, 0.2);
    shape::BoundaryHandle handle;
    handle.Positions = (2.0 * square.Points).rowwise() + shift;
    handle.Triangles = square.Triangles;
    const shape::HandleSources sources = shape::AttachHandle(shape, handle);
    ExpectSound(shape, handle, sources);
    EXPECT_EQ(static_cast<Eigen::Index>(sources.Nodes.size()), handle.Positions.rows());
    EXPECT_NEAR(WeightOf(sources), 3.0 * 16.0, 1e-12);
    const Eigen::VectorXd areas = shape::ComputePointAreas({ handle.Positions, handle.Triangles });
    EXPECT_LT((sources.Graph.Weights(sources.Nodes) - 3.0 * areas).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(HandleSources, OnlyNodesWithinTheToleranceAreOnTheHandle)
{
  const shape::Mesh strip = RegularStrip();
  const shape::PointGraph shape = shape::BuildPointGraph(strip);
  const double tolerance = 1e-6 * shape::ComputeBoxDiagonal(strip.Points);
  for (const double share : { 0.9, 1.1 })
  {
    const RowVector3d off(0, 0, share * tolerance);
    const shape::BoundaryHandle ends =
      shape::BuildCurveHandle(Line(strip.Points.row(0) + off, strip.Points.row(5) + off, 2), false);
    const shape::BoundaryHandle face = TriangleHandle(
      strip.Points.row(0) + off, strip.Points.row(5) + off, strip.Points.row(105) + off);
    for (const shape::BoundaryHandle& handle : { ends, face })
    {
      const std::vector<int> nodes = shape::AttachHandle(shape, handle).Nodes;
      const auto isNew = [&](int node) { return node >= shape.Size(); };
      EXPECT_EQ(std::all_of(nodes.begin(), nodes.end(), isNew), share > 1.0);
      EXPECT_EQ(std::none_of(nodes.begin(), nodes.end(), isNew), share < 1.0);
    }
  }
  // Two samples at one node are one source.
  MatrixXd positions = strip.Points.topRows(2).replicate(2, 1);
  positions.row(2).z() += 0.5 * tolerance;
  EXPECT_EQ(shape::AttachHandle(shape, shape::BuildCurveHandle(positions, false)).Nodes,
    std::vector<int>({ 0, 1 }));
}

TEST(HandleSources, FollowsMotionsAndScales)
{
  const shape::Mesh cap = shapetest::Cap(8);
  shape::BoundaryHandle handle = shapetest::LoopOf(cap);
  handle.Positions.row(0) *= 1.3; // one sample off the shape
  handle.Triangles = Eigen::RowVector3i(3, 15, 30);
  const shape::HandleSources here = shape::AttachHandle(shape::BuildPointGraph(cap), handle);
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const RowVector3d shift(3, -7, 2);
  for (const double scale : { 1.0, 1e-3, 1e4 })
  {
    const shape::Mesh moved{ shapetest::Moved(cap.Points, turn, scale, scale * shift),
      cap.Triangles };
    shape::BoundaryHandle other = handle;
    other.Positions = shapetest::Moved(handle.Positions, turn, scale, scale * shift);
    const shape::HandleSources there = shape::AttachHandle(shape::BuildPointGraph(moved), other);
    EXPECT_EQ(there.Nodes, here.Nodes);
    EXPECT_EQ(there.Samples, here.Samples);
    EXPECT_EQ(there.Graph.Neighbours, here.Graph.Neighbours);
    EXPECT_LT((there.Shares - here.Shares).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(
      (there.Graph.Weights / (scale * scale) - here.Graph.Weights).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(HandleSources, RefusesWrongHandles)
{
  const shape::PointGraph shape = shape::BuildPointGraph(RegularStrip());
  const auto refuses = [&](const shape::BoundaryHandle& handle)
  { EXPECT_THROW(shape::AttachHandle(shape, handle), shape::InvalidInput); };
  shape::BoundaryHandle none;
  none.Positions.resize(0, 3);
  refuses(none);
  const shape::BoundaryHandle sound = TriangleHandle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 });
  for (const int point : { -1, 3 })
  {
    shape::BoundaryHandle wrong = sound;
    wrong.Triangles(0, 1) = point;
    refuses(wrong);
    wrong = sound;
    wrong.Segments = Eigen::RowVector2i(0, point);
    refuses(wrong);
  }
  shape::BoundaryHandle wrong = sound;
  wrong.Positions(1, 2) = std::numeric_limits<double>::quiet_NaN();
  refuses(wrong);
  EXPECT_THROW(shape::AttachHandle(shape, sound, shape::Progress([](double) { return false; })),
    shape::Aborted);
}

} // namespace
