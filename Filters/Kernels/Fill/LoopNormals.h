#pragma once

#include "Mesh/Mesh.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Unit normals of a surface at points of its border (k x 3), where the mean of the triangles'
 * normals would be that of a place inside: a paraboloid is fitted to the two rings of points around
 * each, which count by the area around them (Cazals and Pouget, "Estimating differential quantities
 * using polynomial fitting of osculating jets", 2005), those of triangles that face the other way
 * left out. Where there are too
 * few of them, or the paraboloid turns the normal by more than 60 degrees, it is the mean of the
 * normals of the triangles around, by area; where they have none, zero.
 *
 * Exact for planes; of third order in the edge length for spheres. fans: of the surface's
 * triangles.
 */
Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& points);

} // namespace shape
