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

/// A closed path over a surface that is straight in each triangle.
struct SurfaceLoop
{
  std::vector<SurfacePoint> Positions;
  std::vector<int>
    Triangles; ///< of the segment from each position to the next one, or to the first
};

/**
 * The loop over a surface through the closest positions to n points (n x 3), in order, the last
 * joined to the first, each leg a locally shortest path. locator, paths: of the same surface.
 * Throws InvalidInput if there are fewer than three different positions or no path leads on,
 * Aborted.
 */
SurfaceLoop TraceLoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const Progress& progress = {});

} // namespace shape
