#include "Geometry/VertexNormals.h"

#include "Geometry/Private/ParaboloidFit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// The normal of a triangle, weighted for its corner number `corner`.
RowVector3d WeightedNormal(const Eigen::MatrixXd& points, const Eigen::RowVector3i& triangle,
  int corner, NormalWeight weight)
{
  // Area and normal do not depend on the corner; from the first one, they are the same to the last
  // bit.
  const int k = weight == NormalWeight::Area ? 0 : corner;
  const RowVector3d position = points.row(triangle(k));
  const RowVector3d next = points.row(triangle((k + 1) % 3)) - position;
  const RowVector3d last = points.row(triangle((k + 2) % 3)) - position;
  const RowVector3d across = next.cross(last);
  switch (weight)
  {
    case NormalWeight::Angle:
    {
      const RowVector3d first = points.row(triangle(1)) - points.row(triangle(0));
      const RowVector3d second = points.row(triangle(2)) - points.row(triangle(0));
      return std::atan2(across.norm(), next.dot(last)) * first.cross(second).stableNormalized();
    }
    case NormalWeight::Max:
    {
      const double lengths = next.squaredNorm() * last.squaredNorm();
      return lengths > 0.0 ? RowVector3d(across / lengths) : RowVector3d(RowVector3d::Zero());
    }
    default:
      return across;
  }
}

struct KeptVertexNormals
{
  Eigen::MatrixXd ByAngle;
};

/// Computes normals of points, areas around them and their rings on demand.
class Neighbourhoods
{
public:
  Neighbourhoods(const Mesh& surface, const TriangleFans& fans)
    : Surface(surface)
    , Fans(fans)
  {
  }

  /// The sum of the area vectors of the triangles around a point, twice.
  const RowVector3d& AreaVector(int point)
  {
    const auto [position, isNew] = this->Vectors.try_emplace(point, RowVector3d::Zero());
    if (isNew)
    {
      for (int i = this->Fans.First[point]; i < this->Fans.First[point + 1]; ++i)
      {
        position->second += WeightedNormal(this->Surface.Points,
          this->Surface.Triangles.row(this->Fans.Triangles[i]), 0, NormalWeight::Area);
      }
    }
    return position->second;
  }

  /// The points around one, itself included, sorted: at least two rings. If triangles near it are
  /// thin, more rings, until one is at two edge lengths of equilateral triangles of the same area.
  std::vector<int> Around(int point)
  {
    constexpr int maximum = 5; // rings
    // Edge lengths: the points must reach the first, and those beyond the second are left out.
    constexpr double reach = 2.0, limit = 2.5;
    std::vector<int> found = this->Widened(this->Widened({ point }));
    double areas = 0.0, weighted = 0.0;
    for (const int near : found)
    {
      const double area = this->AreaVector(near).norm() / this->Valence(near);
      areas += area;
      weighted += area * std::sqrt(2.0 / std::sqrt(3.0) * area); // of an even triangle's side
    }
    const double side = areas > 0.0 ? weighted / areas : 0.0;
    const auto distance = [&](int near)
    { return (this->Surface.Points.row(near) - this->Surface.Points.row(point)).norm(); };
    for (int ring = 2; ring < maximum &&
         std::none_of(
           found.begin(), found.end(), [&](int near) { return distance(near) >= reach * side; });
         ++ring)
    {
      found = this->Widened(found);
    }
    std::vector<int> near;
    std::copy_if(found.begin(), found.end(), std::back_inserter(near),
      [&](int other) { return distance(other) <= limit * side; });
    return near;
  }

private:
  /// Points and those that triangles join to them.
  std::vector<int> Widened(const std::vector<int>& points) const
  {
    std::vector<int> more = points;
    for (const int near : points)
    {
      for (int i = this->Fans.First[near]; i < this->Fans.First[near + 1]; ++i)
      {
        const auto corners = this->Surface.Triangles.row(this->Fans.Triangles[i]);
        more.insert(more.end(), corners.begin(), corners.end());
      }
    }
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    return more;
  }

  int Valence(int point) const
  {
    return std::max(1, this->Fans.First[point + 1] - this->Fans.First[point]);
  }

  const Mesh& Surface;
  const TriangleFans& Fans;
  std::map<int, RowVector3d> Vectors;
};

/// A normal on the boundary: that of a paraboloid fitted to the points around (Cazals and Pouget
/// 2005).
RowVector3d LoopNormal(const Mesh& surface, Neighbourhoods& around, int point)
{
  const RowVector3d mean = around.AreaVector(point).stableNormalized();
  std::vector<int> ring;
  constexpr double facing = 0.3; // cosine
  for (const int near : around.Around(point))
  {
    if (around.AreaVector(near).stableNormalized().dot(mean) > facing)
    {
      ring.push_back(near);
    }
  }
  // A paraboloid has six coefficients.
  constexpr std::size_t few = 7;
  if (ring.size() < few)
  {
    return mean;
  }
  Eigen::MatrixXd ways(ring.size(), 3);
  Eigen::VectorXd areas(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    ways.row(row) = surface.Points.row(ring[i]) - surface.Points.row(point);
    areas(row) = around.AreaVector(ring[i]).norm();
  }
  areas = areas.cwiseMax(1e-3 * areas.mean()) / areas.mean();
  RowVector3d normal = mean;
  // The paraboloid is fitted as a graph over the tangent plane, which the fit itself improves.
  for (int round = 0; round < 3; ++round)
  {
    Eigen::Matrix3d frame; // columns
    frame.col(2) = normal;
    frame.col(0) = normal.unitOrthogonal();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    const Eigen::RowVector2d slopes = FitSlopesOfParaboloid(ways * frame, areas);
    normal = (normal - slopes * frame.leftCols<2>().transpose()).normalized();
  }
  constexpr double turned = 0.5; // cosine
  return normal.dot(mean) > turned ? normal : mean;
}

/// The mean around a node, its own normal included; not yet of unit length.
RowVector3d MeanAround(const PointGraph& graph, const Eigen::MatrixXd& normals, int node)
{
  const int begin = graph.First[node], end = graph.First[node + 1];
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = begin; k < end; ++k)
  {
    nearest = graph.Lengths[k] > 0.0 ? std::min(nearest, graph.Lengths[k]) : nearest;
  }
  RowVector3d mean = normals.row(node);
  for (int k = begin; k < end; ++k)
  {
    mean += std::min(1.0, nearest / graph.Lengths[k]) * normals.row(graph.Neighbours[k]);
  }
  return mean;
}

/// Gives nodes without a normal that of their neighbours, spreading from nodes that have one.
void FillNormals(const PointGraph& graph, Eigen::MatrixXd& normals)
{
  std::vector<int> without;
  for (int i = 0; i < graph.Size(); ++i)
  {
    if (normals.row(i).isZero(0.0))
    {
      without.push_back(i);
    }
  }
  // From nodes with a normal outwards, a ring of nodes in each round.
  while (!without.empty())
  {
    Eigen::MatrixXd found(static_cast<Eigen::Index>(without.size()), 3);
    bool any = false;
    for (std::size_t k = 0; k < without.size(); ++k)
    {
      const RowVector3d mean = MeanAround(graph, normals, without[k]);
      found.row(static_cast<Eigen::Index>(k)) = mean.normalized();
      any = any || !mean.isZero(0.0);
    }
    std::vector<int> left;
    for (std::size_t k = 0; k < without.size(); ++k)
    {
      const auto row = found.row(static_cast<Eigen::Index>(k));
      normals.row(without[k]) = any ? RowVector3d(row) : RowVector3d::UnitZ();
      if (any && row.isZero(0.0))
      {
        left.push_back(without[k]);
      }
    }
    without.swap(left);
  }
}

} // namespace

Eigen::MatrixXd ComputeVertexNormals(const Mesh& surface, NormalWeight weight)
{
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(surface.Points.rows(), 3);
  for (const auto& triangle : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      normals.row(triangle(k)) += WeightedNormal(surface.Points, triangle, k, weight);
    }
  }
  for (auto normal : normals.rowwise())
  {
    // Angles can be so small, and Max's weights so large, that squares under- or overflow.
    if (weight == NormalWeight::Area)
    {
      normal.normalize();
    }
    else
    {
      normal.stableNormalize();
    }
  }
  return normals;
}

const Eigen::MatrixXd& GetVertexNormals(const Surface& surface)
{
  return surface
    .Cached<KeptVertexNormals>(
      [&]() { return KeptVertexNormals{ ComputeVertexNormals(surface, NormalWeight::Angle) }; })
    ->ByAngle;
}

Eigen::MatrixXd ComputeVertexNormals(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& triangles, const TriangleFans& fans, const std::vector<int>& vertices,
  NormalWeight weight)
{
  Eigen::MatrixXd normals(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    RowVector3d sum = RowVector3d::Zero();
    for (int j = fans.First[vertices[i]]; j < fans.First[vertices[i] + 1]; ++j)
    {
      const Eigen::RowVector3i triangle = triangles.row(fans.Triangles[j]);
      int corner = 0;
      while (triangle(corner) != vertices[i])
      {
        ++corner;
      }
      sum += WeightedNormal(points, triangle, corner, weight);
    }
    normals.row(static_cast<Eigen::Index>(i)) = sum.stableNormalized();
  }
  return normals;
}

Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& vertices)
{
  Neighbourhoods around(surface, fans);
  Eigen::MatrixXd normals(vertices.size(), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    normals.row(static_cast<Eigen::Index>(i)) = LoopNormal(surface, around, vertices[i]);
  }
  return normals;
}

Eigen::MatrixXd SmoothNormals(
  const PointGraph& graph, Eigen::MatrixXd normals, int rounds, const Progress& progress)
{
  FillNormals(graph, normals);
  for (int round = 0; round < rounds; ++round)
  {
    progress((1.0 + round) / (1.0 + rounds));
    Eigen::MatrixXd smoothed(normals.rows(), 3);
    for (int i = 0; i < graph.Size(); ++i)
    {
      const RowVector3d mean = MeanAround(graph, normals, i);
      const double length = mean.norm();
      smoothed.row(i) = length > 0.0 ? RowVector3d(mean / length) : RowVector3d(normals.row(i));
    }
    normals.swap(smoothed);
  }
  return normals;
}

} // namespace shape
