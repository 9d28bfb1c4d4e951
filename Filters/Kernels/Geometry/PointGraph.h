#pragma once

#include "Base/Progress.h"
#include "Mesh/Graph.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// What a shape is made of, over common points (n x 3): a curve network, a surface or soup of
/// triangles, a solid of tetrahedra, any mix of them, or points alone.
struct ShapeElements
{
  Eigen::MatrixXd Points;     ///< n x 3
  Eigen::MatrixXi Lines;      ///< l x 2
  Eigen::MatrixXi Triangles;  ///< m x 3
  Eigen::MatrixXi Tetrahedra; ///< t x 4
};

struct PointGraphOptions
{
  int Nearest = 8; ///< neighbours of a point that no element joins to another
};

/**
 * The points of a shape and who is next to whom, for what spreads over shapes of any kind: curves,
 * surfaces, solids, soups and point sets, manifold or not.
 *
 * Nodes are the points, those at one place welded (FindPointsWithinTolerance).
 */
struct PointGraph : Graph
{
  Eigen::MatrixXd Points;    ///< all of the shape, welded or not
  Eigen::MatrixXd Positions; ///< n x 3
  /// n: how much of the shape a node stands for (equation 8 of the paper below), so that a dense
  /// spot counts no more than another: the area of the triangles, volume of the tetrahedra or
  /// length of the lines around it; where there are none, the squared distance of its nearest
  /// neighbour. 0 where all its elements are degenerate. Schmidt and Singh, "Drag-and-drop surface
  /// composition".
  Eigen::VectorXd Weights;
  /// n: the angles of the triangles around each node, less 2 pi, over a third of their area: the
  /// Gaussian curvature but for its sign; 0 where that means nothing (borders, non-manifold nodes).
  Eigen::VectorXd Curvatures;
  Eigen::MatrixXd Normals;  ///< n x 3: unit normals of the triangles around each node, or 0
  Eigen::VectorXi NodeOf;   ///< points: the node of each
  std::vector<int> PointOf; ///< n: the first point of each node
  double MeanLength = 0.0;  ///< ComputeMeanLinkLength

  /// Nodes, also before they are linked.
  int Size() const { return static_cast<int>(this->Positions.rows()); }
};

/// The graph of a shape. Throws InvalidInput where there is no point, a coordinate is not finite,
/// the longest side of their box is neither 0 nor between 1e-50 and 1e50, or an element has a point
/// out of range; Aborted.
PointGraph BuildPointGraph(
  const ShapeElements& shape, const PointGraphOptions& options = {}, const Progress& progress = {});

/// The graph of a surface.
PointGraph BuildPointGraph(const Mesh& surface, const PointGraphOptions& options = {});

/// Replaces the links of a graph by these pairs of different nodes, in any order, some perhaps
/// twice, with the lengths of the straight ways between them.
void SetLinks(PointGraph& graph, std::vector<std::pair<int, int>> links);

/// The mean length of the links, each node's counting by its weight; 0 where there are none.
double ComputeMeanLinkLength(const PointGraph& graph);

/// The links of a graph, each once, the lower node first, in order.
std::vector<std::pair<int, int>> ListLinks(const PointGraph& graph);

} // namespace shape
