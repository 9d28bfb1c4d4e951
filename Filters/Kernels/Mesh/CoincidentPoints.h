#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Of each point (n x d) the first one at exactly the same place: itself, mostly.
std::vector<int> FindCoincidentPoints(const Eigen::MatrixXd& points);

} // namespace shape
