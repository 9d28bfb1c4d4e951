#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Returns the root mean square distance between the images of a boundary's points and the target
 * surface. It is divided by the longest edge of the target's bounding box. This is the error of the
 * boundary map. A harmonic map with these boundary values inherits it.
 *
 * boundary: closed. targets (n x 3, finite): the images of its points. Throws InvalidInput if the
 * target is not closed. Also throws InvalidInput if the components of target and boundary differ in
 * genus, because then no continuous one-to-one map between the two surfaces exists. Throws Aborted.
 */
double ComputeTargetDistance(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const Progress& progress = {});

} // namespace shape
