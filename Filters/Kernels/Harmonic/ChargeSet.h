#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/**
 * A harmonic map of space, as the field of point charges and an affine part:
 *
 *   f(y) = A y + b + sum_j Charges_j / (4 pi |y - Points_j|)
 *
 * (Li et al., "Feature-aligned harmonic volumetric mapping using MFS", 2010, eqs. 1 and 2, with the
 * affine part solved explicitly). It is harmonic wherever no charge sits.
 */
struct ChargeSet
{
  Eigen::MatrixXd Points = Eigen::MatrixXd(0, 3);  ///< k x 3, where the charges sit
  Eigen::MatrixXd Charges = Eigen::MatrixXd(0, 3); ///< k x 3, one weight for each coordinate of f
  Eigen::Matrix<double, 3, 4> Affine = Eigen::Matrix<double, 3, 4>::Identity(); ///< [A b]
};

/// f at `points` (n x 3), n x 3. Large sums are taken by the multipole method (FmmSummation.h)
/// where that is faster and its root mean square error no more than `error` of the image's size.
/// The same bits for any number of threads; not finite at a charge's own place. Throws Aborted.
Eigen::MatrixXd Evaluate(const ChargeSet& set, const Eigen::MatrixXd& points,
  const Progress& progress = {}, double error = 1e-10);

/// The derivative of f at `points`, n x 9: column 3 r + c is d f_r / d y_c. The same bits for any
/// number of threads; not finite at a charge's own place. Throws Aborted.
Eigen::MatrixXd EvaluateJacobians(
  const ChargeSet& set, const Eigen::MatrixXd& points, const Progress& progress = {});

/// The potentials 1 / (4 pi |y_i - x_j|): points' count x sources' count. Throws Aborted.
Eigen::MatrixXd BuildPotentialMatrix(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources, const Progress& progress = {});

} // namespace shape
