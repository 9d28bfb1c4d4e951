#pragma once

#include "Base/Progress.h"
#include "Hex/Grid/GridHexesResult.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/**
 * Fills a closed surface with hexahedra. The core consists of the cells of a regular grid whose
 * centres lie inside the surface. Layers of hexahedra around the core connect it to the surface and
 * follow the creases (FitHexahedra).
 *
 * Where the result is too far from the surface or has bad hexahedra, the next grid has smaller
 * cells: space is magnified there before the grid is laid (GridDensity). The connectivity stays
 * that of a regular grid. The best result is kept. This result, like other results close to the
 * wanted distance, is snapped to the surface where it is too far away (SnapToSurface).
 *
 * The boundary of the result is a manifold. It has the Euler number and the number of components of
 * the surface. Cells are made smaller until this holds, because thin parts and narrow gaps need
 * small cells. If the surface crosses itself, the solid is the region with a winding number of at
 * least 1 (TopologyPreservingVoxels). If the best grid has inverted or bad hexahedra, the points
 * around them may leave the surface (RelaxBoundaryAroundBad).
 *
 * Each of several disjoint solids (SplitSolids) gets a grid of its own, so that the gaps between
 * them need no small cells. Each solid may have a share of MaximumHexahedra that is proportional to
 * its volume, but not below a minimum (ComputeVolumeShares). The result concatenates the features
 * of their surfaces.
 *
 * Inner surfaces separate regions (MultiMaterialVoxels). Hexahedra of adjacent regions meet at
 * these surfaces.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireClosedSurface and MultiMaterialVoxels, or if an option is out of range. Throws
 * SolveFailure if no grid of at most MaximumHexahedra hexahedra has the topology of the surface;
 * Aborted.
 */
GridHexesResult BuildGridHexahedra(const Surface& surface, const GridHexesOptions& options = {},
  const Progress& progress = {}, const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
