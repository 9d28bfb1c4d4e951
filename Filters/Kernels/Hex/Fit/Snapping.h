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
  /// Between the surfaces, in their units: what is farther is snapped to; >= 0.
  double WantedDistance = 0.0;
  /// No scaled Jacobian falls below the first of these that none was below before, or below the
  /// least before.
  std::array<double, 2> ScaledJacobians = { 0.62, 0.55 };
  int Rounds = 6; ///< at most
};

/**
 * Ridges and tips that are sharper than the cells lie between the points of a boundary that is on a
 * surface, and are cut off. Here the points nearest to the positions that are farthest are put on
 * them and held, and the points around are moved so that the worst scaled Jacobian is as good as
 * it can be (OptimizeHexahedra). Done again as long as the distance falls, a few times; a round
 * that makes it larger, or hexahedra too bad, is undone. Points on creases stay.
 *
 * mesh: its points, each where it may be, are moved. quads: of its boundary, as FitHexahedra's.
 * constraint: of all points. Returns the larger one-sided Hausdorff distance between the surface
 * and the quads. Throws Aborted.
 */
double SnapToFarPositions(HexMesh& mesh, const Eigen::MatrixXi& quads, const Surface& surface,
  const PointConstraint& constraint, const SnappingOptions& options, const Progress& progress = {});

} // namespace shape
