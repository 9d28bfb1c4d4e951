#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns the slopes (x, y) at the origin of the paraboloid that best fits positions (n x 3): it
/// minimises the weighted differences in z (Cazals and Pouget, "Estimating differential quantities
/// using polynomial fitting of osculating jets", 2005). weights: n values. If the positions lie
/// nearly on a line, the slope across it is 0.
Eigen::RowVector2d FitSlopesOfParaboloid(
  const Eigen::MatrixXd& positions, const Eigen::VectorXd& weights);

} // namespace shape
