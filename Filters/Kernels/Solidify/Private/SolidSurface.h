#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendedSurface.h"
#include "Solidify/SurfaceDefects.h"

namespace shape
{

struct SolidSurfaceOptions
{
  SurfaceDefectOptions Defects; ///< the tolerances of the steps that are those of MendSurface
  /// The spacing of the grid, if one is needed; in the model's units, >= 0. 0 means 1/128 of the
  /// longest edge of the bounding box.
  double DetailSize = 0.0;
};

/**
 * Makes triangles that cross each other the boundary of one solid: the region in which their
 * winding number is at least 1 (Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside
 * segmentation using generalized winding numbers", 2013).
 *
 * 1. The surface is drafted and closed as in MendSurface. Components that face inwards are
 *    reversed, unless they bound a void of others.
 * 2. Triangles are split where they meet others. Those on the boundary of the region are kept; a
 *    triangle that meets no other is not changed. Rounding may have moved parts across others, so
 *    this is repeated up to four times, until there is no intersection.
 * 3. If this does not succeed, the boundary of the region is sampled on a grid instead
 *    (cubical marching squares, which keeps creases). Holes then count as closed by cones over
 *    their edges. All triangles are made, and details smaller than DetailSize are lost.
 *
 * The result is closed, a manifold, oriented outwards, and does not intersect itself; all of this
 * is checked exactly.
 *
 * surface: any triangles. Throws InvalidInput if there is no such region, if sheets make up a
 * tenth of the area or more (see MendSurface), if it would lack a hundredth of the area or more, if
 * DetailSize needs too large a grid, or under the conditions of FindSurfaceDefects; Aborted.
 */
MendedSurface MakeSolid(
  const Mesh& surface, const SolidSurfaceOptions& options = {}, const Progress& progress = {});

/// Does the steps 1 and 2 of MakeSolid, without its conditions on sheets and lost area. Throws
/// InvalidInput or SolveFailure if they do not succeed; Aborted.
MendedSurface MakeSolidOfTriangles(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress = {});

} // namespace shape
