#pragma once

#include "Base/Progress.h"
#include "Fmm/InverseDistance.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The potentials of point charges, phi(y_i) = sum_j q_j / (4 pi |y_i - x_j|), summed pair by pair.
 *
 * sources: m x 3, the x_j; charges: m x k, one column for each potential; points: n x 3, the y_i.
 * Returns n x k. Each term is right to rounding (1e-15), whatever the processor, or to the error
 * given; the cost is m n.
 * A point's values are the same bits for any number of threads and whichever points stand beside
 * it; they are not finite where it coincides with a source (is closer than 1e-18 of their
 * largest coordinate).
 * Throws InvalidInput where the numbers of rows or columns do not fit, Aborted.
 */
Eigen::MatrixXd SumPotentialsDirectly(const Eigen::MatrixXd& sources,
  const Eigen::MatrixXd& charges, const Eigen::MatrixXd& points,
  RootError error = RootError::Rounding, const Progress& progress = {});

/// The gradients of the same potentials: n x 3k, column 3 r + c is d phi_r / d y_c.
Eigen::MatrixXd SumGradientsDirectly(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges,
  const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
