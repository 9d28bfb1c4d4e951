#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/// CellSize 0: a size that gives about 20,000 hexahedra. Smaller cells are used if the result is
/// not good enough; bad hexahedra at preserved corners do not count, as every grid has them.
struct GridHexesOptions : HexMeshOptions
{
  double FirstHexahedra = 16500.0; ///< approximate number of cells of the first automatic grid
  /// The target for the worst scaled Jacobian.
  double WantedScaledJacobian = 0.62;
  /// The length that distances are relative to, in the surface's units; 0: the diagonal of the
  /// surface's bounding box.
  double Diagonal = 0.0;
  /// The target distance between the surface and the boundary, as a fraction of the diagonal.
  double WantedDistance = 0.0045;
  /// The target distance between creases, as a fraction of the diagonal.
  double WantedCreaseDistance = 0.001;
  bool Snap = true; ///< whether points move to parts that are farther than wanted (SnapToSurface)
  std::vector<RefinementSeed> Seeds; ///< seeds that refine the first grid; they need a CellSize
  int Rounds = 6;                    ///< maximum number of refinement rounds; >= 1
};

struct GridHexesResult
{
  HexFit Fit;               ///< its distance is measured to the boundary of the solid
  SurfaceFeatures Features; ///< creases around patches of the area of at least 4 cell faces
  double CellSize = 0.0;    ///< the largest size that was used, outside the refined parts
  int Crossings = 0;        ///< the number of pairs of the surface's triangles that cross
  /// False if the surface crosses itself and no two successive grids have the same Euler number and
  /// number of components. The result then has the topology of a single grid of medium cells.
  bool TopologyAgreed = true;
  int Rounds = 0; ///< the number of grids that were made
  /// False if inner surfaces have creases, which are rounded. The distance to these surfaces then
  /// does not refine the grid.
  bool InnerCreasesKept = true;
};

/**
 * Fills a closed surface with hexahedra. They are the cells of a regular grid whose centres lie
 * inside, surrounded by layers of hexahedra whose boundary lies on the surface and follows its
 * creases (FitHexahedra).
 *
 * If the result is too far from the surface or has bad hexahedra, the next grid has smaller cells
 * there: space is magnified around these positions before the grid is laid (GridDensity). The
 * connectivity stays that of a regular grid. The best result is kept. Results that are close to the
 * wanted distance, and the best one, are snapped to the surface where they are farther
 * (SnapToSurface).
 *
 * The boundary of the result is a manifold with the Euler number and the number of components of
 * the surface. Cells become smaller until it is: thin parts and narrow gaps need small cells. If
 * the surface crosses itself, the solid is the region with a winding number of at least 1
 * (TopologyPreservingVoxels). If the best grid has inverted or bad hexahedra, the points around
 * them may leave the surface (RelaxBoundaryAroundBad).
 *
 * Disjoint solids (SplitSolids) get one grid each, because gaps between them then need no small
 * cells. Each solid gets a share of the hexahedra by its volume, but at least a few. The features
 * of their surfaces are concatenated in the result.
 *
 * Inner surfaces separate regions (MultiMaterialVoxels); hexahedra of two regions meet on them.
 *
 * surface: closed and consistently oriented. Throws InvalidInput under the conditions of
 * RequireClosedSurface and MultiMaterialVoxels, or if an option is out of range. Throws
 * SolveFailure if no grid within MaximumHexahedra has the topology of the surface; Aborted.
 */
GridHexesResult BuildGridHexahedra(const Surface& surface, const GridHexesOptions& options = {},
  const Progress& progress = {}, const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
