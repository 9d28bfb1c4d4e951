#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// The topology of a mesh. Points that no triangle uses are ignored.
struct Topology
{
  int EulerNumber = 0;        ///< points - edges + triangles
  int Components = 0;         ///< triangles that share a point are connected
  int BoundaryLoops = 0;      ///< number of chains of edges that belong to only one triangle
  int FirstOpenPoint = -1;    ///< a point of the first boundary loop, or -1
  int NonManifoldEdges = 0;   ///< number of edges with three or more triangles
  int FirstNonManifold = -1;  ///< a point of the first non-manifold edge, or -1
  int NonManifoldPoints = 0;  ///< number of points where two fans of triangles touch
  int FirstPinchedPoint = -1; ///< the first of these points, or -1
  int MisorientedEdges = 0;   ///< number of edges with the same direction in both triangles
  int FirstMisoriented = -1;  ///< a point of the first of these edges, or -1
  /// For each point, the number of its component; -1 at unused points. Components are numbered 0,
  /// 1, ... in the order of their first points.
  Eigen::VectorXi ComponentId;
};

/// Throws InvalidInput if an index of a triangle is out of range.
void RequireIndices(const Mesh& mesh);

/// Computes the topology. Throws InvalidInput if an index is out of range or a triangle uses a
/// point twice.
Topology ComputeTopology(const Mesh& mesh);

/// The same, for a mesh whose indices are in range. sorted: its half-edges (SortHalfEdges).
Topology ComputeTopology(const Mesh& mesh, const std::vector<HalfEdge>& sorted);

/// Throws InvalidInput if `values` (one row for each point) contains a NaN or an infinity. Message:
/// "`name` has 3 points with a value that is not finite (first at point 17); ...".
void RequireFinite(const Eigen::MatrixXd& values, const std::string& name);

} // namespace shape
