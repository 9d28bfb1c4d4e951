#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/RegionFit.h"
#include "Hex/Grid/GridHexesResult.h"
#include "Hex/Voxels/TouchingRegionVoxels.h"

#include <string>

namespace shape
{

struct RegionHexesResult : RegionFit
{
  double CellSize = 0.0;  ///< the size that was used, in the surfaces' units
  std::string WhySmaller; ///< if it is smaller than the given one: why
};

/**
 * Fills regions that touch with hexahedra, which share their points on interfaces. The core
 * consists of the cells of a regular grid along the given frame (TouchingRegionVoxels). Layers of
 * hexahedra connect it to the interfaces and to the boundary (FitRegions).
 *
 * The hexahedra of each region have the Euler number and the number of components of its surface:
 * cells are made smaller until they do. If no size is given, a few grids with smaller cells are
 * compared until one has all curves and junctions of the surfaces, and cells are made smaller while
 * hexahedra are not good (IsGood), as long as their number permits. Cells of a given size are only
 * made smaller for the topology, or if hexahedra stay inverted. The best result is kept.
 *
 * options: Seeds, Rounds, Snap and FeatureAngle are not used. Throws InvalidInput under the
 * conditions of TouchingRegionVoxels, or if an option is out of range; SolveFailure if no grid of
 * at most MaximumHexahedra hexahedra has the topology of all regions; Aborted.
 */
RegionHexesResult BuildRegionHexahedra(const LabelledSurfaces& regions,
  const GridHexesOptions& options = {}, const Progress& progress = {});

} // namespace shape
