#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The curve skeleton of a solid: points that branches join.
struct CurveSkeleton
{
  Eigen::MatrixXd Points;  ///< n x 3; every junction and every end is one point
  Eigen::VectorXd Radii;   ///< n: distance from the surface, in its units
  Eigen::VectorXi Degrees; ///< n: number of edges at each point: 1 at ends, 3 or more at junctions
  /// The points of each branch, from a junction or end to the next. A closed branch begins and ends
  /// with the same point. A branch of one point is the skeleton of a component like a ball.
  std::vector<std::vector<int>> Branches;
  int Components = 0;
  int Cycles = 0;        ///< the first Betti number
  int OutsidePoints = 0; ///< number of points that are not inside the surface
};

} // namespace shape
