#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

struct LandmarksOptions
{
  /// the largest distance of a landmark from its surface, as a share of the diagonal of the
  /// surface's bounding box; > 0
  double MaximumDistance = 0.1;
};

/// Landmarks on a surface.
struct LandmarksResult
{
  Eigen::MatrixXd Positions;    ///< k x 3, on the surface
  double LargestDistance = 0.0; ///< by which a landmark was moved, in the model's units
};

/**
 * Moves each of k positions to the closest position on a surface. No position is also valid.
 *
 * positions: k x 3. name: denotes the surface in errors, for example "Surface A". Throws
 * InvalidInput if a coordinate is not finite, if the surface has no triangle, if a position is
 * farther from it than MaximumDistance, or if two positions have the same closest position;
 * landmarks are numbered from 1 in the message. Throws Aborted.
 */
LandmarksResult ProjectLandmarks(const Surface& surface, const Eigen::MatrixXd& positions,
  const std::string& name, const LandmarksOptions& options = {}, const Progress& progress = {});

} // namespace shape
