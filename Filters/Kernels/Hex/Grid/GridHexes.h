#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/// CellSize 0: one that gives about 20,000 hexahedra, or smaller ones if these are not good enough
/// anywhere but at corners that are kept, where other grids have the same.
struct GridHexesOptions : HexMeshOptions
{
  double FirstHexahedra = 16500.0; ///< about this many cells in the first grid of an automatic size
  /// The scaled Jacobian of the worst hexahedron that is aimed at.
  double WantedScaledJacobian = 0.62;
  /// What distances are shares of, in the surface's units; 0: the diagonal of the surface's box.
  double Diagonal = 0.0;
  /// The distance between the surfaces that is aimed at, as a share of the diagonal.
  double WantedDistance = 0.0045;
  /// The same of the distance between creases.
  double WantedCreaseDistance = 0.001;
  bool Snap = true; ///< whether points are put on what is farther than wanted (SnapToSurface)
  std::vector<RefinementSeed> Seeds; ///< of the space of the first grid; with a CellSize
  int Rounds = 6; ///< of making cells smaller where the result is not as wanted; >= 1
};

struct GridHexesResult
{
  HexFit Fit;               ///< its distance is to what bounds the solid
  SurfaceFeatures Features; ///< creases that were looked for, patches at least 4 cells large
  double CellSize = 0.0;    ///< the largest that was used, where the grid was not made finer
  int Crossings = 0;        ///< pairs of the surface's triangles that cross
  /// False where the surface crosses itself and no two successive grids have the same Euler number
  /// and number of components: then they are those of one grid of middling cells.
  bool TopologyAgreed = true;
  int Rounds = 0; ///< how many grids were made
  /// False where inner surfaces have creases, which are rounded; then no cells become smaller for
  /// the distance to these surfaces.
  bool InnerCreasesKept = true;
};

/**
 * Hexahedra inside a closed surface: the cells of a regular grid whose centres lie in it, with
 * layers of hexahedra around them whose boundary lies on the surface and has its creases
 * (FitHexahedra).
 *
 * Where the result is farther from the surface than wanted, or has bad hexahedra, the next grid is
 * one of smaller cells there: space is magnified around these positions before the grid is laid
 * (GridDensity), and the connections stay those of a regular grid. The best result is kept. What is
 * near the wanted distance, and the best one, are snapped to what is farther (SnapToSurface).
 *
 * The boundary of the result is a manifold of the surface's Euler number and number of components.
 * Cells become smaller until that is so: thin parts and narrow gaps ask for it. Where the surface
 * crosses itself the solid is what it winds around at least once (TopologyPreservingVoxels).
 * Where hexahedra of the best grid are inverted or bad, points around them leave the surface
 * (RelaxBoundaryAroundBad).
 *
 * Several solids that are apart (SplitSolids) have grids of their own, so that gaps between them
 * need no small cells; each has a share of the hexahedra by its volume, at least some. Features are
 * of their surfaces, one after the other, then.
 *
 * Inner surfaces are borders between regions (MultiMaterialVoxels): hexahedra of two regions meet
 * on them.
 *
 * surface: closed, oriented consistently. Throws InvalidInput as RequireClosedSurface and
 * MultiMaterialVoxels, and where options are out of range; SolveFailure where no grid of so few
 * cells has the topology of the surface, Aborted.
 */
GridHexesResult BuildGridHexahedra(const Surface& surface, const GridHexesOptions& options = {},
  const Progress& progress = {}, const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
