#include "Core/DenseSolve.h"

#include "Core/Errors.h"
#include "Core/Parallel.h"

#include <algorithm>
#include <lapacke.h>
#include <new>
#include <string>

namespace shape
{

SingularValues::SingularValues(Eigen::MatrixXd a)
{
  if (a.size() == 0 || !a.allFinite())
  {
    throw InvalidInput("the matrix to decompose is empty or has a value that is not finite");
  }
  const lapack_int rows = static_cast<lapack_int>(a.rows());
  const lapack_int columns = static_cast<lapack_int>(a.cols());
  const lapack_int rank = std::min(rows, columns);
  this->U.resize(rows, rank);
  this->S.resize(rank);
  this->Vt.resize(rank, columns);
  const BlasThreads threads;
  const lapack_int status = LAPACKE_dgesdd(LAPACK_COL_MAJOR, 'S', rows, columns, a.data(), rows,
    this->S.data(), this->U.data(), rows, this->Vt.data(), rank);
  if (status < 0)
  {
    throw std::bad_alloc(); // the arguments are right, so LAPACKE had no memory for its own room
  }
  if (status > 0)
  {
    throw SolveFailure("the singular value decomposition of a " + std::to_string(rows) + " x " +
      std::to_string(columns) + " matrix did not converge; change the number of sources");
  }
}

Eigen::MatrixXd SingularValues::Solve(const Eigen::MatrixXd& b, double threshold) const
{
  const int rank = this->Rank(threshold);
  const Eigen::MatrixXd projected = this->U.leftCols(rank).transpose() * b;
  return this->Vt.topRows(rank).transpose() *
    (this->S.head(rank).cwiseInverse().asDiagonal() * projected);
}

int SingularValues::Rank(double threshold) const
{
  return static_cast<int>((this->S.array() >= threshold).count());
}

} // namespace shape
