#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/// The part of a surface that bounds its solid.
struct SolidBoundaryResult
{
  /// The surface's triangles that bound the solid, with all of the surface's points; the surface
  /// itself if all triangles do.
  shape::Surface Surface;
  int Crossings = 0; ///< pairs of triangles that cross or touch; if 0, no triangle is removed
};

/**
 * Extracts the triangles of a closed surface that bound its solid, the region with a winding number
 * of at least 1; the surface may cross itself. Triangles inside the solid are removed (Jacobson,
 * Kavan and Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding
 * numbers", 2013). Triangles that cross others are not split, so small parts of them may lie
 * inside. The result is cached in the surface.
 *
 * surface: closed and consistently oriented. Throws Aborted.
 */
SolidBoundaryResult ExtractSolidBoundary(const Surface& surface, const Progress& progress = {});

/// Returns the closed surface with its normals pointing outwards: itself if they already do.
Surface OrientOutwards(const Surface& surface);

} // namespace shape
