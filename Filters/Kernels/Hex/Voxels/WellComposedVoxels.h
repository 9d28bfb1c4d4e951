#pragma once

#include "Mesh/HexMesh.h"
#include "Solids/IsoSurface.h"

#include <vector>

namespace shape
{

/// The cells of a uniform grid that make up a solid.
struct WellComposedVoxels
{
  std::vector<char> Inside; ///< for each sample of the grid
  int Changed = 0;          ///< cells that the samples alone would have told otherwise
  int Pinched = 0;          ///< corners of cells where it still touches itself
};

/**
 * Cubes around those samples that are negative, changed where the solid or what is outside would
 * touch itself in a corner or an edge only: of the eight cells there the one whose sample is
 * nearest to 0 changes sides, until the boundary is a manifold ("well-composed": Latecki, "3D
 * well-composed pictures", 1997).
 *
 * levels: at the centres of the cells; the cells on the grid's sides are outside, whatever
 * these say (signs of distances to a folded surface may be wrong anywhere).
 */
WellComposedVoxels FindVoxelSolid(const SampledGrid& levels);

/**
 * Adds cells where positions of the solid's surface lie farther than `reach` cells from the cells
 * inside, and takes cells away where they lie so far from those outside: tips and slots that are
 * narrower than a cell. The topology stays, and a manifold boundary stays one: a cell changes only
 * where what it shares with the solid is a disc, and once.
 *
 * positions: n x 3, dense against the cells. Returns how many cells were changed.
 */
int CoverSurface(const SampledGrid& grid, const Eigen::MatrixXd& positions, double reach,
  std::vector<char>& inside);

/// Of the parts of a solid that are connected by faces, the `count` that have the most cells.
void KeepLargestParts(const SampledGrid& grid, int count, std::vector<char>& inside);

/// Its cells, cubes of the grid's spacing around the samples.
HexMesh BuildVoxelHexahedra(const SampledGrid& grid, const std::vector<char>& inside);

} // namespace shape
