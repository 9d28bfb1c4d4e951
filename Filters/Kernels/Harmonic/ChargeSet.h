#pragma once

#include "Base/Progress.h"
#include "Fmm/SumDevice.h"

#include <Eigen/Core>

namespace shape
{

/**
 * A harmonic map of space: the field of point charges plus an affine part,
 *
 *   f(y) = A y + b + sum_j Charges_j / (4 pi |y - Points_j|)
 *
 * (Li et al., "Feature-aligned harmonic volumetric mapping using MFS", 2010, eqs. 1 and 2). Unlike
 * the paper, ShapeMap solves for the affine part explicitly. f is harmonic except at the charges.
 */
struct ChargeSet
{
  Eigen::MatrixXd Points = Eigen::MatrixXd(0, 3);  ///< k x 3, positions of the charges
  Eigen::MatrixXd Charges = Eigen::MatrixXd(0, 3); ///< k x 3, one charge for each coordinate of f
  Eigen::Matrix<double, 3, 4> Affine = Eigen::Matrix<double, 3, 4>::Identity(); ///< [A b]
};

/// Returns the values of f (n x 3) at `points` (n x 3). A large sum is computed by the fast
/// multipole method (FmmSummation.h) if this is faster. Its root mean square error is then at most
/// `error` times the size of the image. The result has the same bits for any number of threads. It
/// is not finite at the position of a charge. allPoints, device: as in FmmSummationOptions. Throws
/// InvalidInput if there is no such device, and Aborted.
Eigen::MatrixXd Evaluate(const ChargeSet& set, const Eigen::MatrixXd& points,
  const Progress& progress = {}, double error = 1e-10, Eigen::Index allPoints = 0,
  const SumDevice& device = {});

/// Returns the derivative of f at `points` as n x 9: column 3 r + c is d f_r / d y_c. The result
/// has the same bits for any number of threads. It is not finite at the position of a charge.
/// Throws the same exceptions.
Eigen::MatrixXd EvaluateJacobians(const ChargeSet& set, const Eigen::MatrixXd& points,
  const Progress& progress = {}, const SumDevice& device = {});

/// Returns the derivative in row i of `jacobians`, which has the columns of EvaluateJacobians
/// first.
Eigen::Matrix3d GetJacobian(const Eigen::MatrixXd& jacobians, Eigen::Index i);

/// Returns the matrix of potentials 1 / (4 pi |y_i - x_j|): one row for each point y_i, one column
/// for each source x_j. Throws Aborted.
Eigen::MatrixXd BuildPotentialMatrix(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources, const Progress& progress = {});

} // namespace shape
