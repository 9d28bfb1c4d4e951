#pragma once

#include "Mesh/Mesh.h"

namespace shape
{

/**
 * Computes how far the affine map of each triangle of `mesh` to its image is from conformal. The
 * measure is (s / t + t / s) / 2 for the map's singular values s >= t; it is 1 for a similarity.
 *
 * images: n x 3, the images of the points. Returns m values >= 1. A value is infinite if the image
 * has no area. It is 1 if the triangle itself has no area, because any map of it can be called
 * conformal.
 */
Eigen::VectorXd ComputeConformalDistortion(const Mesh& mesh, const Eigen::MatrixXd& images);

} // namespace shape
