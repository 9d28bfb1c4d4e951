#pragma once

#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/GridDensity.h"
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
  /// The fraction of the features' length that the hexahedra follow (ComputeFollowedShare).
  double FollowedShare = 1.0;
  double CellSize = 0.0; ///< the size of cells outside the refined parts
  int Crossings = 0;     ///< number of pairs of triangles of the surface that cross
  /// False if the surface crosses itself and no two successive grids agree on the Euler number and
  /// the number of components. The result then has the topology of one grid of medium cell size.
  bool TopologyAgreed = true;
  int Rounds = 0; ///< number of grids that were built
  /// False if inner surfaces have creases, which the hexahedra round off. The grid is then not
  /// refined where interfaces are far from inner surfaces.
  bool InnerCreasesKept = true;
};

} // namespace shape
