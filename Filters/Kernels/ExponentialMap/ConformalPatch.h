#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * The patch of an exponential map laid out anew by a conformal map (FlattenConformally), or by the
 * one with the least distortion that flips no triangle: for where the exponential map flips some.
 * Scaled so that points are as far from the seed as along the surface in the mean, and turned so
 * that directions at the seed are those of the exponential map. Where the patch goes around a limb
 * or a hole it is open along the line where it meets itself (GrowDisk). Flipped has the triangles
 * without area, too; Torn is empty.
 *
 * surface: what the patch is of. refine: the second way, which is slow; the first may flip
 * triangles where the surface is very curved or coarse. Throws SolveFailure as MapWithFreeBoundary,
 * InvalidInput where the patch has no area, Aborted.
 */
ExponentialPatch FlattenPatchConformally(const Surface& surface, const ExponentialPatch& patch,
  bool refine, const Progress& progress = {});

} // namespace shape
