#pragma once

#include <Eigen/Core>

#include <string>

namespace shape
{

/// Throws InvalidInput unless the longest edge of the points' bounding box is 0 or between 1e-50
/// and 1e50. Sixth powers of lengths then neither overflow nor underflow. `name` denotes the points
/// in the message, for example "the surface".
void RequireExtent(const Eigen::MatrixXd& points, const std::string& name);

} // namespace shape
