#pragma once

#include "Base/Progress.h"
#include "Materials/VoxelImage.h"
#include "Mesh/Cells.h"

#include <vector>

namespace shape
{

/**
 * Adds the share of each voxel that lies in a mesh to `shares` (one for each sample). The share is
 * the integral over the mesh of the voxel's interpolation function: 1 inside, 0 outside, and 1/2 if
 * the boundary passes through the sample. Its error is a few hundredths.
 *
 * own: m values; cells with 0, such as ghosts, are left out. Empty: all cells count. The sum does
 * not depend on the order of the cells or the number of threads, so that shares of the parts of a
 * mesh can be added.
 *
 * Throws InvalidInput if a cell is no linear solid cell or a point is not finite; Aborted.
 */
void AddVoxelShares(const Cells& cells, const Eigen::VectorXi& own, const VoxelImage& image,
  std::vector<double>& shares, const Progress& progress = {});

/// What became of the voxels at the boundary of a mesh.
struct BoundaryVoxels
{
  int Boundary = 0;   ///< voxels that lie in the mesh partly, or within the layers
  int Raised = 0;     ///< of these, voxels that got a higher value
  int Unresolved = 0; ///< voxels without inner voxels nearby, which keep their values
};

/**
 * Replaces the values of voxels at the boundary of a mesh by values extrapolated from inside. Such
 * a voxel is the mean of what is inside and outside, the partial volume effect, so that its value
 * is too low if the outside has a lower one.
 *
 * A voxel is at the boundary if the boundary crosses its box (shares[voxel] < 7/8 for a plane that
 * touches the box), or if fewer than `layers` voxels separate it from there. Layer by layer
 * outwards, each such voxel gets the mean of the linear extrapolations of its neighbours along the
 * 26 directions, or the mean of its neighbours if none has two of them in a row. A linear field is
 * reproduced. A value is only raised, never lowered: where the wall is thinner than a voxel, its
 * voxels may be the only ones that have seen it.
 *
 * shares: from AddVoxelShares, for the entire mesh. layers: >= 0; 0 changes nothing.
 */
BoundaryVoxels ExtrapolateToBoundary(const VoxelImage& image, const std::vector<double>& shares,
  int layers, std::vector<double>& values, const Progress& progress = {});

} // namespace shape
