#pragma once

#include "Mesh/HexMesh.h"
#include "Solids/IsoSurface.h"

#include <vector>

namespace shape
{

/// The cells of a uniform grid that make up a solid.
struct WellComposedVoxels
{
  std::vector<char> Inside; ///< for each sample of the grid, whether its cell is in the solid
  int Changed = 0;          ///< cells whose state differs from the sign of their sample
  int Pinched = 0;          ///< corners of cells at which the solid still touches itself
};

/**
 * Returns the cells whose samples are negative, with some cells changed so that the boundary is a
 * manifold. If the solid or its complement touches itself only at a corner or an edge, one of the
 * eight cells there changes sides: the one whose sample is closest to 0. This repeats until the
 * solid is "well-composed" (Latecki, "3D well-composed pictures", 1997).
 *
 * levels: values at the centres of the cells. The outermost cells of the grid are always outside,
 * because signs of distances to a folded surface may be wrong anywhere.
 */
WellComposedVoxels FindVoxelSolid(const SampledGrid& levels);

/**
 * Adds cells where the solid's surface is farther than `reach` cells from the cells inside, and
 * removes cells where it is that far from the cells outside. This restores tips and slots that are
 * narrower than a cell. The topology and a manifold boundary are preserved: a cell changes only if
 * its intersection with the solid is a disk, and at most once.
 *
 * positions: n x 3, on the surface, dense compared with the cells. Returns the number of cells that
 * were changed.
 */
int CoverSurface(const SampledGrid& grid, const Eigen::MatrixXd& positions, double reach,
  std::vector<char>& inside);

/// Keeps the `count` parts of a solid with the most cells; a part is connected by faces of cells.
void KeepLargestParts(const SampledGrid& grid, int count, std::vector<char>& inside);

/// Returns the marked cells as cubes of the grid's spacing around the samples.
HexMesh BuildVoxelHexahedra(const SampledGrid& grid, const std::vector<char>& inside);

} // namespace shape
