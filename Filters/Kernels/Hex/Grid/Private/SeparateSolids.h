#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/**
 * The solids that a closed surface bounds, each with the voids in it, where they are apart from one
 * another; empty where there is only one, where the surface crosses itself, or where a component
 * does not face the way of OrientByNesting.
 *
 * surface: as for RequireClosedSurface. Throws InvalidInput where it is not closed, Aborted.
 */
std::vector<Surface> SplitSolids(const Surface& surface, const Progress& progress = {});

/// The hexahedra of several solids, one after the other: PatchOf counts on. Without interfaces.
HexFit JoinFits(const std::vector<HexFit>& fits);

/// The features of several surfaces (the points and triangles of all), one after the other.
/// solids: one for each of the features.
SurfaceFeatures JoinFeatures(
  const std::vector<SurfaceFeatures>& features, const std::vector<Surface>& solids);

/// The share of the hexahedra that each solid may have: by its volume, and at least some.
std::vector<double> ComputeVolumeShares(const std::vector<Surface>& solids);

} // namespace shape
