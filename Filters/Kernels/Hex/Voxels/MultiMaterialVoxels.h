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
  /// m: the region of each cell: i + 1 if i is the innermost inner surface around it, 0 if none is.
  Eigen::VectorXi RegionOf;
  std::vector<std::vector<char>> Inside;   ///< for each inner surface, whether each cell is inside
  std::vector<Eigen::MatrixXi> Interfaces; ///< its boundary quads, counter-clockwise from outside
};

/**
 * Fills a solid with cells of a grid (TopologyPreservingVoxels) and divides them into regions by
 * inner surfaces, the borders between materials. The cells inside each inner surface have its
 * topology. No two surfaces share a point of the grid, so the boundary of each region is a
 * manifold.
 */
class MultiMaterialVoxels
{
public:
  /// innerSurfaces: closed, inside the solid; they may be nested. Throws InvalidInput if one is not
  /// closed, is not inside, crosses or touches another, or has degenerate triangles; Aborted.
  MultiMaterialVoxels(const Surface& surface, const std::vector<Surface>& innerSurfaces,
    const Progress& progress = {});

  TopologyPreservingVoxels& Outer() { return this->Whole; }
  const TopologyPreservingVoxels& Outer() const { return this->Whole; }
  std::vector<Surface> InnerSurfaces() const; ///< facing outwards

  /// Returns the cells of a uniform grid in the warped space, mapped back; nothing if they are too
  /// coarse for the surfaces. Throws what TopologyPreservingVoxels::Fill throws.
  std::optional<RegionCells> Fill(
    double size, const GridDensity& warp, const Progress& progress = {});

private:
  TopologyPreservingVoxels Whole;
  std::vector<TopologyPreservingVoxels> Parts; ///< the interior of each inner surface
};

} // namespace shape
