#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The conformal map of a surface to the plane that keeps lengths along its longest boundary loop,
 * as nearly as a closed curve can: the conformal map of minimum area distortion (Springborn,
 * Schroeder and Pinkall 2008, appendix E). n x 2; counter-clockwise where the triangles are; the
 * first edge of the loop along x, the loop's first point at the origin.
 *
 * Boundary first flattening (Sawhney and Crane 2017): the logarithm u of the scale is 0 on the loop
 * and solves the Yamabe equation L u = -K inside; from its flux follow the curvatures of the loop's
 * image, from these its directions, and lengths that close it (equations 6, 10, 17 there); the
 * harmonic map with that boundary is the image. Curvatures and cotangents are those of the
 * intrinsic Delaunay triangulation. One factorisation serves both; it cannot be interrupted. Other
 * loops are filled with fans around the mean of their points.
 *
 * The map is conformal in the limit of fine meshes; triangles of coarse ones may flip, and those
 * of surfaces so curved that the image overlaps itself.
 *
 * Throws InvalidInput as RequireSurfaceWithBoundary with LoopCount::AtLeastOne, SolveFailure if
 * the factorisation breaks down, Aborted.
 */
Eigen::MatrixXd FlattenConformally(const Surface& surface, const Progress& progress = {});

} // namespace shape
