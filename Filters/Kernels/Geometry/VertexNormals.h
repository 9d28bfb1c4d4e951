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

/// By what the normals of the triangles around a vertex are weighted.
enum class NormalWeight
{
  Area,  ///< of the triangle
  Angle, ///< at the vertex: independent of how planar faces are triangulated
  Max    ///< the sine of that angle over the lengths of its edges (Max, "Weights for computing
      ///< vertex normals from facet normals", 1999): exact inside a surface whose vertices lie on
      ///< a sphere, whatever the triangles
};

///@{
/// Unit normals of a surface at all vertices (n x 3), or at some (k x 3), given the fans of its
/// triangles. Zero where no triangle has an area.
Eigen::MatrixXd ComputeVertexNormals(const Mesh& surface, NormalWeight weight);
Eigen::MatrixXd ComputeVertexNormals(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& triangles, const TriangleFans& fans, const std::vector<int>& vertices,
  NormalWeight weight);
///@}

/// A surface's normals by angle (n x 3), computed once and kept with it: valid as long as the
/// surface or a copy of it.
const Eigen::MatrixXd& GetVertexNormals(const Surface& surface);

/**
 * Unit normals of a surface at vertices on its boundary (k x 3), where a mean of the triangles'
 * normals would be the normal at a position inside. A paraboloid is fitted to the two rings of
 * vertices around each, weighted by the area around them (Cazals and Pouget, "Estimating
 * differential quantities using polynomial fitting of osculating jets", 2005), without those of
 * triangles that face the other way. If there are too few of them, or if the paraboloid turns the
 * normal by more than 60 degrees, the result is the normal weighted by area; zero if the triangles
 * have no area.
 *
 * Exact for planes; of third order in the edge length for spheres. fans: of the surface's
 * triangles.
 */
Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& vertices);

/**
 * Smooths unit normals at the nodes of a graph (n x 3): each round replaces a normal by the mean of
 * itself and those of its neighbours. Neighbours are weighted by their inverse distances; the
 * node's own normal counts as much as the nearest neighbour's.
 *
 * First, a node whose normal is zero gets the mean of its neighbours', or (0, 0, 1) if no node
 * connected to it has one. Throws Aborted.
 */
Eigen::MatrixXd SmoothNormals(
  const PointGraph& graph, Eigen::MatrixXd normals, int rounds, const Progress& progress = {});

} // namespace shape
