#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

namespace shape
{

/// Coordinates that are tied to be equal. Entry 3 p + k is the unknown of coordinate k of point p,
/// or -1 if that coordinate is fixed. Count: the number of unknowns.
struct ConstrainedCoordinates
{
  Eigen::VectorXi Unknowns;
  int Count = 0;
};

/**
 * Makes the tetrahedra of a solid positive and minimises their distortion while some coordinates
 * are tied together or fixed. Newton's method lowers the regularised elliptic energy
 * (EllipticEnergy, weighted by volume), as in MinimizeEnergy.
 *
 * positions (n x 3): tied coordinates must be equal at the start and stay exactly equal. Throws
 * Aborted.
 */
PatchResult MinimizeConstrainedEnergy(Eigen::MatrixXd& positions, const WorkingSolid& solid,
  const ConstrainedCoordinates& tied, const PatchOptions& options, const Progress& progress = {});

} // namespace shape
