#include "Deform/Private/HandleSources.h"

#include "Base/Errors.h"
#include "Deform/Private/BlendedRows.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Half of the triangles around a point of a regular border, over the square of their sides.
constexpr double BoundaryRing = 1.3;

void RequireHandle(const BoundaryHandle& handle)
{
  if (handle.Positions.rows() == 0)
  {
    throw InvalidInput("the handle has no points; give it some");
  }
  RequireFinite(handle.Positions, "the handle");
  for (const Eigen::MatrixXi* elements : { &handle.Segments, &handle.Triangles })
  {
    if (elements->size() > 0 &&
      (elements->minCoeff() < 0 || elements->maxCoeff() >= handle.Positions.rows()))
    {
      throw InvalidInput("a segment or triangle of the handle has the point " +
        std::to_string(elements->minCoeff() < 0 ? elements->minCoeff() : elements->maxCoeff()) +
        ", but there are " + std::to_string(handle.Positions.rows()) +
        " points; mend its connectivity");
    }
  }
}

/// Gathers the sources of a handle, element by element.
class Attachment
{
public:
  Attachment(const PointGraph& shape, const BoundaryHandle& handle)
    : Shape(shape)
    , Handle(handle)
    , Tree(shape.Positions)
    , Own(handle.Positions)
    , Tolerance(
        1e-6 * std::max(ComputeBoxDiagonal(shape.Positions), ComputeBoxDiagonal(handle.Positions)))
    , Step(shape.MeanLength)
    , SourceOf(shape.Size(), -1)
  {
    if (!(this->Step > 0.0))
    {
      const double size = ComputeBoxDiagonal(handle.Positions);
      this->Step = size > 0.0 ? size : 1.0;
    }
    this->Tolerance = std::min(this->Tolerance, 0.1 * this->Step);
    // A handle that is much larger than the shape has no more gaps filled than this.
    constexpr double maximum = 20000.0;
    double length = 0.0;
    for (const auto& segment : handle.Segments.rowwise())
    {
      length += (handle.Positions.row(segment(0)) - handle.Positions.row(segment(1))).norm();
    }
    const double area =
      0.5 * ComputeAreaVectors({ handle.Positions, handle.Triangles }).rowwise().norm().sum();
    this->Gap = std::max({ this->Step, length / maximum, std::sqrt(area / maximum) });
  }

  void AddSamples(const Progress& progress)
  {
    const auto samples = static_cast<int>(this->Handle.Positions.rows());
    for (int i = 0; i < samples; ++i)
    {
      if (i % 16384 == 0)
      {
        progress(static_cast<double>(i) / samples);
      }
      const int twin =
        this->Own.Within(this->Handle.Positions.row(i), 1e-3 * this->Tolerance).front();
      const int source = twin < i
        ? this->OfSample[twin]
        : this->AddPosition(this->Handle.Positions.row(i), Eigen::RowVector3i(i, i, i),
            Eigen::RowVector3d(1.0, 0.0, 0.0));
      this->OfSample.push_back(source);
    }
  }

  /// The sources along a segment, with their places on it in [0, 1]; on a curve they count by the
  /// length that each stands for.
  void AddSegment(int a, int b, bool onCurve)
  {
    const int first = this->OfSample[a], last = this->OfSample[b];
    if (first == last)
    {
      return;
    }
    const Eigen::RowVector3d from = this->Handle.Positions.row(a),
                             to = this->Handle.Positions.row(b);
    const double length = (to - from).norm();
    std::vector<std::pair<double, int>> along = { { 0.0, first }, { 1.0, last } };
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / this->Gap)));
    std::vector<int> candidates;
    for (int k = 0; k < pieces; ++k)
    {
      const Eigen::RowVector3d middle = from + (k + 0.5) / pieces * (to - from);
      const std::vector<int> near =
        this->Tree.Within(middle, 0.5 * length / pieces + this->Tolerance);
      candidates.insert(candidates.end(), near.begin(), near.end());
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    for (const int node : candidates)
    {
      const Eigen::RowVector3d position = this->Shape.Positions.row(node);
      const double t = (position - from).dot(to - from) / (length * length);
      if (this->SourceOf[node] < 0 && t > 0.0 && t < 1.0 &&
        (position - from - t * (to - from)).norm() <= this->Tolerance)
      {
        this->Bind(node, Eigen::RowVector3i(a, b, b), Eigen::RowVector3d(1.0 - t, t, 0.0));
        along.emplace_back(t, this->SourceOf[node]);
      }
    }
    std::sort(along.begin(), along.end());
    const std::vector<std::pair<double, int>> before = along;
    for (std::size_t k = 1; k < before.size(); ++k)
    {
      const double gap = before[k].first - before[k - 1].first;
      const int parts = static_cast<int>(std::ceil(gap * length / this->Gap - 0.5));
      for (int j = 1; j < parts; ++j)
      {
        const double t = before[k - 1].first + gap * j / parts;
        along.emplace_back(t,
          this->AddPosition(from + t * (to - from), Eigen::RowVector3i(a, b, b),
            Eigen::RowVector3d(1.0 - t, t, 0.0)));
      }
    }
    std::sort(along.begin(), along.end());
    for (std::size_t k = 1; k < along.size(); ++k)
    {
      const int p = along[k - 1].second, q = along[k].second;
      if (p == q)
      {
        continue;
      }
      this->Links.emplace_back(this->Nodes[p], this->Nodes[q]);
      if (onCurve)
      {
        const double half = 0.5 * (along[k].first - along[k - 1].first) * length;
        this->Weights[p] += BoundaryRing * this->Step * half;
        this->Weights[q] += BoundaryRing * this->Step * half;
      }
    }
  }

  void AddTriangle(Eigen::RowVector3i corners)
  {
    while (this->Side(corners, 0) < std::max(this->Side(corners, 1), this->Side(corners, 2)))
    {
      corners = Eigen::RowVector3i(corners(1), corners(2), corners(0)); // the longest side first
    }
    const Eigen::RowVector3d a = this->Handle.Positions.row(corners(0));
    const Eigen::RowVector3d u = this->Handle.Positions.row(corners(1)) - a;
    const Eigen::RowVector3d v = this->Handle.Positions.row(corners(2)) - a;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    const double area = 0.5 * std::sqrt(std::max(determinant, 0.0));
    std::vector<int> sources = { this->OfSample[corners(0)], this->OfSample[corners(1)],
      this->OfSample[corners(2)] };
    const double longest = std::sqrt(std::max({ uu, vv, (u - v).squaredNorm() }));
    if (area > 1e-9 * longest * longest)
    {
      const auto inside = [](const Eigen::RowVector3d& shares) { return shares.minCoeff() > 0.0; };
      for (const int node : this->Tree.Within(a + (u + v) / 3.0, longest + this->Tolerance))
      {
        const Eigen::RowVector3d w = this->Shape.Positions.row(node) - a;
        const double s = (vv * u.dot(w) - uv * v.dot(w)) / determinant;
        const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
        const Eigen::RowVector3d shares(1.0 - s - t, s, t);
        if (this->SourceOf[node] < 0 && inside(shares) &&
          (w - s * u - t * v).norm() <= this->Tolerance)
        {
          this->Bind(node, corners, shares);
          sources.push_back(this->SourceOf[node]);
        }
      }
      const auto parts = [this](double length)
      { return static_cast<int>(std::ceil(length / this->Gap - 0.5)); };
      // As high as an equilateral triangle has as many rows as parts along its sides.
      const int along = parts(longest), rows = parts(2.0 * area / longest / std::sqrt(0.75));
      const bool empty = sources.size() == 3;
      for (int i = 1; empty && i < rows; ++i)
      {
        const double left = 1.0 - static_cast<double>(i) / rows;
        const int columns = static_cast<int>(std::lround(left * along));
        for (int j = 1; j < columns; ++j)
        {
          const double share = left * j / columns;
          const Eigen::RowVector3d shares(left - share, share, 1.0 - left);
          sources.push_back(this->AddPosition(a + shares(1) * u + shares(2) * v, corners, shares));
        }
      }
    }
    for (const int source : sources)
    {
      this->Weights[source] += 3.0 * area / static_cast<double>(sources.size());
    }
  }

  HandleSources Finish()
  {
    HandleSources result;
    result.Graph = this->Shape;
    result.Graph.MeanLength = this->Step;
    std::vector<std::pair<int, int>> links = ListLinks(this->Shape);
    links.insert(links.end(), this->Links.begin(), this->Links.end());
    const int own = this->Shape.Size(), all = own + static_cast<int>(this->Extra.size());
    result.Graph.Positions.conservativeResize(all, Eigen::NoChange);
    result.Graph.Weights.conservativeResize(all);
    for (int i = own; i < all; ++i)
    {
      result.Graph.Positions.row(i) = this->Extra[i - own];
      this->LinkToShape(i, this->Extra[i - own], links);
    }
    SetLinks(result.Graph, std::move(links));
    const auto sources = static_cast<Eigen::Index>(this->Nodes.size());
    result.Samples.resize(sources, 3);
    result.Shares.resize(sources, 3);
    for (Eigen::Index k = 0; k < sources; ++k)
    {
      const int node = this->Nodes[k];
      result.Samples.row(k) = this->Samples[k];
      result.Shares.row(k) = this->Shares[k];
      const double alone = node < own ? this->Shape.Weights(node) : this->Step * this->Step;
      result.Graph.Weights(node) = this->Weights[k] > 0.0 ? this->Weights[k] : alone;
    }
    result.Nodes = std::move(this->Nodes);
    return result;
  }

private:
  double Side(const Eigen::RowVector3i& corners, int k) const
  {
    return (
      this->Handle.Positions.row(corners((k + 1) % 3)) - this->Handle.Positions.row(corners(k)))
      .norm();
  }

  /// The shape's node at a place, or a new one, as a source.
  int AddPosition(const Eigen::RowVector3d& position, const Eigen::RowVector3i& samples,
    const Eigen::RowVector3d& shares)
  {
    const int node = this->Tree.Nearest(position, 1).front();
    if ((this->Shape.Positions.row(node) - position).norm() <= this->Tolerance)
    {
      if (this->SourceOf[node] < 0)
      {
        this->Bind(node, samples, shares);
      }
      return this->SourceOf[node];
    }
    this->Extra.push_back(position);
    return this->Add(
      this->Shape.Size() + static_cast<int>(this->Extra.size()) - 1, samples, shares);
  }

  void Bind(int node, const Eigen::RowVector3i& samples, const Eigen::RowVector3d& shares)
  {
    this->SourceOf[node] = this->Add(node, samples, shares);
  }

  int Add(int node, const Eigen::RowVector3i& samples, const Eigen::RowVector3d& shares)
  {
    this->Nodes.push_back(node);
    this->Samples.push_back(samples);
    this->Shares.push_back(shares);
    this->Weights.push_back(0.0);
    return static_cast<int>(this->Nodes.size()) - 1;
  }

  /// With its nearest node, and others hardly farther.
  void LinkToShape(
    int node, const Eigen::RowVector3d& position, std::vector<std::pair<int, int>>& links) const
  {
    constexpr int maximum = 6;
    const std::vector<int> near = this->Tree.Nearest(position, maximum);
    const double nearest = (this->Shape.Positions.row(near.front()) - position).norm();
    for (const int other : near)
    {
      if ((this->Shape.Positions.row(other) - position).norm() <= nearest + this->Step)
      {
        links.emplace_back(node, other);
      }
    }
  }

  const PointGraph& Shape;
  const BoundaryHandle& Handle;
  PointTree Tree, Own;
  double Tolerance, Step;
  double Gap;                ///< between sources, at most
  std::vector<int> SourceOf; ///< of the shape's nodes, or -1
  std::vector<int> OfSample;
  std::vector<int> Nodes;
  std::vector<Eigen::RowVector3i> Samples;
  std::vector<Eigen::RowVector3d> Shares, Extra;
  std::vector<double> Weights;
  std::vector<std::pair<int, int>> Links;
};

} // namespace

HandleSources AttachHandle(
  const PointGraph& shape, const BoundaryHandle& handle, const Progress& progress)
{
  RequireHandle(handle);
  progress(0.0);
  Attachment attachment(shape, handle);
  attachment.AddSamples(progress.Part(0.0, 0.3));
  // Calls of progress after so many elements.
  constexpr Eigen::Index often = 8192;
  for (Eigen::Index i = 0; i < handle.Segments.rows(); ++i)
  {
    if (i % often == 0)
    {
      progress(0.3);
    }
    attachment.AddSegment(handle.Segments(i, 0), handle.Segments(i, 1), true);
  }
  const std::vector<HalfEdge> sides = SortHalfEdges(handle.Triangles, handle.Positions.rows());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (i % often == 0)
    {
      progress(0.5);
    }
    if (i == 0 || sides[i].Low() != sides[i - 1].Low() || sides[i].High() != sides[i - 1].High())
    {
      attachment.AddSegment(sides[i].Low(), sides[i].High(), false);
    }
  }
  for (Eigen::Index t = 0; t < handle.Triangles.rows(); ++t)
  {
    if (t % often == 0)
    {
      progress(0.7);
    }
    attachment.AddTriangle(handle.Triangles.row(t));
  }
  progress(0.9);
  HandleSources sources = attachment.Finish();
  progress(1.0);
  return sources;
}

NodeTransforms MoveSources(const HandleSources& sources, const BoundaryHandle& handle,
  const HandlePose& pose, const Eigen::VectorXd& scales)
{
  const auto count = static_cast<Eigen::Index>(sources.Nodes.size());
  NodeTransforms motions{ Eigen::MatrixXd(3, count), {} };
  motions.Rotations.reserve(count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero(), shift = position;
    Eigen::Matrix3d blend = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 3; ++c)
    {
      const int sample = sources.Samples(k, c);
      const double share = sources.Shares(k, c);
      position += share * handle.Positions.row(sample);
      shift += share * (pose.Positions.row(sample) - handle.Positions.row(sample));
      blend += share * pose.Rotations[sample];
    }
    const bool atSample = sources.Shares(k, 0) == 1.0;
    motions.Rotations.push_back(
      atSample ? pose.Rotations[sources.Samples(k, 0)] : FitRotation(blend));
    // Nodes are on the handle but for rounding, or for what single precision makes of it.
    const int node = sources.Nodes[k];
    const Eigen::RowVector3d rest = sources.Graph.Positions.row(node) - position;
    const Eigen::Matrix3d turn =
      scales(node) * motions.Rotations.back() - Eigen::Matrix3d::Identity();
    motions.Shifts.col(k) = shift.transpose() + turn * rest.transpose();
  }
  return motions;
}

} // namespace shape
