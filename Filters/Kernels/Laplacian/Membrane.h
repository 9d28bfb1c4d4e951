#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Values at all points (n x d) of a patch from those at its rim, its first points (k x d): harmonic
 * inside, by the cotangent weights of the intrinsic Delaunay triangulation
 * (BuildIntrinsicDelaunay), so that each lies between those of the rim, and linear ones on a plane
 * stay linear.
 *
 * Throws SolveFailure where a part of the patch does not hang together with the rim.
 */
Eigen::MatrixXd SolveHarmonicValues(const Mesh& patch, const Eigen::MatrixXd& loopValues);

/**
 * The membrane that a rim spans: places of the points of a disk (n x 3), the first of them the rim
 * (k x 3), whose mean curvature vectors are as good as zero: "the membrane surface should be as
 * close to both minimal area and developable as possible [...] a minimal mean-curvature mesh
 * suffices" (Schmidt and Singh, "Drag-and-drop surface composition", section 4.1). The disk's
 * harmonic map first, then `rounds` times that of what it became (Pinkall and Polthier, "Computing
 * discrete minimal surfaces and their conjugates", 1993).
 *
 * disk: n points in the plane or in space, the rim first. Throws as above, Aborted.
 */
Eigen::MatrixXd SolveMembrane(
  const Mesh& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress = {});

} // namespace shape
