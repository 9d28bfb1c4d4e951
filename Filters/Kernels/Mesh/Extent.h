#pragma once

#include <Eigen/Core>

#include <string>

namespace shape
{

/// Throws InvalidInput unless the longest side of the points' box is 0 or between 1e-50 and 1e50:
/// sixth powers of lengths must neither over- nor underflow. `name` is what the message calls them:
/// "the surface".
void RequireExtent(const Eigen::MatrixXd& points, const std::string& name);

} // namespace shape
