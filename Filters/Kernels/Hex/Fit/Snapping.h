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
  /// Parts of the surface farther than this from the boundary are snapped to, in its units; >= 0.
  double WantedDistance = 0.0;
  /// Lower bounds of the minimum scaled Jacobian in a round. The first that was reached before the
  /// round applies; if neither was, the minimum must not fall.
  std::array<double, 2> ScaledJacobians = { 0.62, 0.55 };
  int Rounds = 6; ///< the maximum number of rounds
};

/**
 * Restores ridges and tips that are sharper than the cells: they lie between the points of the
 * boundary, which cuts them off. The boundary points nearest to the farthest positions are moved
 * there and held. The points around them are moved to maximise the worst scaled Jacobian
 * (OptimizeHexahedra). This is repeated for a few rounds while the distance falls. A round that
 * increases the distance or makes hexahedra too bad is undone. Points on creases stay.
 *
 * mesh: its points are moved within the constraint. quads: of its boundary, as in HexFit.
 * constraint: for all points. Returns the larger one-sided Hausdorff distance between the surface
 * and the quads. Throws Aborted.
 */
double SnapToFarPositions(HexMesh& mesh, const Eigen::MatrixXi& quads, const Surface& surface,
  const PointConstraint& constraint, const SnappingOptions& options, const Progress& progress = {});

} // namespace shape
