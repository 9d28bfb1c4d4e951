#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes the conformal map of a surface to the plane with minimum area distortion: lengths along
 * the longest boundary loop are preserved, except for the correction that closes its image
 * (Springborn, Schroeder and Pinkall 2008, appendix E). Returns n x 2, with the orientation of the
 * surface. The loop's first point is at the origin and its first edge lies along x.
 *
 * The method is boundary first flattening (Sawhney and Crane 2017). The logarithm u of the scale is
 * 0 on the loop and solves the Yamabe equation L u = -K inside. The flux of u gives the curvatures
 * of the loop's image. These curvatures determine the directions of its edges, and then the edge
 * lengths are chosen so that it closes (equations 6, 10, 17). The final map is the harmonic map
 * with this boundary. Curvatures and cotangents are computed on the intrinsic Delaunay
 * triangulation. Both systems share one factorisation. Other loops are
 * filled with triangle fans around the mean of their points.
 *
 * The map is conformal in the limit of fine meshes. Triangles may flip if the mesh is coarse, or if
 * the surface is so curved that its image overlaps itself.
 *
 * Throws InvalidInput when RequireSurfaceWithBoundary(surface, LoopCount::AtLeastOne) does. Throws
 * SolveFailure if the factorisation breaks down or the flips of the intrinsic Delaunay
 * triangulation do not end. Throws Aborted.
 */
Eigen::MatrixXd FlattenConformally(const Surface& surface, const Progress& progress = {});

} // namespace shape
