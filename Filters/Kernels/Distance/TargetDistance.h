#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * How far the images of a boundary's points lie from the target surface, root mean square, divided
 * by the longest side of the target: the error of the boundary map itself, which a harmonic map
 * inherits.
 *
 * boundary: closed; targets (n x 3, finite): the images of its points. Throws InvalidInput if
 * the target is not closed, or its components have other genera than the boundary's: then no
 * continuous map takes one onto the other one to one; Aborted.
 */
double ComputeTargetDistance(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const Progress& progress = {});

} // namespace shape
