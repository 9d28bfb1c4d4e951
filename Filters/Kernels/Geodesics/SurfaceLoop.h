#pragma once

#include "Base/Progress.h"
#include "Search/ClosestPoint.h"
#include "Geodesics/SurfacePath.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A closed path over a surface that is straight in each triangle.
struct SurfaceLoop
{
  std::vector<SurfacePlace> Places;
  std::vector<int> Triangles; ///< of the stretch from each place to the next one, or to the first
};

/**
 * The loop over a surface through the closest places to n points (n x 3), in order, the last joined
 * to the first, each leg a locally shortest path. locator, paths: of the same surface. Throws
 * InvalidInput where there are fewer than three different places or no path leads on, Aborted.
 */
SurfaceLoop LoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const Progress& progress = {});

} // namespace shape
