#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/// One of several disjoint solids.
struct SeparateSolid
{
  Surface Boundary;           ///< including the surfaces of its voids
  std::vector<int> Triangles; ///< of the whole surface, in the order of Boundary
};

/**
 * Splits the interior of a closed surface into disjoint solids. Returns no solid if there is only
 * one, if the surface crosses itself, or if OrientByNesting would reverse a component.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireClosedSurface; Aborted.
 */
std::vector<SeparateSolid> SplitSolids(const Surface& surface, const Progress& progress = {});

/// Concatenates the hexahedra of several solids, none of which may have interfaces. The patches of
/// each solid are numbered after those of the previous solids.
HexFit JoinFits(const std::vector<HexFit>& fits);

/// Concatenates the features of several surfaces. The result indexes the concatenated points and
/// triangles of these surfaces. solids: for each element of features, its surface.
SurfaceFeatures JoinFeatures(
  const std::vector<SurfaceFeatures>& features, const std::vector<Surface>& solids);

/// Shares the hexahedra among solids. Returns the fraction for each solid, which is proportional to
/// its volume but not below a minimum. The fractions add up to 1.
std::vector<double> ComputeVolumeShares(const std::vector<Surface>& solids);

} // namespace shape
