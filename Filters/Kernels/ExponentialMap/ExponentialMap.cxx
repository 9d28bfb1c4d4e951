#include "ExponentialMap/ExponentialMap.h"

#include "Base/Errors.h"
#include "ExponentialMap/Private/ExponentialFront.h"
#include "Geometry/Orientation.h"
#include "Geometry/PointGraph.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

namespace
{

/// The normals of most surfaces are equal after fewer rounds.
constexpr int MaximumNormalSmoothing = 1000;

void RequireTriangles(const Surface& surface, const ExponentialMapOptions& options)
{
  if (surface.Triangles().rows() == 0)
  {
    throw InvalidInput("the surface has no triangles; give a triangulated surface");
  }
  RequireFinite(surface.Points(), "the surface");
  RequireOption(options.NormalSmoothing >= 0 && options.NormalSmoothing <= MaximumNormalSmoothing,
    "NormalSmoothing", options.NormalSmoothing, "at least 0 and at most 1000");
}

/// Marks the nodes that are ends of an edge with one triangle. Half-edges are sorted by their
/// points: those of one edge follow each other.
std::vector<char> NodesOnLoop(const Surface& welded)
{
  std::vector<char> onLoop(welded.Points().rows(), 0);
  const std::vector<HalfEdge>& sides = welded.HalfEdges();
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const HalfEdge& side = sides[begin];
    while (end < sides.size() && sides[end].Low() == side.Low() && sides[end].High() == side.High())
    {
      ++end;
    }
    if (end == begin + 1)
    {
      onLoop[side.Low()] = onLoop[side.High()] = 1;
    }
  }
  return onLoop;
}

std::vector<char> NodesOnRim(const SampledSurface& samples, const std::vector<int>& pointOf)
{
  std::vector<char> onRim;
  for (const int point : pointOf)
  {
    onRim.push_back(samples.OnRim[point]);
  }
  return onRim;
}

/// Returns the squared length of a triangle's longest edge.
template <typename Corners>
double LongestEdge2(const Corners& a, const Corners& b, const Corners& c)
{
  return std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
}

/// The points at each node: those of node i are Points[First[i]] ... Points[First[i + 1] - 1].
struct PointsOfNodes
{
  PointsOfNodes(const Eigen::VectorXi& nodeOf, int nodes)
    : First(nodes + 1, 0)
    , Points(nodeOf.size())
  {
    for (const int node : nodeOf)
    {
      ++this->First[node + 1];
    }
    for (int i = 0; i < nodes; ++i)
    {
      this->First[i + 1] += this->First[i];
    }
    std::vector<int> next(this->First.begin(), this->First.end() - 1);
    for (int point = 0; point < nodeOf.size(); ++point)
    {
      this->Points[next[nodeOf(point)]++] = point;
    }
  }

  std::vector<int> First, Points;
};

} // namespace

struct ExponentialMap::Target
{
  void AddPoints(ExponentialPatch& patch);
  void AddTriangles(ExponentialPatch& patch);

  SurfaceLocator Locator;
  Eigen::VectorXi NodeOf; ///< node of each point
  shape::Surface Welded;  ///< the surface with nodes as points
  Eigen::MatrixXd Normals;
  ExponentialFront Front;
  std::vector<char> OnLoop; ///< for each node
  PointsOfNodes Copies;
  Eigen::VectorXd Shares; ///< of the triangles of a sampled surface, or empty
  std::vector<int> Rows;  ///< row of each point in the last patch, if it is in it
};

void ExponentialMap::Target::AddPoints(ExponentialPatch& patch)
{
  for (const int node : this->Front.Nodes())
  {
    patch.ReachesBoundary = patch.ReachesBoundary || this->OnLoop[node];
    for (int i = this->Copies.First[node]; i < this->Copies.First[node + 1]; ++i)
    {
      const int point = this->Copies.Points[i];
      this->Rows[point] = static_cast<int>(patch.Points.size());
      patch.Points.push_back(point);
    }
  }
  const auto count = static_cast<Eigen::Index>(patch.Points.size());
  patch.Positions.resize(count, 2);
  patch.Distances.resize(count);
  for (Eigen::Index row = 0; row < count; ++row)
  {
    const int node = this->NodeOf(patch.Points[row]);
    patch.Positions.row(row) = this->Front.Image(node).transpose();
    patch.Distances(row) = this->Front.Distance(node);
  }
}

/// Triangles with all corners settled: no triangle extends beyond the front.
void ExponentialMap::Target::AddTriangles(ExponentialPatch& patch)
{
  constexpr double flat = 1e-14; // maximum area of a degenerate triangle / its longest squared edge
  constexpr double torn2 = 4.0;  // square of twice the length
  const std::vector<ExponentialFront::Triangle>& triangles = this->Front.Triangles();
  patch.Triangles.reserve(triangles.size());
  patch.Corners.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  const bool isWelded = this->OnLoop.size() < this->Rows.size();
  for (const auto& [triangle, nodes] : triangles)
  {
    const auto row = static_cast<int>(patch.Triangles.size());
    patch.Triangles.push_back(triangle);
    for (int k = 0; k < 3; ++k)
    {
      const int point = isWelded ? this->Locator.GetSurface().Triangles()(triangle, k) : nodes[k];
      patch.Corners(row, k) = this->Rows[point];
    }
    const RowVector2d a = patch.Positions.row(patch.Corners(row, 0)),
                      b = patch.Positions.row(patch.Corners(row, 1)),
                      c = patch.Positions.row(patch.Corners(row, 2));
    const Eigen::Vector3d p = this->Front.Position(nodes[0]), q = this->Front.Position(nodes[1]),
                          r = this->Front.Position(nodes[2]);
    const double longest2 = LongestEdge2(p, q, r);
    if (LongestEdge2(a, b, c) > torn2 * longest2)
    {
      patch.Torn.push_back(row);
    }
    if (EvaluateOrientation(a, b, c) <= 0 && (q - p).cross(r - p).norm() > flat * longest2)
    {
      patch.Flipped.push_back(row);
    }
  }
  if (this->Shares.size() > 0)
  {
    patch.Shares = this->Shares(patch.Triangles);
  }
}

ExponentialMap::ExponentialMap(
  const shape::Surface& surface, const ExponentialMapOptions& options, const Progress& progress)
{
  this->Build(surface, nullptr, options, progress);
}

ExponentialMap::ExponentialMap(
  const SampledSurface& samples, const ExponentialMapOptions& options, const Progress& progress)
{
  this->Build(samples.Surface, &samples, options, progress);
}

/// samples: the points of which `surface` has the local triangles, or nullptr for a mesh.
void ExponentialMap::Build(const shape::Surface& surface, const SampledSurface* samples,
  const ExponentialMapOptions& options, const Progress& progress)
{
  RequireTriangles(surface, options);
  PointGraphOptions linked;
  linked.Nearest = 0; // points that no triangle uses do not belong to the surface
  PointGraph graph = BuildPointGraph(ShapeElements{ surface.Points(), {}, surface.Triangles(), {} },
    linked, progress.Part(0.0, 0.4));
  // Without coincident points the nodes are the points, and the surface's own cache is used.
  const bool isWelded = graph.Size() < surface.Points().rows();
  const shape::Surface welded = isWelded
    ? shape::Surface(graph.Positions,
        surface.Triangles().unaryExpr([&](int point) { return graph.NodeOf(point); }))
    : surface;
  const Eigen::MatrixXi& nodes = welded.Triangles();
  Eigen::MatrixXd normals = SmoothNormals(graph,
    samples ? Eigen::MatrixXd(samples->Normals(graph.PointOf, Eigen::all))
            : GetVertexNormals(welded),
    options.NormalSmoothing, progress.Part(0.4, 0.6));
  ExponentialFront front(graph, nodes, normals, options.UpwindAverage);
  progress(0.7);
  SurfaceLocator locator(surface);
  progress(0.9);
  std::vector<char> onLoop = samples ? NodesOnRim(*samples, graph.PointOf) : NodesOnLoop(welded);
  PointsOfNodes copies(graph.NodeOf, graph.Size());
  this->Impl.reset(new Target{ std::move(locator), std::move(graph.NodeOf), welded,
    std::move(normals), std::move(front), std::move(onLoop), std::move(copies),
    samples ? samples->Shares : Eigen::VectorXd(), std::vector<int>(surface.Points().rows()) });
  progress(1.0);
}

ExponentialMap::~ExponentialMap() = default;
ExponentialMap::ExponentialMap(ExponentialMap&&) noexcept = default;
ExponentialMap& ExponentialMap::operator=(ExponentialMap&&) noexcept = default;

const shape::Surface& ExponentialMap::Surface() const
{
  return this->Impl->Locator.GetSurface();
}

const SurfaceLocator& ExponentialMap::Locator() const
{
  return this->Impl->Locator;
}

RowVector3d ExponentialMap::Normal(const ClosestPoint& position) const
{
  const Eigen::RowVector3i nodes = this->Impl->Welded.Triangles().row(position.Triangle);
  RowVector3d normal = RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += position.Barycentric(k) * this->Impl->Normals.row(nodes(k));
  }
  // Between corners with opposite normals the interpolated normal vanishes.
  constexpr double opposite = 1e-9;
  if (normal.norm() < opposite)
  {
    Eigen::Index nearest = 0;
    position.Barycentric.maxCoeff(&nearest);
    return this->Impl->Normals.row(nodes(nearest));
  }
  return normal.normalized();
}

/// The discrete exponential map (Schmidt, Grimm and Wyvill) in three parts: the frame at the seed,
/// the front that computes the images (ExponentialFront), and the triangles that it covered.
ExponentialPatch ExponentialMap::Around(
  const ClosestPoint& seed, double radius, const RowVector3d& xDirection, const Progress& progress)
{
  RequireOption(std::isfinite(radius) && radius > 0.0, "Radius", radius, "positive and finite");
  if (seed.Triangle < 0 || seed.Triangle >= this->Surface().Triangles().rows() ||
    !seed.Barycentric.allFinite() || !xDirection.allFinite())
  {
    throw InvalidInput("the seed is not on the surface, or its x direction is not finite; "
                       "give the closest point of the surface and a finite direction");
  }
  ExponentialPatch patch;
  patch.Seed = BuildTangentFrame(
    seed.Barycentric * GetCorners(this->Surface(), seed.Triangle), this->Normal(seed), xDirection);
  this->Impl->Front.Run(patch.Seed, this->Impl->Welded.Triangles().row(seed.Triangle),
    seed.Barycentric, radius, progress);
  this->Impl->AddPoints(patch);
  this->Impl->AddTriangles(patch);
  return patch;
}

ExponentialPatch ExponentialMap::Around(const RowVector3d& seed, double radius,
  const RowVector3d& xDirection, int guess, const Progress& progress)
{
  RequireFinite(seed, "the seed");
  return this->Around(this->Locator().FindOne(seed, guess), radius, xDirection, progress);
}

} // namespace shape
