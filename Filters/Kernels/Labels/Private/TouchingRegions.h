#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Splits the points where a region touches itself: where its triangles form two fans or more. The
 * smaller fan gets a point of its own, a quarter of the way to its border. Triangles beside it
 * follow, so that the surface stays conforming. Edges that a region surrounds twice are not
 * allowed.
 *
 * candidates: the points to look at. Returns the number of new points.
 */
int SplitTouchingRegions(Eigen::MatrixXd& points, Eigen::MatrixXi& triangles,
  Eigen::MatrixXi& regions, const std::vector<int>& candidates);

} // namespace shape
