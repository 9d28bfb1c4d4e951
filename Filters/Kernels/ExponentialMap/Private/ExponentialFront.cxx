#include "ExponentialMap/Private/ExponentialFront.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace shape
{

using Eigen::Vector2d;
using Eigen::Vector3d;

ExponentialFront::ExponentialFront(const PointGraph& graph, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& normals, bool upwindAverage)
  : UpwindAverage(upwindAverage)
  , Fans(triangles, graph.Size())
  , Samples(graph.Size())
  , Marks(graph.Size(), -1)
  , FirstNeighbour(1, 0)
  , Upwind(this->Fans.Largest + 1)
{
  for (int i = 0; i < graph.Size(); ++i)
  {
    this->Samples[i].Position = graph.Positions.row(i).transpose();
    this->Samples[i].Normal = normals.row(i).transpose();
    for (int k = this->Fans.First[i]; k < this->Fans.First[i + 1]; ++k)
    {
      const auto own = this->Neighbours.begin() + this->FirstNeighbour.back();
      const int other = this->Fans.Triangles[k].Next;
      if (std::find(own, this->Neighbours.end(), other) == this->Neighbours.end())
      {
        this->Neighbours.push_back(other);
      }
    }
    this->FirstNeighbour.push_back(static_cast<int>(this->Neighbours.size()));
  }
}

/// Equation 10 of Schmidt and Singh, with transported axes: the edge is projected to the tangent
/// plane at `from` and given its full length, and the x axis follows the minimum rotation between
/// normals.
EIGEN_ALWAYS_INLINE ExponentialFront::Prediction ExponentialFront::Predict(
  const Sample& from, const Sample& to)
{
  constexpr double opposite = 1e-6; // between opposite normals the smallest rotation is undefined
  const Vector3d edge = to.Position - from.Position;
  const Vector2d flat = from.Axes * edge;
  const double length2 = edge.squaredNorm(), flat2 = flat.squaredNorm();
  const double scale = flat2 > 0.0 ? std::sqrt(length2 / flat2) : 0.0;
  const Vector3d x = from.Axes.row(0).transpose();
  // Rodrigues' formula for a vector orthogonal to `from.Normal`, without sines and cosines.
  const double turn = x.dot(to.Normal) / std::max(opposite, 1.0 + from.Normal.dot(to.Normal));
  Prediction prediction;
  prediction.Step = scale * flat;
  prediction.Image = from.Image + prediction.Step;
  prediction.XAxis = x - turn * (from.Normal + to.Normal);
  prediction.Length2 = length2;
  return prediction;
}

/// Returns the squared distance of the apex from the source of the distances at an edge's ends,
/// along the straight line in the unfolded triangle. It is infinite if the line does not cross the
/// edge. nearFirst: whether it crosses the half of `first`.
/// The two known distances place the source in the plane of the edge, on the side opposite to the
/// apex. The distance is then that between two points of the plane.
inline double ExponentialFront::Distance2Across(
  const Sample& first, const Sample& second, const Vector3d& apex, bool& nearFirst)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vector3d edge = second.Position - first.Position, side = apex - first.Position;
  // Coordinates of the apex and the source along the edge and across it, times the edge's length.
  const double length2 = edge.squaredNorm(), first2 = first.Distance * first.Distance;
  const double apexAlong = side.dot(edge);
  const double along = 0.5 * (first2 - second.Distance * second.Distance + length2);
  // Zero height: the apex lies on the edge, in a triangle without area that closes a gap.
  const double height2 = std::max(0.0, side.squaredNorm() * length2 - apexAlong * apexAlong);
  const double depth2 = first2 * length2 - along * along;
  if (!(depth2 >= 0.0))
  {
    return none;
  }
  const double height = std::sqrt(height2), depth = std::sqrt(depth2), across = height + depth;
  const double crossing = along * height + apexAlong * depth;
  nearFirst = 2.0 * crossing < length2 * across;
  const double shift = apexAlong - along;
  return crossing >= 0.0 && crossing <= length2 * across
    ? (shift * shift + across * across) / length2
    : none;
}

void ExponentialFront::BeginRun(const TangentFrame& seed)
{
  // Marks of older runs are below FirstMark: nothing needs to be cleared, so a run takes no time
  // for the rest of the surface.
  this->FirstMark += StateCount;
  if (this->FirstMark > std::numeric_limits<int>::max() - StateCount)
  {
    std::fill(this->Marks.begin(), this->Marks.end(), -1);
    this->FirstMark = 0;
  }
  this->Queue.clear();
  this->Met.clear();
  this->Covered.clear();
  this->Seed.Position = seed.Origin.transpose();
  this->Seed.Normal = seed.Normal.transpose();
  this->Seed.Axes << seed.XAxis, seed.YAxis;
}

void ExponentialFront::Reach(int node, double distance, int source, State state)
{
  Sample& sample = this->Samples[node];
  int& mark = this->Marks[node];
  // Only through rounding can a path be shorter than the straight line from the seed.
  if (mark < this->FirstMark || (distance < sample.Distance && sample.Source >= 0))
  {
    mark = this->FirstMark + state;
    sample.Distance = distance;
    sample.Source = source;
    this->Queue.emplace_back(distance, node);
    // Older entries of the node stay in the queue and are skipped when they are met.
    std::push_heap(this->Queue.begin(), this->Queue.end(), std::greater<>());
  }
}

void ExponentialFront::ReachAlong(const Sample& from, int node, int source)
{
  const double length = (this->Samples[node].Position - from.Position).norm();
  this->Reach(node, from.Distance + length, source, AlongEdge);
}

/// A triangle with one settled corner is passed along its edges, with two across them; with three
/// it is covered.
void ExponentialFront::Spread(int node)
{
  const Sample& sample = this->Samples[node];
  for (int i = this->Fans.First[node]; i < this->Fans.First[node + 1]; ++i)
  {
    const FanTriangle& triangle = this->Fans.Triangles[i];
    if (triangle.Triangle < 0)
    {
      continue;
    }
    const bool hasNext = this->IsSettled(triangle.Next),
               hasPrevious = this->IsSettled(triangle.Previous);
    if (hasNext && hasPrevious)
    {
      Triangle covered{ triangle.Triangle, {} };
      covered.Nodes[triangle.Corner] = node;
      covered.Nodes[(triangle.Corner + 1) % 3] = triangle.Next;
      covered.Nodes[(triangle.Corner + 2) % 3] = triangle.Previous;
      this->Covered.push_back(covered);
      continue;
    }
    if (!hasNext && !hasPrevious)
    {
      this->ReachAlong(sample, triangle.Next, node);
      this->ReachAlong(sample, triangle.Previous, node);
      continue;
    }
    const int beside = hasNext ? triangle.Next : triangle.Previous,
              ahead = hasNext ? triangle.Previous : triangle.Next;
    bool nearNode = true;
    const double distance2 =
      Distance2Across(sample, this->Samples[beside], this->Samples[ahead].Position, nearNode);
    if (std::isfinite(distance2))
    {
      this->Reach(ahead, std::sqrt(distance2), nearNode ? node : beside, AcrossTriangle);
    }
    else
    {
      this->ReachAlong(sample, ahead, node);
    }
  }
}

/// Finds the neighbours that were reached before, except the one from which the front came.
void ExponentialFront::FindUpwind(int node)
{
  // Whether a neighbour is settled is unpredictable, so a branch would cost more than the rest.
  const int source = this->Samples[node].Source;
  int count = 0;
  for (int i = this->FirstNeighbour[node]; i < this->FirstNeighbour[node + 1]; ++i)
  {
    const int other = this->Neighbours[i];
    this->Upwind[count] = other;
    count += this->IsSettled(other) & (other != source) ? 1 : 0;
  }
  this->UpwindCount = count;
}

/// Returns the mean of all predictions, times a factor (equation 11). The weights are the inverse
/// squared edge lengths, times 1 - tilt x, where x is a neighbour's offset to the left of the line
/// from the seed. So the weights are balanced on both sides of the line, and errors of opposite
/// sign cancel.
EIGEN_ALWAYS_INLINE ExponentialFront::Mean ExponentialFront::UpwindMean(
  const Sample& sample, const Prediction& first) const
{
  constexpr double maximum = 0.9; // maximum of tilt x, so that no weight is negative
  // Keeps the divisions by left and right below finite if no neighbour is on that side.
  constexpr double aside = std::numeric_limits<double>::min();
  Vector2d image = Vector2d::Zero(), moment = Vector2d::Zero();
  Vector3d xAxis = Vector3d::Zero(), axisMoment = Vector3d::Zero();
  double weights = 0.0, moment1 = 0.0, moment2 = 0.0, left = aside, right = -aside;
  const auto add = [&](const Prediction& one)
  {
    const double x = one.Step(0) * first.Image(1) - one.Step(1) * first.Image(0);
    const double weight = 1.0 / one.Length2, weightX = weight * x;
    image += weight * one.Image;
    xAxis += weight * one.XAxis;
    weights += weight;
    moment += weightX * one.Image;
    axisMoment += weightX * one.XAxis;
    moment1 += weightX;
    moment2 += weightX * x;
    left = std::max(left, x);
    right = std::min(right, x);
  };
  add(first);
  for (int i = 0; i < this->UpwindCount; ++i)
  {
    const Prediction one = Predict(this->Samples[this->Upwind[i]], sample);
    // Predictions farther apart come from the other side of a protrusion.
    const double most2 = 2.0 * (one.Length2 + first.Length2);
    if ((one.Image - first.Image).squaredNorm() <= most2)
    {
      add(one);
    }
  }
  // With this tilt the weighted mean of x is 0. It is limited where the weight 1 - tilt x of the
  // outermost neighbour would be less than a tenth.
  const double balanced = moment2 > 0.0 ? moment1 / moment2 : 0.0;
  const double tilt = std::clamp(balanced, maximum / right, maximum / left);
  return { image - tilt * moment, xAxis - tilt * axisMoment, weights - tilt * moment1 };
}

/// Sets the tangent axes closest to an x axis that is nearly tangent.
void ExponentialFront::SetAxes(Sample& sample, const Vector3d& xAxis)
{
  // relative to the square: smaller sums are axes that cancel each other
  constexpr double nothing = 1e-6;
  const Vector3d tangent = xAxis - xAxis.dot(sample.Normal) * sample.Normal;
  const double length2 = tangent.squaredNorm();
  Vector3d x = tangent / std::sqrt(length2);
  if (!(length2 > nothing * xAxis.squaredNorm()))
  {
    x = BuildTangentFrame(sample.Position, sample.Normal).XAxis;
  }
  sample.Axes << x.transpose(), sample.Normal.cross(x).transpose();
}

void ExponentialFront::Settle(int node)
{
  Sample& sample = this->Samples[node];
  const bool isBesideSeed = sample.Source < 0;
  const Prediction first =
    Predict(isBesideSeed ? this->Seed : this->Samples[sample.Source], sample);
  sample.Image = first.Image;
  Vector3d xAxis = first.XAxis;
  if (this->UpwindAverage && !isBesideSeed)
  {
    this->FindUpwind(node);
    const Mean mean = this->UpwindMean(sample, first);
    const double length = mean.Image.norm();
    if (this->Marks[node] == this->FirstMark + AlongEdge)
    {
      // A path along edges is too long, but a path is never shorter than the straight line in
      // space.
      const double minimum = (sample.Position - this->Seed.Position).norm();
      sample.Distance = std::min(sample.Distance, std::max(length / mean.Factor, minimum));
    }
    // The mean of images is nearer to the seed than the point is; only its direction is used.
    sample.Image = mean.Image * (length > 0.0 ? sample.Distance / length : 0.0);
    xAxis = mean.XAxis;
  }
  SetAxes(sample, xAxis);
  this->Marks[node] = this->FirstMark + Settled;
}

/// Starts from the corners of all triangles that contain the seed, inside or on their boundary.
void ExponentialFront::Start(
  const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric)
{
  // barycentric weight of a corner below which the seed lies on the opposite edge
  constexpr double none = 1e-9;
  const auto start = [&](int node)
  {
    const double distance = (this->Samples[node].Position - this->Seed.Position).norm();
    this->Reach(node, distance, -1, AlongEdge);
  };
  std::vector<int> on;
  for (int k = 0; k < 3; ++k)
  {
    start(corners(k));
    if (barycentric(k) > none)
    {
      on.push_back(corners(k));
    }
  }
  if (on.empty() || on.size() == 3)
  {
    return;
  }
  for (int i = this->Fans.First[on[0]]; i < this->Fans.First[on[0] + 1]; ++i)
  {
    const FanTriangle& triangle = this->Fans.Triangles[i];
    if (on.size() == 1 || triangle.Next == on[1] || triangle.Previous == on[1])
    {
      start(triangle.Next);
      start(triangle.Previous);
    }
  }
}

/// Dijkstra's algorithm: nodes are settled in the order of their distance, so all upwind images are
/// final when a node needs them.
void ExponentialFront::Run(const TangentFrame& seed, const Eigen::RowVector3i& corners,
  const Eigen::RowVector3d& barycentric, double radius, const Progress& progress)
{
  // Points between two calls of progress.
  constexpr std::size_t between = 8192;
  this->BeginRun(seed);
  this->Start(corners, barycentric);
  while (!this->Queue.empty())
  {
    std::pop_heap(this->Queue.begin(), this->Queue.end(), std::greater<>());
    const auto [distance, node] = this->Queue.back();
    this->Queue.pop_back();
    if (this->IsSettled(node))
    {
      continue;
    }
    if (distance > radius)
    {
      break;
    }
    if (this->Met.size() % between == 0)
    {
      progress(0.0);
    }
    this->Settle(node);
    this->Met.push_back(node);
    this->Spread(node);
  }
}

} // namespace shape
