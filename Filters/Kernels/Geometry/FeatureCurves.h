#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// The points of a polyline, in order (n x 3, n >= 2). The first and last points of a closed
/// polyline are equal.
using Curve = Eigen::MatrixXd;

/// Points on curves. The target of each is the point at the same fraction of the paired curve's
/// length.
struct MatchedCurves
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::MatrixXd Targets; ///< k x 3
  Eigen::VectorXi Curves;  ///< k: the index of each point's curve
  /// k: where each point lies on its curve: i + t stands for the fraction t of the segment from
  /// point i to point i + 1
  Eigen::VectorXd Positions;
};

/**
 * Pairs the i-th curve of `sources` with the i-th of `targets` by arc length (the restamping of
 * skeletons in Li et al. 2010, section 4.4). A point at the fraction s of its curve's length is
 * paired with the point at the fraction s of the other curve's length. The two curves may have
 * different numbers of points.
 *
 * The result contains the points of `sources`. Between two consecutive points more than
 * `longestStep` (> 0) apart, it also contains evenly spaced points.
 *
 * `name` denotes the curves in messages. Throws InvalidInput if the numbers of curves differ, or if
 * a curve has no length or a coordinate that is not finite. Also throws InvalidInput if two
 * consecutive points of `sources` are more than 10,000 times `longestStep` apart.
 */
MatchedCurves MatchCurves(const std::vector<Curve>& sources, const std::vector<Curve>& targets,
  double longestStep, const std::string& name);

} // namespace shape
