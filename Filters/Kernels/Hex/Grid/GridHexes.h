#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/// If CellSize is 0, cells are sized to give about 20,000 hexahedra. If the result is not good
/// enough, smaller cells are used. Bad hexahedra at preserved corners are no reason for smaller
/// cells, because every grid has them.
struct GridHexesOptions : HexMeshOptions
{
  /// The approximate number of hexahedra that the first grid gives if CellSize is 0.
  double FirstHexahedra = 16500.0;
  /// The target for the minimum scaled Jacobian.
  double WantedScaledJacobian = 0.62;
  /// The length of which WantedDistance and WantedCreaseDistance are fractions, in the surface's
  /// units. If it is 0, the diagonal of the surface's bounding box is used.
  double Diagonal = 0.0;
  /// The target distance between the surface and the boundary, as a fraction of Diagonal; > 0.
  double WantedDistance = 0.0045;
  /// The target distance between the creases of the surface and those of the hexahedra, as a
  /// fraction of Diagonal; > 0.
  double WantedCreaseDistance = 0.001;
  /// Whether the boundary is snapped to parts of the surface that are too far from it
  /// (SnapToSurface).
  bool Snap = true;
  std::vector<RefinementSeed> Seeds; ///< seeds that refine the first grid; require a CellSize
  int Rounds = 6;                    ///< maximum number of refinement rounds; >= 1
};

struct GridHexesResult
{
  HexFit Fit;               ///< the hexahedra; distances are measured to the solid's boundary
  SurfaceFeatures Features; ///< creases around patches at least as large as 4 cell faces
  double CellSize = 0.0;    ///< the size of cells outside the refined parts
  int Crossings = 0;        ///< number of pairs of triangles of the surface that cross
  /// False if the surface crosses itself and no two successive grids agree on the Euler number and
  /// the number of components. The result then has the topology of one grid of medium cell size.
  bool TopologyAgreed = true;
  int Rounds = 0; ///< number of grids that were built
  /// False if inner surfaces have creases, which the hexahedra round off. The grid is then not
  /// refined where interfaces are far from inner surfaces.
  bool InnerCreasesKept = true;
};

/**
 * Fills a closed surface with hexahedra. The core consists of the cells of a regular grid whose
 * centres lie inside the surface. Layers of hexahedra around the core connect it to the surface and
 * follow the creases (FitHexahedra).
 *
 * Where the result is too far from the surface or has bad hexahedra, the next grid has smaller
 * cells: space is magnified there before the grid is laid (GridDensity). The connectivity stays
 * that of a regular grid. The best result is kept. This result, like other results close to the
 * wanted distance, is snapped to the surface where it is too far away (SnapToSurface).
 *
 * The boundary of the result is a manifold. It has the Euler number and the number of components of
 * the surface. Cells are made smaller until this holds, because thin parts and narrow gaps need
 * small cells. If the surface crosses itself, the solid is the region with a winding number of at
 * least 1 (TopologyPreservingVoxels). If the best grid has inverted or bad hexahedra, the points
 * around them may leave the surface (RelaxBoundaryAroundBad).
 *
 * Each of several disjoint solids (SplitSolids) gets a grid of its own, so that the gaps between
 * them need no small cells. Each solid may have a share of MaximumHexahedra that is proportional to
 * its volume, but not below a minimum (ComputeVolumeShares). The result concatenates the features
 * of their surfaces.
 *
 * Inner surfaces separate regions (MultiMaterialVoxels). Hexahedra of adjacent regions meet at
 * these surfaces.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireClosedSurface and MultiMaterialVoxels, or if an option is out of range. Throws
 * SolveFailure if no grid of at most MaximumHexahedra hexahedra has the topology of the surface;
 * Aborted.
 */
GridHexesResult BuildGridHexahedra(const Surface& surface, const GridHexesOptions& options = {},
  const Progress& progress = {}, const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
