#pragma once

#include "Base/Progress.h"
#include "Geodesics/SurfacePath.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/**
 * Chains polylines to closed curves. A polyline may close on itself, or be joined end to end with
 * others, in any order and direction. The first polyline of each curve gives its direction. Points
 * at exactly the same position are identified.
 *
 * points: n x 3. polylines: indices of their points in order, two or more. Returns the points of
 * each curve (k x 3), where the last is joined to the first. name: the name of the data in error
 * messages. Throws InvalidInput with the end position if a curve is open.
 */
std::vector<Eigen::MatrixXd> ChainClosedCurves(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const std::string& name);

/// A closed path on a surface that is straight in each triangle.
struct SurfaceLoop
{
  std::vector<SurfacePoint> Positions;
  std::vector<int>
    Triangles; ///< triangle of the segment from each position to the next, or to the first
};

/**
 * Traces the loop on a surface through the closest positions to n points (n x 3), in order, where
 * the last is joined to the first. Each leg is a locally shortest path. locator, paths: of the same
 * surface. Throws InvalidInput if there are fewer than three different positions or there is no
 * path between two of them; Aborted.
 */
SurfaceLoop TraceLoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const Progress& progress = {});

} // namespace shape
