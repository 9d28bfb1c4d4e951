#pragma once

#include "Base/Progress.h"
#include "Linear/SymmetricEigen.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/// A symmetric n x n matrix times n x k columns.
using SymmetricOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& columns)>;

/**
 * The largest eigenvalues, descending, of a symmetric operator on what is orthogonal to some known
 * columns, with their eigenvectors: the block Lanczos iteration with full orthogonalisation and
 * thick restarts (Wu and Simon, "Thick-restart Lanczos method for large symmetric eigenvalue
 * problems", SIAM J. Matrix Anal. Appl. 22, 2000), in blocks so that the products are those of
 * matrices with matrices. The residual of each pair is at most `tolerance` of its eigenvalue.
 *
 * known: n x c, orthonormal; its columns are eigenvectors that are not looked for. wanted: >= 1, at
 * most n / 3 or so. Throws SolveFailure where the iteration does not end, Aborted.
 */
Eigenpairs FindExtremeEigenpairs(const SymmetricOperator& apply, const Eigen::MatrixXd& known,
  int wanted, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
