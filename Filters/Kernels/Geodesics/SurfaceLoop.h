#pragma once

#include "Base/Progress.h"
#include "Geodesics/SurfacePath.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

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
