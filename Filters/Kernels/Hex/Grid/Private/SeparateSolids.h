#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/**
 * Splits the interior of a closed surface into disjoint solids and returns the surface of each,
 * together with its voids. Returns nothing if there is only one solid, if the surface crosses
 * itself, or if a component is not oriented as OrientByNesting would orient it.
 *
 * surface: as for RequireClosedSurface. Throws InvalidInput if it is not closed; Aborted.
 */
std::vector<Surface> SplitSolids(const Surface& surface, const Progress& progress = {});

/// Concatenates the hexahedra of several solids. PatchOf is offset accordingly; there are no
/// interfaces.
HexFit JoinFits(const std::vector<HexFit>& fits);

/// Concatenates the features of several surfaces; indices refer to their concatenated points and
/// triangles. solids: the surface that belongs to each of the features.
SurfaceFeatures JoinFeatures(
  const std::vector<SurfaceFeatures>& features, const std::vector<Surface>& solids);

/// Returns the fraction of the hexahedra that each solid may have: by its volume, with a minimum.
std::vector<double> ComputeVolumeShares(const std::vector<Surface>& solids);

} // namespace shape
