#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * Scales positions (s x d) to the minimum of the stress sum (wanted - current distance)^2, and
 * returns that minimum. `transformed` is their Guttman transform, the next iterate of majorisation
 * (Smacof.h). Row j is the sum over i of wanted / current distance times (x_j - x_i), divided by s;
 * it does not change if all positions are scaled. distances: s x s, symmetric, 0 on the diagonal.
 * The last bits of the result depend on the width of the processor's vectors.
 */
double TransformByGuttman(
  const Eigen::MatrixXd& distances, Eigen::MatrixXd& positions, Eigen::MatrixXd& transformed);

} // namespace shape
