#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Flattens the patch of an exponential map again, by a conformal map (FlattenConformally) or by the
 * map of minimum distortion that flips no triangle: for patches whose exponential map flips some.
 * The result is scaled so that the mean distance of its points from the seed is their mean distance
 * along the surface, and rotated so that directions at the seed are those of the exponential map. A
 * patch that closes around a protrusion or a hole is cut open where it meets itself (GrowDisk).
 * Flipped also has the triangles without area; Torn is empty.
 *
 * surface: of the patch. refine: the second method, which is slow; the first one may flip triangles
 * if the surface is very curved or coarse. Throws SolveFailure as MapWithFreeBoundary does,
 * InvalidInput if the patch has no area, Aborted.
 */
ExponentialPatch FlattenPatchConformally(const Surface& surface, const ExponentialPatch& patch,
  bool refine, const Progress& progress = {});

} // namespace shape
