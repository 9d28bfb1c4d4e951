#include "Geometry/PointGraph.h"

#include "Base/Errors.h"
#include "Geometry/SurfaceWelding.h"
#include "Mesh/Extent.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace shape
{
namespace
{

void RequireCorners(const Eigen::MatrixXi& elements, Eigen::Index points)
{
  if (elements.size() > 0 && (elements.minCoeff() < 0 || elements.maxCoeff() >= points))
  {
    const int wrong = elements.minCoeff() < 0 ? elements.minCoeff() : elements.maxCoeff();
    throw InvalidInput("an element of the shape uses point " + std::to_string(wrong) +
      ", but there are " + std::to_string(points) + " points; repair the connectivity");
  }
}

void Weld(const Eigen::MatrixXd& points, PointGraph& graph, const Progress& progress)
{
  const std::vector<int> first = FindPointsWithinTolerance(points, progress);
  graph.NodeOf.resize(points.rows());
  for (int i = 0; i < static_cast<int>(first.size()); ++i)
  {
    const bool isNew = first[i] == i;
    graph.NodeOf(i) = isNew ? static_cast<int>(graph.PointOf.size()) : graph.NodeOf(first[i]);
    if (isNew)
    {
      graph.PointOf.push_back(i);
    }
  }
  graph.Positions = points(graph.PointOf, Eigen::all);
}

Eigen::MatrixXi NodesOf(const Eigen::MatrixXi& elements, const Eigen::VectorXi& nodeOf)
{
  return elements.unaryExpr([&](int point) { return nodeOf(point); });
}

/// Links every two nodes of an element.
void AddLinks(const Eigen::MatrixXi& elements, std::vector<std::pair<int, int>>& links)
{
  for (const auto& element : elements.rowwise())
  {
    for (Eigen::Index a = 0; a < element.size(); ++a)
    {
      for (Eigen::Index b = a + 1; b < element.size(); ++b)
      {
        if (element(a) != element(b))
        {
          links.emplace_back(element(a), element(b));
        }
      }
    }
  }
}

/// Nodes without a link are linked with their nearest ones.
void LinkLoosePoints(const PointGraph& graph, int nearest, std::vector<std::pair<int, int>>& links,
  const Progress& progress)
{
  std::vector<char> linked(graph.Size(), 0);
  for (const auto& [a, b] : links)
  {
    linked[a] = linked[b] = 1;
  }
  if (std::find(linked.begin(), linked.end(), 0) == linked.end())
  {
    return;
  }
  const PointTree tree(graph.Positions);
  for (int i = 0; i < graph.Size(); ++i)
  {
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / graph.Size());
    }
    if (!linked[i])
    {
      for (const int j : tree.Nearest(graph.Positions.row(i), nearest + 1))
      {
        if (j != i)
        {
          links.emplace_back(i, j);
        }
      }
    }
  }
}

/// All weights have the unit of an area: lengths are multiplied, and volumes divided, by the mean
/// length of a link.
void AddWeights(PointGraph& graph, const Eigen::MatrixXi& lines, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXi& tetrahedra)
{
  const double length = std::accumulate(graph.Lengths.begin(), graph.Lengths.end(), 0.0) /
    std::max<double>(1.0, static_cast<double>(graph.Lengths.size()));
  std::vector<char> used(graph.Size(), 0);
  // Eq. 8 of Schmidt and Singh 2010, extended to lines, tetrahedra and loose points.
  graph.Weights = Eigen::VectorXd::Zero(graph.Size());
  const auto add = [&](const auto& corners, double amount)
  {
    for (const int node : corners)
    {
      graph.Weights(node) += amount;
      used[node] = 1;
    }
  };
  const auto side = [&](const auto& corners, int k) -> Eigen::Vector3d
  { return (graph.Positions.row(corners(k)) - graph.Positions.row(corners(0))).transpose(); };
  for (const auto& line : lines.rowwise())
  {
    add(line, side(line, 1).norm() * length);
  }
  graph.Normals = Eigen::MatrixXd::Zero(graph.Size(), 3);
  for (const auto& triangle : triangles.rowwise())
  {
    const Eigen::Vector3d vector = 0.5 * side(triangle, 1).cross(side(triangle, 2));
    add(triangle, vector.norm());
    for (const int node : triangle)
    {
      graph.Normals.row(node) += vector.transpose();
    }
  }
  for (const auto& tetrahedron : tetrahedra.rowwise())
  {
    const double volume =
      side(tetrahedron, 1).cross(side(tetrahedron, 2)).dot(side(tetrahedron, 3)) / 6.0;
    add(tetrahedron, length > 0.0 ? std::abs(volume) / length : 0.0);
  }
  for (int i = 0; i < graph.Size(); ++i)
  {
    const double norm = graph.Normals.row(i).norm();
    graph.Normals.row(i) /= norm > 0.0 ? norm : 1.0;
    if (!used[i] && graph.First[i] < graph.First[i + 1])
    {
      const double nearest = *std::min_element(
        graph.Lengths.begin() + graph.First[i], graph.Lengths.begin() + graph.First[i + 1]);
      graph.Weights(i) = nearest * nearest;
    }
  }
}

/// The angle at a corner with these sides; 0 in a degenerate triangle.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void AddCurvatures(PointGraph& graph, const Eigen::MatrixXi& triangles)
{
  // The angle defect 2 pi - sum of the angles is the integral of the Gaussian curvature around a
  // node.
  Eigen::VectorXd defects = Eigen::VectorXd::Constant(graph.Size(), 2.0 * M_PI);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(graph.Size());
  std::vector<char> inside(graph.Size(), 0);
  for (const auto& triangle : triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d corner = graph.Positions.row(triangle(k)).transpose();
      const Eigen::Vector3d a = graph.Positions.row(triangle((k + 1) % 3)).transpose() - corner;
      const Eigen::Vector3d b = graph.Positions.row(triangle((k + 2) % 3)).transpose() - corner;
      defects(triangle(k)) -= AngleBetween(a, b);
      areas(triangle(k)) += a.cross(b).norm() / 6.0;
      inside[triangle(k)] = 1;
    }
  }
  const std::vector<HalfEdge> sides = SortHalfEdges(triangles, graph.Size());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Low() == sides[begin].Low() &&
      sides[end].High() == sides[begin].High())
    {
      ++end;
    }
    if (end - begin != 2)
    {
      inside[sides[begin].Low()] = inside[sides[begin].High()] = 0;
    }
  }
  graph.Curvatures = Eigen::VectorXd::Zero(graph.Size());
  for (int i = 0; i < graph.Size(); ++i)
  {
    if (inside[i] && areas(i) > 0.0)
    {
      graph.Curvatures(i) = std::abs(defects(i)) / areas(i);
    }
  }
}

/// Returns the triangles with three different nodes.
Eigen::MatrixXi Unwelded(const Eigen::MatrixXi& triangles)
{
  std::vector<int> kept;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const auto corners = triangles.row(t);
    if (corners(0) != corners(1) && corners(1) != corners(2) && corners(2) != corners(0))
    {
      kept.push_back(static_cast<int>(t));
    }
  }
  return triangles(kept, Eigen::all);
}

} // namespace

void SetLinks(PointGraph& graph, std::vector<std::pair<int, int>> links)
{
  static_cast<Graph&>(graph) = BuildGraph(graph.Positions, std::move(links));
}

std::vector<std::pair<int, int>> ListLinks(const PointGraph& graph)
{
  std::vector<std::pair<int, int>> links;
  links.reserve(graph.Neighbours.size() / 2);
  for (int i = 0; i < graph.Size(); ++i)
  {
    for (int k = graph.First[i]; k < graph.First[i + 1]; ++k)
    {
      if (i < graph.Neighbours[k])
      {
        links.emplace_back(i, graph.Neighbours[k]);
      }
    }
  }
  return links;
}

double ComputeMeanLinkLength(const PointGraph& graph)
{
  double sum = 0.0, weights = 0.0, plain = 0.0;
  for (int i = 0; i < graph.Size(); ++i)
  {
    const int count = graph.First[i + 1] - graph.First[i];
    for (int k = graph.First[i]; k < graph.First[i + 1]; ++k)
    {
      sum += graph.Weights(i) * graph.Lengths[k] / count;
      plain += graph.Lengths[k];
    }
    weights += count > 0 ? graph.Weights(i) : 0.0;
  }
  const double links = std::max<double>(1.0, static_cast<double>(graph.Lengths.size()));
  return weights > 0.0 ? sum / weights : plain / links;
}

PointGraph BuildPointGraph(
  const ShapeElements& shape, const PointGraphOptions& options, const Progress& progress)
{
  if (shape.Points.rows() == 0)
  {
    throw InvalidInput("the shape has no points; give a shape with points");
  }
  RequireFinite(shape.Points, "the shape");
  RequireExtent(shape.Points, "the shape");
  for (const Eigen::MatrixXi* elements : { &shape.Lines, &shape.Triangles, &shape.Tetrahedra })
  {
    RequireCorners(*elements, shape.Points.rows());
  }
  progress(0.0);
  PointGraph graph;
  graph.Points = shape.Points;
  Weld(shape.Points, graph, progress.Part(0.0, 0.5));
  const Eigen::MatrixXi lines = NodesOf(shape.Lines, graph.NodeOf);
  const Eigen::MatrixXi triangles = NodesOf(shape.Triangles, graph.NodeOf);
  const Eigen::MatrixXi tetrahedra = NodesOf(shape.Tetrahedra, graph.NodeOf);
  std::vector<std::pair<int, int>> links;
  for (const Eigen::MatrixXi* elements : { &lines, &triangles, &tetrahedra })
  {
    AddLinks(*elements, links);
  }
  LinkLoosePoints(graph, options.Nearest, links, progress.Part(0.5, 0.9));
  SetLinks(graph, std::move(links));
  AddWeights(graph, lines, triangles, tetrahedra);
  AddCurvatures(graph, Unwelded(triangles));
  graph.MeanLength = ComputeMeanLinkLength(graph);
  progress(1.0);
  return graph;
}

PointGraph BuildPointGraph(const Mesh& surface, const PointGraphOptions& options)
{
  return BuildPointGraph(ShapeElements{ surface.Points, {}, surface.Triangles, {} }, options);
}

} // namespace shape
