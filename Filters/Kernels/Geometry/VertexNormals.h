#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The weights of the normals of the triangles around a vertex.
enum class NormalWeight
{
  Area,  ///< the area of the triangle
  Angle, ///< the angle at the vertex: independent of how planar faces are triangulated
  Max    ///< the sine of that angle over the product of its edges' lengths (Max, "Weights for
         ///< computing vertex normals from facet normals", 1999): exact for any triangles whose
         ///< vertices lie on a sphere, except on the boundary
};

///@{
/// Returns unit normals of a surface at all vertices (n x 3), or at the given `vertices` (k x 3).
/// fans: the fans of the surface's triangles. A normal is zero if no triangle around the vertex has
/// an area.
Eigen::MatrixXd ComputeVertexNormals(const Mesh& surface, NormalWeight weight);
Eigen::MatrixXd ComputeVertexNormals(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& triangles, const TriangleFans& fans, const std::vector<int>& vertices,
  NormalWeight weight);
///@}

/// Returns the vertex normals of a surface (n x 3), weighted by angle (NormalWeight::Angle). They
/// are computed once and cached in the surface. The reference is valid as long as the surface or a
/// copy of it exists.
const Eigen::MatrixXd& GetVertexNormals(const Surface& surface);

/**
 * Returns unit normals at vertices on a surface's boundary (k x 3), where the mean of the
 * triangles' normals would be biased towards the inside.
 *
 * A paraboloid is fitted to the two rings of vertices around each vertex, weighted by the area
 * around them (Cazals and Pouget, "Estimating differential quantities using polynomial fitting of
 * osculating jets", 2005). Vertices whose normals (weighted by area) differ from the normal of the
 * fitted vertex by more than 73 degrees are ignored. If there are too few vertices, or if the
 * paraboloid turns the normal by more than 60 degrees, the result is the normal weighted by area.
 * It is zero if the triangles have no area.
 *
 * The normals are exact on planes. On spheres their error is of third order in the edge length.
 * fans: the fans of the surface's triangles.
 */
Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& vertices);

/**
 * Smooths unit normals at the nodes of a graph (n x 3). Each round replaces a normal by the
 * weighted mean of itself and the normals of the neighbours. A neighbour's weight is its inverse
 * distance; the node itself has the weight of its nearest neighbour.
 *
 * First, a node whose normal is zero gets the mean of its neighbours' normals, or (0, 0, 1) if no
 * node connected to it has one. Throws Aborted.
 */
Eigen::MatrixXd SmoothNormals(
  const PointGraph& graph, Eigen::MatrixXd normals, int rounds, const Progress& progress = {});

} // namespace shape
