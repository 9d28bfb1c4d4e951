#include "Deform/Private/HandleAttachment.h"

#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Eigen::RowVector3i;

void RequireHandle(const BoundaryHandle& handle)
{
  if (handle.Positions.rows() == 0)
  {
    throw InvalidInput("the handle has no points; add points to it");
  }
  RequireFinite(handle.Positions, "the handle");
  for (const Eigen::MatrixXi* elements : { &handle.Segments, &handle.Triangles })
  {
    if (elements->size() > 0 &&
      (elements->minCoeff() < 0 || elements->maxCoeff() >= handle.Positions.rows()))
    {
      throw InvalidInput("a segment or triangle of the handle contains point " +
        std::to_string(elements->minCoeff() < 0 ? elements->minCoeff() : elements->maxCoeff()) +
        ", but the handle has " + std::to_string(handle.Positions.rows()) +
        " points; correct its connectivity");
    }
  }
}

/// A triangle's edge vectors from its first corner, and their products.
struct TriangleEdges
{
  TriangleEdges(const Eigen::MatrixXd& positions, const RowVector3i& corners)
    : Origin(positions.row(corners(0)))
    , U(positions.row(corners(1)) - Origin)
    , V(positions.row(corners(2)) - Origin)
    , Uu(this->U.dot(this->U))
    , Uv(this->U.dot(this->V))
    , Vv(this->V.dot(this->V))
    , Determinant(this->Uu * this->Vv - this->Uv * this->Uv)
  {
  }

  double Area() const { return 0.5 * std::sqrt(std::max(this->Determinant, 0.0)); }
  double Longest() const
  {
    return std::sqrt(std::max({ this->Uu, this->Vv, (this->U - this->V).squaredNorm() }));
  }

  RowVector3d Origin, U, V;
  double Uu, Uv, Vv, Determinant;
};

} // namespace

HandleAttachment::HandleAttachment(const PointGraph& shape, const BoundaryHandle& handle)
  : Shape(shape)
  , Handle(handle)
  , Tree(shape.Positions)
  , SampleTree(handle.Positions)
  // Positions that were stored in single precision differ by up to 1e-7 of the size.
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
  // On a fine shape the tolerance must not reach the next node.
  this->Tolerance = std::min(this->Tolerance, 0.1 * this->Step);
  // The maximum number of gaps filled, for handles much larger than the shape.
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

void HandleAttachment::AddSamples(const Progress& progress)
{
  const auto samples = static_cast<int>(this->Handle.Positions.rows());
  for (int i = 0; i < samples; ++i)
  {
    if (i % 16384 == 0)
    {
      progress(static_cast<double>(i) / samples);
    }
    const RowVector3d position = this->Handle.Positions.row(i);
    const int first = this->SampleTree.Within(position, 1e-3 * this->Tolerance).front();
    const int source = first < i
      ? this->OfSample[first]
      : this->AddPosition(position, RowVector3i(i, i, i), RowVector3d(1.0, 0.0, 0.0));
    this->OfSample.push_back(source);
  }
}

/// Returns the shape's nodes near a segment, searched in spheres that cover it.
std::vector<int> HandleAttachment::FindNodesNear(
  const RowVector3d& from, const RowVector3d& to) const
{
  const double length = (to - from).norm();
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / this->Gap)));
  std::vector<int> nodes;
  for (int k = 0; k < pieces; ++k)
  {
    const RowVector3d middle = from + (k + 0.5) / pieces * (to - from);
    const std::vector<int> near =
      this->Tree.Within(middle, 0.5 * length / pieces + this->Tolerance);
    nodes.insert(nodes.end(), near.begin(), near.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void HandleAttachment::BindNodesOnSegment(int a, int b, std::vector<SegmentSource>& along)
{
  const RowVector3d from = this->Handle.Positions.row(a), to = this->Handle.Positions.row(b);
  const double length = (to - from).norm();
  for (const int node : this->FindNodesNear(from, to))
  {
    const RowVector3d position = this->Shape.Positions.row(node);
    const double t = (position - from).dot(to - from) / (length * length);
    if (this->SourceOf[node] < 0 && t > 0.0 && t < 1.0 &&
      (position - from - t * (to - from)).norm() <= this->Tolerance)
    {
      this->Bind(node, RowVector3i(a, b, b), RowVector3d(1.0 - t, t, 0.0));
      along.emplace_back(t, this->SourceOf[node]);
    }
  }
  std::sort(along.begin(), along.end());
}

/// Adds new sources between those along a segment that are too far apart.
void HandleAttachment::FillGaps(int a, int b, std::vector<SegmentSource>& along)
{
  const RowVector3d from = this->Handle.Positions.row(a), to = this->Handle.Positions.row(b);
  const double length = (to - from).norm();
  const std::vector<SegmentSource> before = along;
  for (std::size_t k = 1; k < before.size(); ++k)
  {
    const double gap = before[k].first - before[k - 1].first;
    const int parts = this->CountParts(gap * length);
    for (int j = 1; j < parts; ++j)
    {
      const double t = before[k - 1].first + gap * j / parts;
      along.emplace_back(t,
        this->AddPosition(
          from + t * (to - from), RowVector3i(a, b, b), RowVector3d(1.0 - t, t, 0.0)));
    }
  }
  std::sort(along.begin(), along.end());
}

/// Nodes of the shape on the segment become sources first, since new positions are needed only in
/// the gaps between these.
void HandleAttachment::AddSegment(int a, int b, bool onCurve)
{
  const int first = this->OfSample[a], last = this->OfSample[b];
  if (first == last)
  {
    return;
  }
  std::vector<SegmentSource> along = { { 0.0, first }, { 1.0, last } };
  this->BindNodesOnSegment(a, b, along);
  this->FillGaps(a, b, along);
  const double length = (this->Handle.Positions.row(b) - this->Handle.Positions.row(a)).norm();
  if (onCurve)
  {
    this->CurveSegments.emplace_back(first, last);
  }
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
      // A source of a curve weighs what a boundary vertex of the shape would: half of the segment
      // on each side of it, times the width of a ring (w_reg, equation 8).
      for (const int source : { p, q })
      {
        this->Weights[source] += CurveWidth * this->Step * half;
        this->CurveWeights[source] += CurveWidth * this->Step * half;
      }
    }
  }
}

void HandleAttachment::BindNodesInTriangle(const RowVector3i& corners, std::vector<int>& sources)
{
  const TriangleEdges edges(this->Handle.Positions, corners);
  const RowVector3d &u = edges.U, &v = edges.V;
  for (const int node :
    this->Tree.Within(edges.Origin + (u + v) / 3.0, edges.Longest() + this->Tolerance))
  {
    const RowVector3d w = this->Shape.Positions.row(node) - edges.Origin;
    // Barycentric coordinates of the projection, from the normal equations of w = s u + t v.
    const double s = (edges.Vv * u.dot(w) - edges.Uv * v.dot(w)) / edges.Determinant;
    const double t = (edges.Uu * v.dot(w) - edges.Uv * u.dot(w)) / edges.Determinant;
    const RowVector3d shares(1.0 - s - t, s, t);
    if (this->SourceOf[node] < 0 && shares.minCoeff() > 0.0 &&
      (w - s * u - t * v).norm() <= this->Tolerance)
    {
      this->Bind(node, corners, shares);
      sources.push_back(this->SourceOf[node]);
    }
  }
}

/// Adds a triangular grid inside, with rows along the first edge, which is the longest one. It has
/// as many rows as an equilateral triangle with as many parts along its edges.
void HandleAttachment::AddGrid(const RowVector3i& corners, double area, std::vector<int>& sources)
{
  const TriangleEdges edges(this->Handle.Positions, corners);
  const double longest = edges.Longest();
  const int along = this->CountParts(longest);
  // The height over the longest edge; an equilateral triangle of edge h has the height sqrt(3/4) h.
  const int rows = this->CountParts(2.0 * area / longest / std::sqrt(0.75));
  for (int i = 1; i < rows; ++i)
  {
    const double left = 1.0 - static_cast<double>(i) / rows;
    const int columns = static_cast<int>(std::lround(left * along));
    for (int j = 1; j < columns; ++j)
    {
      const double share = left * j / columns;
      const RowVector3d shares(left - share, share, 1.0 - left);
      sources.push_back(this->AddPosition(
        edges.Origin + shares(1) * edges.U + shares(2) * edges.V, corners, shares));
    }
  }
}

void HandleAttachment::AddTriangle(RowVector3i corners)
{
  while (this->EdgeLength(corners, 0) <
    std::max(this->EdgeLength(corners, 1), this->EdgeLength(corners, 2)))
  {
    corners = RowVector3i(corners(1), corners(2), corners(0)); // the longest edge first
  }
  const TriangleEdges edges(this->Handle.Positions, corners);
  const double area = edges.Area(), longest = edges.Longest();
  std::vector<int> sources = { this->OfSample[corners(0)], this->OfSample[corners(1)],
    this->OfSample[corners(2)] };
  // A triangle without area has no barycentric coordinates; its edges were added before.
  if (area > 1e-9 * longest * longest)
  {
    this->BindNodesInTriangle(corners, sources);
    if (sources.size() == 3)
    {
      this->AddGrid(corners, area, sources);
    }
  }
  for (const int source : sources)
  {
    // w_reg sums whole triangles (equation 8), so each counts three times in total, once for each
    // corner.
    this->Weights[source] += 3.0 * area / static_cast<double>(sources.size());
  }
}

HandleSources HandleAttachment::Finish()
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
  result.Curves.OtherShares.resize(sources);
  for (Eigen::Index k = 0; k < sources; ++k)
  {
    const int node = this->Nodes[k];
    result.Samples.row(k) = this->Samples[k];
    result.Shares.row(k) = this->Shares[k];
    const double alone = node < own ? this->Shape.Weights(node) : this->Step * this->Step;
    const bool weighted = this->Weights[k] > 0.0;
    result.Graph.Weights(node) = weighted ? this->Weights[k] : alone;
    result.Curves.OtherShares(k) = weighted ? 1.0 - this->CurveWeights[k] / this->Weights[k] : 1.0;
  }
  result.Curves.Segments.resize(static_cast<Eigen::Index>(this->CurveSegments.size()), 2);
  for (std::size_t i = 0; i < this->CurveSegments.size(); ++i)
  {
    const auto& [from, to] = this->CurveSegments[i];
    result.Curves.Segments.row(static_cast<Eigen::Index>(i)) << from, to;
  }
  result.Nodes = std::move(this->Nodes);
  return result;
}

double HandleAttachment::EdgeLength(const RowVector3i& corners, int k) const
{
  return (this->Handle.Positions.row(corners((k + 1) % 3)) - this->Handle.Positions.row(corners(k)))
    .norm();
}

/// Returns the number of parts into which a length is divided to limit the gaps.
int HandleAttachment::CountParts(double length) const
{
  // Parts are then between 0.5 and 1.5 gaps long.
  return static_cast<int>(std::ceil(length / this->Gap - 0.5));
}

/// The shape's node at a position, or a new one, as a source.
int HandleAttachment::AddPosition(
  const RowVector3d& position, const RowVector3i& samples, const RowVector3d& shares)
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
  return this->Add(this->Shape.Size() + static_cast<int>(this->Extra.size()) - 1, samples, shares);
}

/// Makes a source of a node of the shape.
void HandleAttachment::Bind(int node, const RowVector3i& samples, const RowVector3d& shares)
{
  this->SourceOf[node] = this->Add(node, samples, shares);
}

int HandleAttachment::Add(int node, const RowVector3i& samples, const RowVector3d& shares)
{
  this->Nodes.push_back(node);
  this->Samples.push_back(samples);
  this->Shares.push_back(shares);
  this->Weights.push_back(0.0);
  this->CurveWeights.push_back(0.0);
  return static_cast<int>(this->Nodes.size()) - 1;
}

/// Links a new node with its nearest node of the shape, and with others at nearly that distance.
void HandleAttachment::LinkToShape(
  int node, const RowVector3d& position, std::vector<std::pair<int, int>>& links) const
{
  // As many as a regular vertex has neighbours.
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

HandleSources AttachHandle(
  const PointGraph& shape, const BoundaryHandle& handle, const Progress& progress)
{
  RequireHandle(handle);
  progress(0.0);
  HandleAttachment attachment(shape, handle);
  attachment.AddSamples(progress.Part(0.0, 0.3));
  constexpr Eigen::Index often = 8192; // elements between two calls of progress
  for (Eigen::Index i = 0; i < handle.Segments.rows(); ++i)
  {
    if (i % often == 0)
    {
      progress(0.3);
    }
    attachment.AddSegment(handle.Segments(i, 0), handle.Segments(i, 1), true);
  }
  const std::vector<HalfEdge> edges = SortHalfEdges(handle.Triangles, handle.Positions.rows());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i % often == 0)
    {
      progress(0.5);
    }
    if (i == 0 || edges[i].Low() != edges[i - 1].Low() || edges[i].High() != edges[i - 1].High())
    {
      attachment.AddSegment(edges[i].Low(), edges[i].High(), false);
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

} // namespace shape
