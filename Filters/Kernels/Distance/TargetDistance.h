#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Returns the root mean square distance of the images of a boundary's points from the target
 * surface, divided by the longest edge of the target's bounding box. This is the error of the
 * boundary map itself, which a harmonic map inherits.
 *
 * boundary: closed. targets (n x 3, finite): the images of its points. Throws InvalidInput if the
 * target is not closed, or if the genera of its components differ from the boundary's: no
 * continuous one-to-one map between them exists then. Throws Aborted.
 */
double ComputeTargetDistance(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const Progress& progress = {});

} // namespace shape
