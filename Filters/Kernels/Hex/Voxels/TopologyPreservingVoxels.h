#pragma once

#include "Base/Progress.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Solids/IsoSurface.h"
#include "Solids/SolidBoundary.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

/// Levels (SampleDistances) equal the signed distance up to this number of cells from the surface.
inline constexpr double LevelBand = 2.0;

/// Which cells are tried first as those inside a solid.
enum class VoxelRule
{
  Connected, ///< also those whose centres are slightly outside: thin parts stay connected
  Centres, ///< those whose centres are inside: the rows of cells along edges of the solid are even
  /// As Connected, then by more levels: coarser cells have the topology, but may be farther from
  /// the surface.
  Any
};

/// Returns a grid of cubic cells around points (n x 3), without values. Its outermost cells lie
/// outside the points' bounding box. size: the edge length of a cell, > 0. Throws InvalidInput if
/// the grid would have more than 2e8 cells.
SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size);

/**
 * Computes the level of a solid at the centre of each cell of a grid. The level is the signed
 * distance to the solid's boundary, negative inside, limited to LevelBand cells on either side. The
 * solid is the region where `surface` has a winding number of at least 1.
 *
 * surface: closed, consistently oriented, facing outwards, inside the grid; may cross itself.
 * boundary: the part of the surface that bounds the solid (ExtractSolidBoundary). Throws Aborted.
 */
void SampleDistances(const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid,
  const Progress& progress = {});

/// Returns the levels of a solid in a grid around its surface (BuildGridAround, then
/// SampleDistances). Throws whatever these functions throw.
SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress = {});

/**
 * Fills a solid with cells of a grid, so that the cells have the solid's topology. The solid is the
 * region where a closed surface has a winding number of at least 1.
 *
 * If the surface crosses itself, the topology of the solid is not known in advance. A grid is then
 * accepted if its Euler number and its number of components equal those of the previous grid, or if
 * TakeAnyTopology was called.
 */
class TopologyPreservingVoxels
{
public:
  /// surface: closed and consistently oriented. Throws InvalidInput under the conditions of
  /// RequireClosedSurface; Aborted.
  explicit TopologyPreservingVoxels(const Surface& surface, const Progress& progress = {});

  /// The surface, facing outwards.
  const Surface& GetSurface() const { return this->Whole; }
  /// The part of the surface that bounds the solid, and the number of the surface's self-crossings.
  const SolidBoundaryResult& Boundary() const { return this->Bounding; }
  /// The topology of the surface. Unless the surface crosses itself, the cells must have the same
  /// topology.
  const Topology& SurfaceTopology() const { return this->Wanted; }

  /// From now on, if the surface crosses itself, cells of any topology with a manifold boundary are
  /// accepted.
  void TakeAnyTopology() { this->TakesAny = true; }

  /// Returns a cell size in the warped space. Cells of this size and one layer of hexahedra around
  /// them are about `hexahedra` in number.
  double CellSizeFor(double hexahedra, const GridDensity& warp) const;

  /// Returns cells of a grid that is uniform in the warped space, mapped back into the solid.
  /// Returns nothing if no tried choice of the cells at the boundary gives the solid's topology.
  /// Throws whatever SampleSolidDistances throws.
  std::optional<HexMesh> Fill(double size, const GridDensity& warp, const Progress& progress = {});

  /// Returns the grid that Fill uses, in the warped space, without values.
  SampledGrid Grid(double size, const GridDensity& warp) const;

  /// Marks the cells of a grid in the warped space that are inside the solid. Several choices of
  /// the cells at the boundary are tried. Returns the first choice that has the solid's topology
  /// and that `accepts` accepts, or nothing if there is none.
  std::optional<std::vector<char>> CellsInside(const SampledGrid& grid, const GridDensity& warp,
    const std::function<bool(const std::vector<char>& inside)>& accepts,
    const Progress& progress = {}, VoxelRule rule = VoxelRule::Connected);

private:
  bool HasTopology(const HexMesh& cubes);

  Surface Whole;
  Topology Wanted;
  int Solids; ///< number of components of the surface that bound a solid from outside
  SolidBoundaryResult Bounding;
  bool TakesAny = false;
  std::optional<std::pair<int, int>> Before; ///< Euler number and components of the previous grid
};

} // namespace shape
