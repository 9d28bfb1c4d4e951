#pragma once

#include "Base/Progress.h"
#include "Solidify/Private/GridContour.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The number of grid points beyond which a grid is refused.
constexpr double MostGridPoints = 1e8;

/// Returns a grid around the triangles of a mesh, with `margin` grid points or more beyond them on
/// each side. Its lines avoid the mesh's own box, whose faces often lie on triangles. Throws
/// InvalidInput if it would have more than MostGridPoints points.
SampledGrid MakeGrid(const Mesh& mesh, double spacing, int margin);

/// Returns a surface, closed by a cone over each connected set of edges whose triangles do not
/// cancel each other. Winding numbers of the result are integers, for any triangles. The given
/// triangles come first.
Mesh CloseByCones(const Mesh& surface);

/**
 * Returns the boundary of the region in which the winding number of a surface is at least 1,
 * sampled on a grid (ContourGrid). On each edge of the grid, the exact crossings with triangles
 * give positions and normals. If there are several, the middle one is taken.
 *
 * surface: closed in the sense of CloseByCones, it may cross itself. spacing: of the grid, > 0.
 * Without such a region, the result is empty. Throws InvalidInput under the conditions of MakeGrid;
 * Aborted.
 */
Mesh ContourWinding(const Mesh& surface, double spacing, const Progress& progress = {});

} // namespace shape
