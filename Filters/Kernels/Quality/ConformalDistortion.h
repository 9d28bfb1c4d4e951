#pragma once

#include "Mesh/Mesh.h"

namespace shape
{

/**
 * How far the map that takes each triangle of `mesh` affinely to its image is from keeping angles:
 * (s / t + t / s) / 2 for its singular values s >= t; 1 for a similarity.
 *
 * images: n x 3, of the points. Returns m values >= 1; infinite where an image has no area, and 1
 * where the triangle itself has none, since every map of it can be called conformal.
 */
Eigen::VectorXd ComputeConformalDistortion(const Mesh& mesh, const Eigen::MatrixXd& images);

} // namespace shape
