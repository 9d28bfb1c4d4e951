#pragma once

#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Whole numbers for the coordinates of a polycube's charts, close to where they are: charts at the
 * two ends of a polycube edge, and charts that face each other across the solid, stay at least one
 * apart and in order.
 *
 * positions (n x 3): the points of the solid on the polycube, positive on its tetrahedra, in units
 * of the cells. Returns one number for each chart, along its axis.
 */
Eigen::VectorXi RoundCharts(const WorkingSolid& solid, const Charts& charts,
  const ConstrainedCoordinates& tied, const Eigen::MatrixXd& positions);

} // namespace shape
