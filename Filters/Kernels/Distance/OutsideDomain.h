#pragma once

#include "Distance/SignedDistance.h"

namespace shape
{

/// How far outside a closed surface points belong to its domain all the same, given the closest
/// points of `surface` (n): see OutsideDomain.
Eigen::VectorXd ComputeDomainTolerances(
  const Mesh& surface, const ClosestPoints& closest, double farthest);

/**
 * Which of `points` (n x 3, finite) lie outside the domain that a closed, outward facing surface
 * bounds: 1 outside, 0 inside or within the tolerance.
 *
 * The tolerance is a quarter of the longest edge of the closest triangle, at most `farthest` and at
 * least 1e-6 of the surface's longest side: a solid that was meshed against the smooth surface
 * sticks out of its facets by less than that, and its points belong to the domain. `farthest` is
 * half the distance of the charges: near them a harmonic map means nothing.
 *
 * Throws Aborted.
 */
Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress = {});

} // namespace shape
