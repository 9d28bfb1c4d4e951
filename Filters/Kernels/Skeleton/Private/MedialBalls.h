#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// For each of n points of a surface, a ball inside that touches it there: a ball of the medial
/// axis.
struct MedialBalls
{
  Eigen::MatrixXd Centres; ///< n x 3
  Eigen::VectorXd Radii;   ///< n values, each >= 0
};

/**
 * Finds the medial balls at the points of a closed surface that faces outwards, by shrinking (Ma,
 * Bae and Choi, "3D medial axis point approximation using nearest neighbors and the normal field",
 * 2012). A ball that touches the surface at point p, with its centre on the inward normal, shrinks
 * until no other point is inside.
 *
 * A ball stops to shrink where it would touch the surface at two points that its centre sees within
 * 40 degrees: those are the noise of the surface, not two sides of it (section 5 of that paper
 * calls them denoising by the separation angle). The points should be evenly dense. Throws Aborted.
 */
MedialBalls ShrinkMedialBalls(const Mesh& surface, const Progress& progress = {});

} // namespace shape
