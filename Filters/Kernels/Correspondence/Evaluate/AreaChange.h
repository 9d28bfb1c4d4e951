#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Returns how much maps change areas at large scales, both surfaces scaled to area 1: |G - I| /
 * sqrt(k), a mean over both directions. G holds the inner products, on one surface, of the first k
 * = 10 eigenfunctions of the other one composed with the map: the area-based shape difference of
 * Rustamov et al., "Map-based exploration of intrinsic shape differences and variability", 2013. It
 * is 0 if the map keeps areas. Noise of the map hardly matters, because the functions are smooth.
 *
 * a, b: 2-manifolds each of whose points has a triangle. Throws SolveFailure, Aborted.
 */
double ComputeAreaChange(
  const Surface& a, const Surface& b, const SurfaceMaps& maps, const Progress& progress = {});

} // namespace shape
