#include "Geometry/VertexNormals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <vector>

namespace shape
{

using Eigen::RowVector3d;

namespace
{

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

/// Gives nodes without a normal that of their neighbours, from those that have one outwards.
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

Eigen::MatrixXd ComputeMaxNormals(const Mesh& surface)
{
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(surface.Points.rows(), 3);
  for (const auto& triangle : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const RowVector3d position = surface.Points.row(triangle(k));
      const RowVector3d next = surface.Points.row(triangle((k + 1) % 3)) - position;
      const RowVector3d last = surface.Points.row(triangle((k + 2) % 3)) - position;
      const double lengths = next.squaredNorm() * last.squaredNorm();
      if (lengths > 0.0)
      {
        normals.row(triangle(k)) += next.cross(last) / lengths;
      }
    }
  }
  for (auto normal : normals.rowwise())
  {
    normal.stableNormalize();
  }
  return normals;
}

Eigen::MatrixXd ComputeAreaWeightedNormals(const Surface& surface)
{
  const Eigen::MatrixXd& vectors = surface.AreaVectors();
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(surface.Points().rows(), 3);
  for (Eigen::Index t = 0; t < vectors.rows(); ++t)
  {
    for (const int corner : surface.Triangles().row(t))
    {
      normals.row(corner) += vectors.row(t);
    }
  }
  normals.rowwise().normalize(); // leaves zero as it is
  return normals;
}

Eigen::MatrixXd SmoothNormals(
  const PointGraph& graph, const Eigen::MatrixXi& triangles, int rounds, const Progress& progress)
{
  Eigen::MatrixXd normals = ComputePointNormals({ graph.Positions, triangles });
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

RowVector3d EvaluateCurvedTriangle(
  const Eigen::Matrix3d& corners, const Eigen::Matrix3d& normals, const RowVector3d& barycentric)
{
  RowVector3d position = RowVector3d::Zero();
  // The control points beside the corners, and by their mean the one in the middle.
  RowVector3d middle = -0.5 * corners.colwise().mean();
  for (int i = 0; i < 3; ++i)
  {
    const RowVector3d corner = corners.row(i), normal = normals.row(i);
    const double u = barycentric(i);
    position += u * u * u * corner;
    for (const int j : { (i + 1) % 3, (i + 2) % 3 })
    {
      const RowVector3d way = corners.row(j) - corner;
      const RowVector3d control = corner + (way - way.dot(normal) * normal) / 3.0;
      position += 3.0 * u * u * barycentric(j) * control;
      middle += 0.25 * control;
    }
  }
  return position + 6.0 * barycentric.prod() * middle;
}

} // namespace shape
