#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns, for each point (n x d), the first point at exactly the same position, usually itself.
std::vector<int> FindCoincidentPoints(const Eigen::MatrixXd& points);

} // namespace shape
