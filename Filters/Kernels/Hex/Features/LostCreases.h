#pragma once

#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <set>
#include <vector>

namespace shape
{

/// A curve on a surface as a polyline (k x 3). A closed curve ends at its first point.
using CreaseLine = Eigen::MatrixXd;

/// Returns the curves of a surface as polylines.
std::vector<CreaseLine> BuildCreaseLines(const Mesh& surface, const SurfaceFeatures& features);

/// Returns the total length of polylines.
double ComputeLength(const std::vector<CreaseLine>& lines);

/// Returns the position half way along a polyline.
Eigen::RowVector3d FindMidpoint(const CreaseLine& line);

/// Returns those of the lines that others do not cover: a point of the line, or the middle of one
/// of its edges, is farther than `tolerance` from all others.
std::vector<CreaseLine> FindUncovered(
  const std::vector<CreaseLine>& lines, const std::vector<CreaseLine>& others, double tolerance);

/// Returns, for each position (k x 3), the index of the curve nearest to it; nothing if there are
/// no curves.
std::set<int> FindNearestCurves(
  const Mesh& surface, const SurfaceFeatures& features, const Eigen::MatrixXd& positions);

/**
 * Gives up some curves: the patches on both sides of each become one. Other curves between these
 * two patches go with them, as do corners at which fewer than three curves are left.
 *
 * curves: indices into features.Curves. CreaseLength stays that of all sharp edges.
 */
SurfaceFeatures WithoutCurves(
  const Surface& surface, const SurfaceFeatures& features, const std::set<int>& curves);

} // namespace shape
