#include "Linear/SymmetricEigen.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <lapacke.h>
#include <new>
#include <string>

namespace shape
{

Eigenpairs FindLargestEigenpairs(Eigen::MatrixXd matrix, int count)
{
  const auto size = static_cast<lapack_int>(matrix.rows());
  Eigen::VectorXd values(size);
  const BlasThreads threads(BlasThreads::WorthSharing(size));
  const lapack_int status =
    LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', size, matrix.data(), size, values.data());
  if (status == LAPACK_WORK_MEMORY_ERROR || status == LAPACK_TRANSPOSE_MEMORY_ERROR)
  {
    throw std::bad_alloc();
  }
  if (status != 0)
  {
    throw SolveFailure("the eigenvalues of a symmetric matrix of size " + std::to_string(size) +
      " were not found; check the input for values that are not finite");
  }
  return { values.tail(count).reverse(), matrix.rightCols(count).rowwise().reverse() };
}

} // namespace shape
