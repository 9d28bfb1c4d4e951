#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

/// Returns, for each finite position (k x 3), the nearest corner of the closest triangle. name: of
/// the surface, in messages. Throws InvalidInput if a position is farther from the surface than
/// half the longest edge of its bounding box; Aborted.
Eigen::VectorXi FindNearestPoints(const Surface& surface, const Eigen::MatrixXd& positions,
  const std::string& name, const Progress& progress = {});

/// Pairs points of two surfaces. Each pair consists of the points nearest to two corresponding
/// positions (k x 3 each), in the order of the positions. The point nearest to a position is the
/// nearest corner of the closest triangle. A pair is left out if one of its points is in an earlier
/// pair. Throws InvalidInput if a coordinate is not finite or a position is farther from its
/// surface than half the longest edge of the surface's bounding box; Aborted.
Landmarks PairLandmarks(const Surface& a, const Eigen::MatrixXd& positionsA, const Surface& b,
  const Eigen::MatrixXd& positionsB, const Progress& progress = {});

} // namespace shape
