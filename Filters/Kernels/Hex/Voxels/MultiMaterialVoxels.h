#pragma once

#include "Base/Progress.h"
#include "Hex/Voxels/GridDensity.h"
#include "Hex/Voxels/TopologyPreservingVoxels.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shape
{

/// The cells of a solid, divided into regions.
struct RegionCells
{
  HexMesh Solid;
  /// m: the region of each cell. It is i + 1 if inner surface i is the innermost around the cell,
  /// and 0 if no inner surface is around it.
  Eigen::VectorXi RegionOf;
  std::vector<std::vector<char>> Inside; ///< for each inner surface: whether each cell is inside
  /// For each inner surface: the boundary quads of the cells inside, counter-clockwise seen from
  /// outside.
  std::vector<Eigen::MatrixXi> Interfaces;
};

/**
 * Fills a solid with cells of a grid (TopologyPreservingVoxels). Inner surfaces, which are the
 * borders between materials, divide the cells into regions. The cells inside each inner surface
 * have the topology of this inner surface. The boundaries of these cells share no point with each
 * other or with the boundary of the solid, so the boundary of each region is a manifold.
 */
class MultiMaterialVoxels
{
public:
  /// innerSurfaces: closed surfaces inside the solid; they may be nested. Throws InvalidInput if a
  /// surface is not closed, is not inside, crosses or touches another, or has degenerate triangles;
  /// Aborted.
  MultiMaterialVoxels(const Surface& surface, const std::vector<Surface>& innerSurfaces,
    const Progress& progress = {});

  TopologyPreservingVoxels& Outer() { return this->Whole; }
  const TopologyPreservingVoxels& Outer() const { return this->Whole; }
  std::vector<Surface> InnerSurfaces() const; ///< the inner surfaces, facing outwards

  /// Returns cells of a grid that is uniform in the warped space, mapped back into the solid.
  /// Returns nothing if the cells are too coarse for the surfaces. Throws whatever
  /// TopologyPreservingVoxels::Fill throws.
  std::optional<RegionCells> Fill(double size, const GridDensity& warp,
    const Progress& progress = {}, VoxelRule rule = VoxelRule::Connected);

private:
  TopologyPreservingVoxels Whole;
  std::vector<TopologyPreservingVoxels> Parts; ///< the interior of each inner surface
};

} // namespace shape
