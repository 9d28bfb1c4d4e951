#pragma once

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
/// of the matrix. The computation is one library call that cannot be interrupted. Throws
/// SolveFailure if it does not converge or if a value of the matrix is not finite, and
/// std::bad_alloc.
Eigenpairs FindLargestEigenpairs(Eigen::MatrixXd matrix, int count);

} // namespace shape
