#pragma once

#include "Base/Progress.h"
#include "Mesh/Graph.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// The elements of a shape, with common points. The shape may be a curve network, a surface or soup
/// of triangles, a solid of tetrahedra, a mix of these, or points alone.
struct ShapeElements
{
  Eigen::MatrixXd Points;     ///< n x 3
  Eigen::MatrixXi Lines;      ///< l x 2
  Eigen::MatrixXi Triangles;  ///< m x 3
  Eigen::MatrixXi Tetrahedra; ///< t x 4
};

struct PointGraphOptions
{
  int Nearest = 8; ///< number of nearest points to which a point without elements is linked
};

/**
 * The graph of a shape's points, for propagation over shapes of any kind: curves, surfaces, solids,
 * soups and point sets, manifold or not.
 *
 * The nodes are the points of the shape, with coincident points welded (FindPointsWithinTolerance).
 */
struct PointGraph : Graph
{
  Eigen::MatrixXd Points;    ///< all points of the shape, before welding
  Eigen::MatrixXd Positions; ///< n x 3
  /// n values: how much of the shape a node represents (equation 8 of Schmidt and Singh,
  /// "Drag-and-drop surface composition"), so that dense regions do not dominate. A weight is the
  /// area of the triangles, the volume of the tetrahedra or the length of the lines around the
  /// node. Volumes are divided, and lengths multiplied, by the mean length of a link, so every
  /// weight is an area. The weight of a node without elements is the squared distance to its
  /// nearest neighbour. A weight is 0 if all elements of the node are degenerate.
  Eigen::VectorXd Weights;
  /// n values: the absolute Gaussian curvature at each node. It is the angle defect of the
  /// triangles around the node, divided by a third of their area; 0 on boundaries and at
  /// non-manifold nodes, where it is undefined.
  Eigen::VectorXd Curvatures;
  Eigen::MatrixXd Normals;  ///< n x 3: the unit normal at each node; a zero row if it has none
  Eigen::VectorXi NodeOf;   ///< for each point of the shape, its node
  std::vector<int> PointOf; ///< n: the first point of each node
  double MeanLength = 0.0;  ///< see ComputeMeanLinkLength

  /// Returns the number of nodes, even before they are linked.
  int Size() const { return static_cast<int>(this->Positions.rows()); }
};

/// Builds the graph of a shape. Throws InvalidInput if there is no point, a coordinate is not
/// finite, or an element has a point out of range. The longest edge of the bounding box must be 0
/// or between 1e-50 and 1e50. Throws Aborted.
PointGraph BuildPointGraph(
  const ShapeElements& shape, const PointGraphOptions& options = {}, const Progress& progress = {});

/// Builds the graph of a surface.
PointGraph BuildPointGraph(const Mesh& surface, const PointGraphOptions& options = {});

/// Replaces the links of a graph. links: pairs of different nodes, in any order, possibly with
/// repeats. The length of a link is the distance between its nodes.
void SetLinks(PointGraph& graph, std::vector<std::pair<int, int>> links);

/// Returns the mean length of the links, weighted by the nodes' weights; 0 if there are none.
double ComputeMeanLinkLength(const PointGraph& graph);

/// Returns the links of a graph without repeats. Each link has its lower node first, and the links
/// are sorted.
std::vector<std::pair<int, int>> ListLinks(const PointGraph& graph);

} // namespace shape
