#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Values at all points (n x d) of a patch from those on its boundary loop, its first points (k x
 * d): harmonic inside, by the cotangent weights of the intrinsic Delaunay triangulation
 * (GetIntrinsicLaplacian). So each lies between those of the loop, and linear values on a plane
 * stay linear.
 *
 * Throws SolveFailure if a part of the patch is not connected with the loop.
 */
Eigen::MatrixXd SolveHarmonicValues(const Surface& patch, const Eigen::MatrixXd& loopValues);

/**
 * The membrane that a closed curve spans: positions of the points of a disk (n x 3), the first of
 * them the curve (k x 3), whose mean curvature vectors are nearly zero: "the membrane surface
 * should be as close to both minimal area and developable as possible [...] a minimal
 * mean-curvature mesh suffices" (Schmidt and Singh, "Drag-and-drop surface composition",
 * section 4.1). The disk's harmonic map first, then `rounds` times that of what it became (Pinkall
 * and Polthier, "Computing discrete minimal surfaces and their conjugates", 1993).
 *
 * disk: n points in the plane or in space, those of the loop first. Throws as above, Aborted.
 */
Eigen::MatrixXd SolveMembrane(
  const Surface& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress = {});

} // namespace shape
