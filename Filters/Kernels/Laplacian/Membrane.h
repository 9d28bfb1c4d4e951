#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes values (n x d) at the n points of a patch from given values (k x d) on its boundary
 * loop, which consists of the first k points. The values are harmonic inside, with the cotangent
 * weights of the intrinsic Delaunay triangulation (GetIntrinsicLaplacian). So each value lies
 * between the minimum and the maximum on the loop, and linear values on a plane are reproduced.
 *
 * Throws SolveFailure if a part of the patch is not connected to the loop, or when
 * GetIntrinsicLaplacian does.
 */
Eigen::MatrixXd SolveHarmonicValues(
  const Surface& patch, const Eigen::MatrixXd& loopValues, const Progress& progress = {});

/**
 * Computes the membrane spanned by a closed curve. Returns the positions (n x 3) of the points of a
 * disk, whose first k points are those of the curve. The mean curvature vectors inside are nearly
 * zero: "the membrane surface should be as close to both minimal area and developable as possible
 * [...] a minimal mean-curvature mesh suffices" (Schmidt and Singh, "Drag-and-drop surface
 * composition", section 4.1). The computation starts with the harmonic map of the disk, then solves
 * `rounds` times for the harmonic map of the result (Pinkall and Polthier, "Computing discrete
 * minimal surfaces and their conjugates", 1993).
 *
 * disk: n points in the plane or in space; the first k are those of its loop. loop: k x 3, the
 * positions of the curve. Throws SolveFailure when SolveHarmonicValues does; Aborted.
 */
Eigen::MatrixXd SolveMembrane(
  const Surface& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress = {});

} // namespace shape
