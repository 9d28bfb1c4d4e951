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

/// How far from the surface, in cells, levels still are distances.
inline constexpr double LevelBand = 2.0;

/// A grid of cubic cells around points (n x 3), without values; its outermost cells lie outside of
/// their box. size: of a cell, > 0. Throws InvalidInput where it has more than 2e8 cells.
SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size);

/**
 * The levels of a solid in the cells of a grid: at the centre of each the signed distance to the
 * solid's boundary, negative inside, where it is nearer than LevelBand cells; LevelBand cells
 * elsewhere. The solid is what `surface` winds around at least once.
 *
 * surface: closed, oriented consistently, facing outwards, inside the grid; it may cross itself.
 * boundary: what of it bounds the solid (ExtractSolidBoundary). Throws Aborted.
 */
void SampleDistances(const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid,
  const Progress& progress = {});

/// The levels in the cells around the surface. Throws as both.
SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress = {});

/**
 * The cells of grids that fill a solid and have its topology: what a closed surface winds around at
 * least once.
 *
 * The topology of a surface that crosses itself is not known: it is the Euler number and number of
 * components that two successive grids agree on; where none do, any after TakeAnyTopology.
 */
class TopologyPreservingVoxels
{
public:
  /// surface: closed, oriented consistently. Throws InvalidInput as RequireClosedSurface, Aborted.
  explicit TopologyPreservingVoxels(const Surface& surface, const Progress& progress = {});

  /// The surface, facing outwards.
  const Surface& GetSurface() const { return this->Whole; }
  /// What of it bounds the solid, and how often it crosses itself.
  const SolidBoundaryResult& Boundary() const { return this->Bounding; }
  /// Of the surface: what the solid has to have where it does not cross itself.
  const Topology& SurfaceTopology() const { return this->Wanted; }

  /// Takes any manifold from now on where the surface crosses itself.
  void TakeAnyTopology() { this->TakesAny = true; }

  /// The size of cells in the warped space that make about this many hexahedra, those of a layer
  /// around them included.
  double CellSizeFor(double hexahedra, const GridDensity& warp) const;

  /// The cells of a uniform grid in the warped space, carried back; nothing where none of the
  /// choices of cells on the boundary has the solid's topology. Throws as SampleSolidDistances.
  std::optional<HexMesh> Fill(double size, const GridDensity& warp, const Progress& progress = {});

  /// The grid that Fill uses, in the warped space; without values.
  SampledGrid Grid(double size, const GridDensity& warp) const;

  /// The cells of a grid in the warped space around the surface that are inside, and accepted;
  /// nothing where none of the choices of cells on the boundary has the solid's topology and is.
  std::optional<std::vector<char>> CellsInside(const SampledGrid& grid, const GridDensity& warp,
    const std::function<bool(const std::vector<char>& inside)>& accepts,
    const Progress& progress = {});

private:
  bool HasTopology(const HexMesh& cubes);

  Surface Whole;
  Topology Wanted;
  int Solids; ///< components that bound solids from outside
  SolidBoundaryResult Bounding;
  bool TakesAny = false;
  std::optional<std::pair<int, int>> Before; ///< Euler number and components of the last grid
};

} // namespace shape
