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

/// Cells of a solid in regions.
struct RegionCells
{
  HexMesh Solid;
  /// m: i + 1 inside inner surface i (the innermost around the cell), 0 where none is around.
  Eigen::VectorXi RegionOf;
  std::vector<std::vector<char>> Inside;   ///< of each inner surface: whether a cell is inside
  std::vector<Eigen::MatrixXi> Interfaces; ///< and its quads, counter-clockwise seen from outside
};

/**
 * The cells of grids that fill a solid, as TopologyPreservingVoxels finds them, cut into regions by
 * inner surfaces: borders between materials. The cells inside each of them have its topology, and
 * no two surfaces share a point of the grid, so each region's boundary is a manifold.
 */
class MultiMaterialVoxels
{
public:
  /// innerSurfaces: closed, inside the solid, also inside one another. Throws InvalidInput where
  /// one is not so, or surfaces cross or touch, or have flat triangles; Aborted.
  MultiMaterialVoxels(const Surface& surface, const std::vector<Surface>& innerSurfaces,
    const Progress& progress = {});

  TopologyPreservingVoxels& Outer() { return this->Whole; }
  const TopologyPreservingVoxels& Outer() const { return this->Whole; }
  std::vector<Surface> InnerSurfaces() const; ///< facing outwards

  /// The cells of a uniform grid in the warped space, carried back; nothing where they are too
  /// coarse for the surfaces. Throws as TopologyPreservingVoxels::Fill.
  std::optional<RegionCells> Fill(
    double size, const GridDensity& warp, const Progress& progress = {});

private:
  TopologyPreservingVoxels Whole;
  std::vector<TopologyPreservingVoxels> Parts; ///< inside each inner surface
};

} // namespace shape
