#pragma once

#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Rounds the coordinates of a polycube's charts to integers close to them. Charts at the two ends
 * of a polycube edge, and charts that face each other across the solid, keep their order and a
 * distance of at least 1.
 *
 * positions (n x 3): the points of the solid on the polycube, in units of cells; every tetrahedron
 * is positive. Returns one integer for each chart: its coordinate along its axis.
 */
Eigen::VectorXi RoundCharts(const WorkingSolid& solid, const Charts& charts,
  const ConstrainedCoordinates& tied, const Eigen::MatrixXd& positions);

} // namespace shape
