#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Flattens the patch of an exponential map again, if the exponential map flips triangles. The new
 * map is conformal (FlattenConformally) or, with `refine`, has minimum distortion and no flipped
 * triangle (MapWithFreeBoundary). It is scaled so that the mean distance of the points from the
 * seed is the same in the plane as along the surface. It is rotated so that directions at the seed
 * agree with the exponential map. A patch that closes around a protrusion or a hole is cut open
 * where it meets itself (GrowDisk). In the result, Flipped includes triangles without area, and
 * Torn is empty.
 *
 * surface: the surface of the patch. refine: whether to compute the map of minimum distortion,
 * which is slow. Without `refine`, triangles may be flipped if the surface is very curved or
 * coarse. Throws SolveFailure when FlattenConformally or, with `refine`, MapWithFreeBoundary does.
 * Throws InvalidInput if the patch has no area, and Aborted.
 */
ExponentialPatch FlattenPatchConformally(const Surface& surface, const ExponentialPatch& patch,
  bool refine, const Progress& progress = {});

} // namespace shape
