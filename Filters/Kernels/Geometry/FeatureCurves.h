#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A polyline: its points in order (n x 3, n >= 2), closed where the last one is the first again.
using Curve = Eigen::MatrixXd;

/// Points of curves, and what lies at the same share of the length of the paired curves.
struct MatchedCurves
{
  Eigen::MatrixXd Points;    ///< k x 3
  Eigen::MatrixXd Targets;   ///< k x 3
  Eigen::VectorXi Curves;    ///< k: which curve
  Eigen::VectorXd Positions; ///< k: i + t, where t of the way from point i of it to the next
};

/**
 * Pairs the i-th curve of `sources` with the i-th of `targets` by arc length (the restamping of
 * skeletons in Li et al. 2010, section 4.4): a point at the share s of its curve's length goes to
 * the point at the share s of the other's. They need not have equal numbers of points.
 *
 * The points are those of `sources`, and more between them, evenly, where they are more than
 * `longestStep` (> 0) apart.
 *
 * `name` is what errors call the curves. Throws InvalidInput where the numbers of curves differ, a
 * curve has no length or coordinates that are not finite, or two points of `sources` that follow
 * each other are more than 10,000 steps apart.
 */
MatchedCurves MatchCurves(const std::vector<Curve>& sources, const std::vector<Curve>& targets,
  double longestStep, const std::string& name);

} // namespace shape
