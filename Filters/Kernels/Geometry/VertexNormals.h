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
/// Returns unit normals of a surface at all vertices (n x 3), or at some (k x 3), given the fans of
/// its triangles. A normal is zero if no triangle around the vertex has an area.
Eigen::MatrixXd ComputeVertexNormals(const Mesh& surface, NormalWeight weight);
Eigen::MatrixXd ComputeVertexNormals(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& triangles, const TriangleFans& fans, const std::vector<int>& vertices,
  NormalWeight weight);
///@}

/// Returns the normals of a surface weighted by angle (n x 3), which are computed once and cached
/// in the surface: valid as long as the surface or a copy of it.
const Eigen::MatrixXd& GetVertexNormals(const Surface& surface);

/**
 * Returns unit normals at vertices on a surface's boundary (k x 3), where the mean of the
 * triangles' normals would be biased towards the inside.
 *
 * A paraboloid is fitted to the two rings of vertices around each, weighted by the area around them
 * (Cazals and Pouget, "Estimating differential quantities using polynomial fitting of osculating
 * jets", 2005). Vertices of triangles that face the other way are ignored. If there are too few
 * vertices, or if the paraboloid turns the normal by more than 60 degrees, the result is the normal
 * weighted by area; zero if the triangles have no area.
 *
 * Exact for planes; of third order in the edge length for spheres. fans: those of the surface's
 * triangles.
 */
Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& vertices);

/**
 * Smooths unit normals at the nodes of a graph (n x 3). Each round replaces a normal by the
 * weighted mean of itself and those of its neighbours. The weights are inverse distances; the node
 * itself has the weight of its nearest neighbour.
 *
 * First, a node whose normal is zero gets the mean of its neighbours' normals, or (0, 0, 1) if no
 * node connected to it has one. Throws Aborted.
 */
Eigen::MatrixXd SmoothNormals(
  const PointGraph& graph, Eigen::MatrixXd normals, int rounds, const Progress& progress = {});

} // namespace shape
