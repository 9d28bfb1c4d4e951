#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// What kind of surface a mesh is. Points that no triangle uses do not count.
struct Topology
{
  int EulerNumber = 0;         ///< points - edges + triangles
  int Components = 0;          ///< pieces that share no point
  int BoundaryLoops = 0;       ///< chains of edges with one triangle
  int FirstOpenPoint = -1;     ///< a point of the first of them, or -1
  int NonManifoldEdges = 0;    ///< edges with three or more triangles
  int FirstNonManifold = -1;   ///< a point of the first of them, or -1
  int NonManifoldPoints = 0;   ///< points where two fans of triangles touch
  int FirstPinchedPoint = -1;  ///< the first of them, or -1
  int MisorientedEdges = 0;    ///< edges that both triangles run through in the same sense
  int FirstMisoriented = -1;   ///< a point of the first of them, or -1
  Eigen::VectorXi ComponentId; ///< n: 0, 1, ... in order of the first point; -1 at unused points
};

/// Throws InvalidInput if a triangle has an index out of range.
void RequireIndices(const Mesh& mesh);

/// Throws InvalidInput as RequireIndices does, and if a triangle uses a point twice.
Topology ComputeTopology(const Mesh& mesh);

/// The same of a mesh whose indices are in range, and its SortHalfEdges.
Topology ComputeTopology(const Mesh& mesh, const std::vector<HalfEdge>& sorted);

/// Throws InvalidInput where `values` has a NaN or an infinity: "`name` has 3 values that are not
/// finite (first at point 17)".
void RequireFinite(const Eigen::MatrixXd& values, const std::string& name);

} // namespace shape
