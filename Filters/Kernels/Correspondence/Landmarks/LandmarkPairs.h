#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The points of two surfaces next to positions that correspond (k x 3 each), in their order: of
/// the triangle closest to a position the nearest corner. A pair is left out if one of its points
/// is in a pair already. Throws InvalidInput if a coordinate is not finite or a position is farther
/// from its surface than half the longest edge of the surface's box, Aborted.
Landmarks PairLandmarks(const Surface& a, const Eigen::MatrixXd& positionsA, const Surface& b,
  const Eigen::MatrixXd& positionsB, const Progress& progress = {});

} // namespace shape
