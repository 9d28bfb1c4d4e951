#include "Linear/SymmetricEigen.h"

#include "Base/Errors.h"
#include "Base/LibraryCall.h"
#include "Base/Parallel.h"

#include <cmath>
#include <lapacke.h>
#include <new>
#include <string>

namespace shape
{

Eigenpairs FindLargestEigenpairs(Eigen::MatrixXd matrix, int count, const Progress& progress)
{
  const auto size = static_cast<lapack_int>(matrix.rows());
  Eigen::VectorXd values(size);
  const BlasThreads threads(BlasThreads::WorthSharing(size));
  lapack_int status = LAPACK_WORK_MEMORY_ERROR;
  RunInterruptibly(
    [&] {
      status = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', size, matrix.data(), size, values.data());
    },
    9.0 * std::pow(size, 3.0),
    { { &status, sizeof(status) }, { values.data(), values.size() * sizeof(double) },
      { matrix.data(), matrix.size() * sizeof(double) } },
    progress);
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

void FixSigns(Eigen::MatrixXd& columns)
{
  for (Eigen::Index c = 0; c < columns.cols(); ++c)
  {
    const double greatest = (1.0 - 1e-6) * columns.col(c).cwiseAbs().maxCoeff();
    Eigen::Index at = 0;
    while (std::abs(columns(at, c)) < greatest)
    {
      ++at;
    }
    if (columns(at, c) < 0.0)
    {
      columns.col(c) *= -1.0;
    }
  }
}

} // namespace shape
