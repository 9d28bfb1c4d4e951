#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

namespace benchmark
{

/**
 * The greatest worst scaled Jacobian that hexahedra can have at the corners of a surface where all
 * creases are convex and chains of their edges, with at most one edge that leads inwards from a
 * corner: there either is one hexahedron for each patch around that edge, or every hexahedron has
 * three edges on the surface. Patches wider than 90 degrees may have two quads. One corner by
 * itself is looked at. 1 without such corners.
 *
 * With unit vectors d_i along the edges on the surface, clockwise seen from outside, and the inward
 * edge a, a hexahedron has the scaled Jacobian (d_i x d_i+1) . a there. The a whose least product
 * is greatest points to that point of the convex hull of the d_i x d_i+1 that is nearest to 0, and
 * the product is its length.
 */
double CornerBound(const shape::Mesh& surface, const shape::SurfaceFeatures& features);

} // namespace benchmark
