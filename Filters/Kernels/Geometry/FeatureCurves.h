#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A polyline: its points in order (n x 3, n >= 2). A closed one repeats its first point at the
/// end.
using Curve = Eigen::MatrixXd;

/// Points of curves, and the points at the same fraction of the length of the paired curves.
struct MatchedCurves
{
  Eigen::MatrixXd Points;    ///< k x 3
  Eigen::MatrixXd Targets;   ///< k x 3
  Eigen::VectorXi Curves;    ///< k: the index of each point's curve
  Eigen::VectorXd Positions; ///< k: i + t, at the fraction t of the segment from point i to i + 1
};

/**
 * Pairs the i-th curve of `sources` with the i-th of `targets` by arc length (the restamping of
 * skeletons in Li et al. 2010, section 4.4). A point at the fraction s of its curve's length goes
 * to the point at the fraction s of the other's length. The numbers of points may differ.
 *
 * The result contains the points of `sources`, and further evenly spaced points between two that
 * are more than `longestStep` (> 0) apart.
 *
 * `name` is used for the curves in messages. Throws InvalidInput if the numbers of curves differ,
 * or if a curve has no length or non-finite coordinates. Throws it also if two consecutive points
 * of `sources` are more than 10,000 steps apart.
 */
MatchedCurves MatchCurves(const std::vector<Curve>& sources, const std::vector<Curve>& targets,
  double longestStep, const std::string& name);

} // namespace shape
