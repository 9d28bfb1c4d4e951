#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct Eigenpairs
{
  Eigen::VectorXd Values;  ///< k
  Eigen::MatrixXd Vectors; ///< n x k, orthonormal
};

/// Computes the `count` largest eigenvalues of a dense symmetric matrix, descending, and their
/// eigenvectors (LAPACK's syevd). Only the lower triangular part is read. count: from 1 to the size
/// of the matrix. Throws SolveFailure if the computation does not converge or if a value of the
/// matrix is not finite, std::bad_alloc, and Aborted.
Eigenpairs FindLargestEigenpairs(Eigen::MatrixXd matrix, int count, const Progress& progress = {});

/// Gives each column the sign that makes its entry of the greatest magnitude positive. Of entries
/// that differ by rounding, the first one decides.
void FixSigns(Eigen::MatrixXd& columns);

} // namespace shape
