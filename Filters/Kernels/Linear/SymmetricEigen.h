#pragma once

#include <Eigen/Core>

namespace shape
{

struct Eigenpairs
{
  Eigen::VectorXd Values;  ///< k
  Eigen::MatrixXd Vectors; ///< n x k, orthonormal
};

/// The `count` largest eigenvalues of a dense symmetric matrix, of which the lower half is read,
/// descending, with their eigenvectors (LAPACK's syevd). count: in [1, the size]. One library call
/// that cannot be interrupted. Throws std::bad_alloc, SolveFailure where it does not converge or a
/// value is not finite.
Eigenpairs FindLargestEigenpairs(Eigen::MatrixXd matrix, int count);

} // namespace shape
