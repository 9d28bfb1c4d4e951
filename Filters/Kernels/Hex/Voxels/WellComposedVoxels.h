#pragma once

#include "Mesh/HexMesh.h"
#include "Solids/IsoSurface.h"

#include <vector>

namespace shape
{

/// The cells of a uniform grid that make up a solid.
struct WellComposedVoxels
{
  std::vector<char> Inside; ///< for each sample of the grid, whether its cell belongs to the solid
  int Changed = 0;          ///< number of cells whose state differs from the sign of their sample
  int Pinched = 0;          ///< number of cell corners at which the solid still touches itself
};

/**
 * Returns the cells whose samples are negative, with some cells changed so that the boundary is a
 * manifold. Where the solid or its complement touches itself only at a corner or an edge, one of
 * the eight cells there is changed: the cell whose sample is closest to 0. This repeats until the
 * solid is "well-composed" (Latecki, "3D well-composed pictures", 1997).
 *
 * levels: values at the centres of the cells. The outermost cells of the grid always count as
 * outside, because the signs of distances to a folded surface may be wrong anywhere.
 */
WellComposedVoxels FindVoxelSolid(const SampledGrid& levels);

/**
 * Adds cells where the solid's surface is farther than `reach` cells from the cells inside. Removes
 * cells where the surface is farther than `reach` cells from the cells outside. This restores tips
 * and slots that are narrower than a cell. The topology is preserved, and the boundary stays a
 * manifold: a cell changes at most once, and only if it meets the other cells of the solid in a
 * disk.
 *
 * positions (n x 3): positions on the surface, much closer to each other than the cells are wide.
 * Returns the number of cells that were changed.
 */
int CoverSurface(const SampledGrid& grid, const Eigen::MatrixXd& positions, double reach,
  std::vector<char>& inside);

/// Removes all parts of a solid except the `count` parts that have the most cells. Cells that share
/// a face belong to the same part.
void KeepLargestParts(const SampledGrid& grid, int count, std::vector<char>& inside);

/// Returns a cube around each marked sample. The edge length is the grid's spacing.
HexMesh BuildVoxelHexahedra(const SampledGrid& grid, const std::vector<char>& inside);

} // namespace shape
