#pragma once

#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Rounds the coordinates of a polycube's charts to nearby integers. Two kinds of pairs keep their
 * order and a distance of at least 1: charts at the two ends of an edge of the polycube, and charts
 * that face each other across the solid.
 *
 * positions (n x 3): the positions of the solid's points on the polycube, in units of cells; every
 * tetrahedron is positive there. Returns one integer for each chart: its coordinate along its axis.
 */
Eigen::VectorXi RoundCharts(const WorkingSolid& solid, const Charts& charts,
  const ConstrainedCoordinates& tied, const Eigen::MatrixXd& positions);

} // namespace shape
