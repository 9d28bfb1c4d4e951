#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

namespace benchmark
{

/**
 * Returns the maximum, over all hexahedral meshes, of the minimum scaled Jacobian at the corners of
 * a surface; 1 without corners. Each corner is treated separately.
 *
 * All creases must be convex and consist of edges of the mesh, and at most one edge may lead
 * inwards from a corner. Then there is either one hexahedron for each patch around that edge, or
 * every hexahedron has three edges on the surface. Patches wider than 90 degrees may have two
 * quads.
 *
 * Let d_i be the unit vectors along the edges on the surface, clockwise seen from outside, and a
 * the inward edge. A hexahedron has the scaled Jacobian (d_i x d_i+1) . a at the corner. The best a
 * points to the point of the convex hull of the d_i x d_i+1 that is nearest to 0. The minimum
 * product is then the length of that point.
 */
double CornerBound(const shape::Mesh& surface, const shape::SurfaceFeatures& features);

} // namespace benchmark
