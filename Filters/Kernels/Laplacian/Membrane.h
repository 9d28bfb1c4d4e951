#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes values at all points (n x d) of a patch from those on its boundary loop (k x d), which
 * are its first points. They are harmonic inside, by the cotangent weights of the intrinsic
 * Delaunay triangulation (GetIntrinsicLaplacian). So each value lies between those of the loop, and
 * linear values on a plane are reproduced.
 *
 * Throws SolveFailure if a part of the patch is not connected to the loop.
 */
Eigen::MatrixXd SolveHarmonicValues(const Surface& patch, const Eigen::MatrixXd& loopValues);

/**
 * Computes the membrane spanned by a closed curve: positions of the points of a disk (n x 3), the
 * first of them the curve (k x 3). Their mean curvature vectors are nearly zero: "the membrane
 * surface should be as close to both minimal area and developable as possible [...] a minimal
 * mean-curvature mesh suffices" (Schmidt and Singh, "Drag-and-drop surface composition", section
 * 4.1). It starts with the harmonic map of the disk, then solves `rounds` times for the harmonic
 * map of the result (Pinkall and Polthier, "Computing discrete minimal surfaces and their
 * conjugates", 1993).
 *
 * disk: n points in the plane or in space, those of the loop first. Throws as SolveHarmonicValues;
 * Aborted.
 */
Eigen::MatrixXd SolveMembrane(
  const Surface& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress = {});

} // namespace shape
