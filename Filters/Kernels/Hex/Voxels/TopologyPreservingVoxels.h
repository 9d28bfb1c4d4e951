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

/// The distance from the surface, in cells, up to which levels are distances.
inline constexpr double LevelBand = 2.0;

/// Returns a grid of cubic cells around points (n x 3), without values. Its outermost cells lie
/// outside the points' bounding box. size: the edge length of a cell, > 0. Throws InvalidInput if
/// the grid would have more than 2e8 cells.
SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size);

/**
 * Computes the levels of a solid at the centres of a grid's cells: the signed distance to the
 * solid's boundary, negative inside, within LevelBand cells of it. Farther away the level is
 * LevelBand cells. The solid is the region where `surface` has a winding number of at least 1.
 *
 * surface: closed, consistently oriented, facing outwards, inside the grid; it may cross itself.
 * boundary: the part of it that bounds the solid (ExtractSolidBoundary). Throws Aborted.
 */
void SampleDistances(const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid,
  const Progress& progress = {});

/// Returns the levels in a grid around the surface: BuildGridAround, then SampleDistances. Throws
/// what these throw.
SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress = {});

/**
 * Fills a solid with cells of a grid that have its topology. The solid is the region where a closed
 * surface has a winding number of at least 1.
 *
 * The topology of a surface that crosses itself is not known in advance. It is then the Euler
 * number and number of components that two successive grids agree on, or any after TakeAnyTopology.
 */
class TopologyPreservingVoxels
{
public:
  /// surface: closed and consistently oriented. Throws InvalidInput under the conditions of
  /// RequireClosedSurface; Aborted.
  explicit TopologyPreservingVoxels(const Surface& surface, const Progress& progress = {});

  /// The surface, facing outwards.
  const Surface& GetSurface() const { return this->Whole; }
  /// The part of the surface that bounds the solid, and the number of its self-crossings.
  const SolidBoundaryResult& Boundary() const { return this->Bounding; }
  /// The surface's topology, which the solid must have unless the surface crosses itself.
  const Topology& SurfaceTopology() const { return this->Wanted; }

  /// From now on accepts any manifold if the surface crosses itself.
  void TakeAnyTopology() { this->TakesAny = true; }

  /// Returns the cell size in the warped space that gives about this number of hexahedra, including
  /// one layer around the cells.
  double CellSizeFor(double hexahedra, const GridDensity& warp) const;

  /// Returns the cells of a uniform grid in the warped space, mapped back. Returns nothing if no
  /// choice of the cells at the boundary gives the solid's topology. Throws what
  /// SampleSolidDistances throws.
  std::optional<HexMesh> Fill(double size, const GridDensity& warp, const Progress& progress = {});

  /// Returns the grid that Fill uses, in the warped space, without values.
  SampledGrid Grid(double size, const GridDensity& warp) const;

  /// Marks the cells of a grid in the warped space that are inside the solid. Returns nothing if no
  /// choice of the cells at the boundary has the solid's topology and is accepted.
  std::optional<std::vector<char>> CellsInside(const SampledGrid& grid, const GridDensity& warp,
    const std::function<bool(const std::vector<char>& inside)>& accepts,
    const Progress& progress = {});

private:
  bool HasTopology(const HexMesh& cubes);

  Surface Whole;
  Topology Wanted;
  int Solids; ///< number of components that bound solids from outside
  SolidBoundaryResult Bounding;
  bool TakesAny = false;
  std::optional<std::pair<int, int>> Before; ///< Euler number and components of the previous grid
};

} // namespace shape
