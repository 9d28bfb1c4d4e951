#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/**
 * The closed curves that polylines make: those that end where they begin, and those that others
 * join end to end, whatever their order and directions; the first polyline of each gives its
 * direction. Points at exactly the same position are one.
 *
 * points: n x 3; polylines: their points in order, of two or more. Returns each curve's points
 * (k x 3), the last one joined to the first. name: what errors call the data. Throws InvalidInput
 * if a curve is open, with the position where it ends.
 */
std::vector<Eigen::MatrixXd> ChainClosedCurves(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const std::string& name);

} // namespace shape
