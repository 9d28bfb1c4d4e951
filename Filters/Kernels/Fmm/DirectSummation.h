#pragma once

#include "Base/Progress.h"
#include "Fmm/InverseDistance.h"
#include "Fmm/SumDevice.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes the potentials of point charges, phi(y_i) = sum_j q_j / (4 pi |y_i - x_j|), by direct
 * summation.
 *
 * sources: m x 3, the x_j. charges: m x k; each column gives one potential. points: n x 3, the y_i.
 * Returns n x k potentials. On any processor, the relative error of each term is about 1e-15
 * (rounding), unless `error` allows more; an OpenCL device allows none. The cost is O(m n). The
 * values at a point have the same bits for any number of threads and, on the same device, for any
 * set of other points. They are not finite if the distance of the point from a source is less than
 * 1e-18 times the sources' largest coordinate. Throws InvalidInput if the numbers of rows or
 * columns do not match or there is no such device (ChooseOpenCL), and Aborted.
 */
Eigen::MatrixXd SumPotentialsDirectly(const Eigen::MatrixXd& sources,
  const Eigen::MatrixXd& charges, const Eigen::MatrixXd& points,
  RootError error = RootError::Rounding, const Progress& progress = {},
  const SumDevice& device = {});

/// Computes the gradients of the same potentials. Returns n x 3k: column 3 r + c is
/// d phi_r / d y_c.
Eigen::MatrixXd SumGradientsDirectly(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges,
  const Eigen::MatrixXd& points, const Progress& progress = {}, const SumDevice& device = {});

} // namespace shape
