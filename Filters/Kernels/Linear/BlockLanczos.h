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
 * Computes the largest eigenvalues, descending, of a symmetric operator, and their eigenvectors, in
 * the subspace orthogonal to some known eigenvectors. The method is block Lanczos iteration with
 * full orthogonalisation and thick restarts (Wu and Simon, "Thick-restart Lanczos method for large
 * symmetric eigenvalue problems", SIAM J. Matrix Anal. Appl. 22, 2000). Blocks allow matrix-matrix
 * products. The residual of each pair is at most `tolerance` times its eigenvalue.
 *
 * known: n x c, orthonormal eigenvectors to exclude. wanted: >= 1, at most about n / 3. Throws
 * SolveFailure if the iteration does not converge, and Aborted.
 */
Eigenpairs FindExtremeEigenpairs(const SymmetricOperator& apply, const Eigen::MatrixXd& known,
  int wanted, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
