#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * Point data of a feature that meet what the target has at their loop: the difference there, spread
 * into the feature by inverse squared distances (equation 4 with k = 2) and fading out with the
 * distance from the loop by (1 - x^2)^3.
 *
 * values: m x d, at the feature's points (m x 3). differences: n x d, what the target has less what
 * the feature has, at its loop (n x 3). distances: m, of the feature's points from the loop; width:
 * where nothing is left of it, in their unit; 0 changes nothing. At the loop the result is the
 * target's value exactly, where its points are among the feature's.
 */
Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width);

} // namespace shape
