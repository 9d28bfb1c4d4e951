#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

namespace shape
{

/// Coordinates that are tied to be equal, because they share an unknown. Entry 3 p + k of Unknowns
/// is the unknown of coordinate k of point p, or -1 if this coordinate is fixed. Count is the
/// number of unknowns.
struct ConstrainedCoordinates
{
  Eigen::VectorXi Unknowns;
  int Count = 0;
};

/**
 * Moves the points of a solid to make its tetrahedra positive and to minimise their distortion,
 * while some coordinates are tied together or fixed. Newton's method lowers the regularised
 * elliptic energy (EllipticEnergy, weighted by volume), like MinimizeEnergy.
 *
 * positions (n x 3): the positions of the points. Tied coordinates must be equal at the start, and
 * they stay exactly equal. Throws Aborted.
 */
PatchResult MinimizeConstrainedEnergy(Eigen::MatrixXd& positions, const WorkingSolid& solid,
  const ConstrainedCoordinates& tied, const PatchOptions& options, const Progress& progress = {});

} // namespace shape
