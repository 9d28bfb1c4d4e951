#pragma once

#include "Labels/Private/SurfaceNet.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Returns where the interfaces around each of net.JunctionPoints meet (k x 3): the position with
 * the smallest sum of squared distances from the planes that fit the interfaces nearby, as in dual
 * contouring (Ju 2002, section 3). A plane is fitted to the points of an
 * interface that are two to four edges away. A small term keeps the position along a curve.
 *
 * points: n x 3, the smoothed points of the net.
 */
Eigen::MatrixXd FitJunctions(const SurfaceNet& net, const Eigen::MatrixXd& points);

} // namespace shape
