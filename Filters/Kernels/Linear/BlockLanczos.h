#pragma once

#include "Base/Progress.h"
#include "Linear/SymmetricEigen.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/// Multiplies a symmetric n x n matrix by n x k columns.
using SymmetricOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& columns)>;

/**
 * Computes the largest eigenvalues of a symmetric operator, descending, and their eigenvectors.
 * Known eigenvectors can be excluded: the result is orthogonal to them. The method is block Lanczos
 * iteration with full orthogonalisation and thick restarts (Wu and Simon, "Thick-restart Lanczos
 * method for large symmetric eigenvalue problems", SIAM J. Matrix Anal. Appl. 22, 2000). With
 * blocks, the operator is applied to several columns at once. The residual of each pair is at most
 * `tolerance` times its eigenvalue.
 *
 * known: n x c, orthonormal eigenvectors to exclude. wanted: the number of pairs; >= 1, and at most
 * about n / 3. Throws SolveFailure if the iteration does not converge, and Aborted.
 */
Eigenpairs FindExtremeEigenpairs(const SymmetricOperator& apply, const Eigen::MatrixXd& known,
  int wanted, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
