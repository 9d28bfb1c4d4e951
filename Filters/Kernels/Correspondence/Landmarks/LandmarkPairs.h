#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The points of two surfaces next to places that correspond (k x 3 each), in their order: of the
/// triangle closest to a place the corner that it is nearest to. A pair is left out where one of
/// its points is in a pair already. Throws InvalidInput where a coordinate is not finite or a place
/// is farther from its surface than half the longest side of that, Aborted.
Landmarks PairLandmarks(const Surface& a, const Eigen::MatrixXd& positionsA, const Surface& b,
  const Eigen::MatrixXd& positionsB, const Progress& progress = {});

} // namespace shape
