#pragma once

#include "Base/Progress.h"
#include "Mesh/Graph.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// The elements of a shape, over common points: a curve network, a surface or soup of triangles, a
/// solid of tetrahedra, any mix of them, or points alone.
struct ShapeElements
{
  Eigen::MatrixXd Points;     ///< n x 3
  Eigen::MatrixXi Lines;      ///< l x 2
  Eigen::MatrixXi Triangles;  ///< m x 3
  Eigen::MatrixXi Tetrahedra; ///< t x 4
};

struct PointGraphOptions
{
  int Nearest = 8; ///< number of neighbours of a point that no element connects to another
};

/**
 * The graph of a shape's points, for propagation over shapes of any kind: curves, surfaces, solids,
 * soups and point sets, manifold or not.
 *
 * Nodes are the points; coincident ones are welded (FindPointsWithinTolerance).
 */
struct PointGraph : Graph
{
  Eigen::MatrixXd Points;    ///< all points of the shape, before welding
  Eigen::MatrixXd Positions; ///< n x 3
  /// n: how much of the shape a node represents (equation 8 of Schmidt and Singh, "Drag-and-drop
  /// surface composition"), so that dense regions do not dominate. It is the area of the triangles,
  /// volume of the tetrahedra or length of the lines around the node; if there are none, the
  /// squared distance of its nearest neighbour. 0 if all its elements are degenerate.
  Eigen::VectorXd Weights;
  /// n: the absolute Gaussian curvature: the angle defect of the triangles around each node over a
  /// third of their area. 0 where it is undefined (boundaries, non-manifold nodes).
  Eigen::VectorXd Curvatures;
  Eigen::MatrixXd Normals;  ///< n x 3: unit normals of the triangles around each node, or 0
  Eigen::VectorXi NodeOf;   ///< for each point of the shape, its node
  std::vector<int> PointOf; ///< n: the first point of each node
  double MeanLength = 0.0;  ///< ComputeMeanLinkLength

  /// Nodes, also before they are linked.
  int Size() const { return static_cast<int>(this->Positions.rows()); }
};

/// Builds the graph of a shape. Throws InvalidInput if there is no point, a coordinate is not
/// finite, or an element has a point out of range. The longest edge of the bounding box must be 0
/// or between 1e-50 and 1e50. Throws Aborted.
PointGraph BuildPointGraph(
  const ShapeElements& shape, const PointGraphOptions& options = {}, const Progress& progress = {});

/// Builds the graph of a surface.
PointGraph BuildPointGraph(const Mesh& surface, const PointGraphOptions& options = {});

/// Replaces the links of a graph by these pairs of different nodes, in any order, possibly with
/// repeats. Lengths are the straight distances.
void SetLinks(PointGraph& graph, std::vector<std::pair<int, int>> links);

/// Returns the mean length of the links, weighted by the nodes' weights; 0 if there are none.
double ComputeMeanLinkLength(const PointGraph& graph);

/// Returns the links of a graph without repeats, the lower node first, in ascending order.
std::vector<std::pair<int, int>> ListLinks(const PointGraph& graph);

} // namespace shape
