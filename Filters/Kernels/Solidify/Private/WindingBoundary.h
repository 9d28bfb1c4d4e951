#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// Orients the components of a closed surface that may cross each other. The one with the largest
/// volume faces outwards; if it does not, all are reversed. Any other that does not face outwards
/// is reversed, unless most of it lies inside those that do: then it bounds a void. Triangles keep
/// their order. Throws Aborted.
Mesh OrientCrossingPieces(const Mesh& surface, const Progress& progress);

/// Triangles of a surface that bound its solid.
struct WindingBoundary
{
  Mesh Surface;            ///< with all points
  Eigen::VectorXi Parents; ///< for each triangle, that of the given surface
};

/**
 * Extracts the boundary of the region in which the winding number of a surface is at least 1.
 *
 * Triangles on the same three points count as one, with a sum of orientations. Triangles that are
 * connected by edges without further triangles form a patch. The winding number at the largest
 * triangle of a patch decides on which sides of it the region lies. Patches with the region on one
 * side are returned, oriented away from it.
 *
 * surface: closed; its triangles meet only along edges. Throws Aborted.
 */
WindingBoundary ExtractWindingBoundary(const Mesh& surface, const Progress& progress);

} // namespace shape
