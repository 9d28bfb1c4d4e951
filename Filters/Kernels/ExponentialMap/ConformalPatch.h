#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Flattens the patch of an exponential map again, for patches whose exponential map flips
 * triangles. It uses a conformal map (FlattenConformally), or the map of minimum distortion without
 * flipped triangles. The result is scaled so that the points' mean distance from the seed equals
 * their mean distance along the surface. It is rotated so that directions at the seed agree with
 * the exponential map. A patch that closes around a protrusion or a hole is cut open where it meets
 * itself (GrowDisk). Flipped includes triangles without area; Torn is empty.
 *
 * surface: the surface of the patch. refine: whether to compute the map of minimum distortion,
 * which is slow. The conformal map may flip triangles if the surface is very curved or coarse.
 * Throws SolveFailure as MapWithFreeBoundary, InvalidInput if the patch has no area, and Aborted.
 */
ExponentialPatch FlattenPatchConformally(const Surface& surface, const ExponentialPatch& patch,
  bool refine, const Progress& progress = {});

} // namespace shape
