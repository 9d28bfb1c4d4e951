#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/**
 * The closed curves that polylines make: those that end where they begin, and those that others
 * join end to end, whatever their order and their senses; the first polyline of each gives its
 * sense. Points at exactly the same place are one.
 *
 * points: n x 3; polylines: their points in order, of two or more. Returns each curve's points
 * (k x 3), the last one joined to the first. name: what errors call the data. Throws InvalidInput
 * where a curve is open, with the place where it ends.
 */
std::vector<Eigen::MatrixXd> ChainClosedCurves(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const std::string& name);

} // namespace shape
