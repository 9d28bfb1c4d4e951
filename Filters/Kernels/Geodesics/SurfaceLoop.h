#pragma once

#include "Base/Progress.h"
#include "Geodesics/CreasePath.h"
#include "Geodesics/SurfacePath.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/**
 * Joins polylines to closed curves. A polyline may be closed itself, or be joined end to end with
 * others, given in any order and direction. Each curve has the direction of its first polyline.
 * Points at exactly the same position are treated as one.
 *
 * points: n x 3. polylines: for each polyline, the indices of its points in order. name: the name
 * of the data in error messages. Returns the points of each curve (k x 3); the last point is joined
 * to the first. Throws InvalidInput with the end position if a curve is open.
 */
std::vector<Eigen::MatrixXd> ChainClosedCurves(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const std::string& name);

/// A closed path on a surface that is straight in each triangle.
struct SurfaceLoop
{
  std::vector<SurfacePoint> Positions;
  /// for each position, the triangle of the segment to the next position; the last position is
  /// followed by the first
  std::vector<int> Triangles;
};

/**
 * Traces a loop on a surface. It runs, in order, through the surface positions closest to the given
 * points (n x 3), and from the last back to the first. Each leg is a locally shortest path. If
 * CreaseWeight is positive, positions near creases move onto them (CreasePaths::MoveToCrease), and
 * legs follow creases (CreasePaths::Find). locator and paths must belong to the same surface.
 * Throws InvalidInput if an option is out of range, there are fewer than three different positions,
 * or there is no path between two consecutive positions; Aborted.
 */
SurfaceLoop TraceLoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const CreaseOptions& creases = {}, const Progress& progress = {});

} // namespace shape
