#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/// What bounds the solid that a surface winds around.
struct SolidBoundaryResult
{
  /// The triangles that bound it, with all of the surface's points: the surface itself if none
  /// cross.
  shape::Surface Surface;
  int Crossings = 0; ///< pairs of triangles that cross or touch
};

/**
 * The triangles of a closed surface that may cross itself, without those inside the solid that it
 * winds around at least once (Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside
 * segmentation using generalized winding numbers", 2013). Triangles that cross others are kept
 * whole, so a little of them may lie inside.
 *
 * surface: closed, oriented consistently. The result is cached in it. Throws Aborted.
 */
SolidBoundaryResult ExtractSolidBoundary(const Surface& surface, const Progress& progress = {});

} // namespace shape
