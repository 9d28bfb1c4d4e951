#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

namespace shape
{

/// Coordinates of points that are the same number: entry 3 p + k is the unknown that coordinate k
/// of point p is, or -1 where it stays as it is.
struct ConstrainedCoordinates
{
  Eigen::VectorXi Unknowns;
  int Count = 0;
};

/**
 * Makes the tetrahedra of a solid positive, and as little distorted as can be, where some
 * coordinates of its points are tied together or fixed: the regularised elliptic energy
 * (EllipticEnergy, weighted by volume) by Newton's method, as MinimizeEnergy.
 *
 * positions (n x 3): tied coordinates start equal, and stay so to the bit. Throws Aborted.
 */
PatchResult MinimizeConstrainedEnergy(Eigen::MatrixXd& positions, const WorkingSolid& solid,
  const ConstrainedCoordinates& tied, const PatchOptions& options, const Progress& progress = {});

} // namespace shape
