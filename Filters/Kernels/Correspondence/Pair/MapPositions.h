#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Returns the images of positions inside triangles, of which a map gives the images of the corners.
 * The mean of these, with the barycentric coordinates, may be off the target. It is reached by a
 * walk on the target's triangles, which starts at the image of the nearest corner and cannot jump
 * to another sheet (WalkToPositions).
 *
 * positions: on triangles (m x 3). images: of the corners of these, on triangles of `target`.
 * Throws Aborted.
 */
SurfacePoints MapPositions(const SurfacePoints& positions, const Eigen::MatrixXi& triangles,
  const SurfacePoints& images, const Surface& target, const Progress& progress = {});

} // namespace shape
