#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"
#include "Untangle/MinimizeEnergy.h"

#include <array>

namespace shape
{

struct SnappingOptions
{
  /// Points are moved to parts of the surface that are farther than this from the boundary; in the
  /// surface's units, >= 0.
  double WantedDistance = 0.0;
  /// Lower bounds on the minimum scaled Jacobian after a round, the stricter one first. A round has
  /// to satisfy the first bound that was satisfied before the round. If neither was, the minimum
  /// must not fall.
  std::array<double, 2> ScaledJacobians = { 0.62, 0.55 };
  int Rounds = 6; ///< the maximum number of rounds
};

/**
 * Restores ridges and tips that the boundary cuts off because they are finer than the cells. In
 * each round, the positions are found where surface and boundary are farthest apart. The boundary
 * points nearest to these positions are moved to the surface there and held. The points around them
 * are then moved to maximise the minimum scaled Jacobian (OptimizeHexahedra). A round is undone if
 * it does not lower the distance or makes hexahedra too bad. Points on creases are not moved to far
 * positions.
 *
 * mesh: the hexahedra whose points are moved, within the constraint. quads: the quads of the mesh's
 * boundary, as in HexFit. constraint: a constraint on all points. Returns the larger one-sided
 * Hausdorff distance between the surface and the quads. Throws Aborted.
 */
double SnapToFarPositions(HexMesh& mesh, const Eigen::MatrixXi& quads, const Surface& surface,
  const PointConstraint& constraint, const SnappingOptions& options, const Progress& progress = {});

} // namespace shape
