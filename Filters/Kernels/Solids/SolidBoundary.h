#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/// The part of a surface that bounds its solid.
struct SolidBoundaryResult
{
  /// The triangles that bound the solid, with all points of the given surface. If Crossings is 0,
  /// it is the given surface itself.
  shape::Surface Surface;
  /// number of pairs of triangles that cross or touch; if 0, no triangle is removed
  int Crossings = 0;
};

/**
 * Extracts the triangles that bound the solid of a closed surface, which may cross itself. The
 * solid is the region with a winding number of at least 1. Triangles inside the solid are removed
 * (Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside segmentation using generalized
 * winding numbers", 2013). Triangles that cross others are not split, so small parts of them may
 * lie inside. The result is cached in the surface.
 *
 * surface: closed and consistently oriented. Throws Aborted.
 */
SolidBoundaryResult ExtractSolidBoundary(const Surface& surface, const Progress& progress = {});

/// Returns a closed surface with all triangles reversed if they face inwards, otherwise the same
/// surface. A reversed surface is cached in `surface`.
Surface OrientOutwards(const Surface& surface);

} // namespace shape
