#include "Linear/DenseSolve.h"

#include "Base/Errors.h"
#include "Base/LibraryCall.h"
#include "Base/Parallel.h"

#include <lapacke.h>
#include <new>
#include <string>
#include <utility>

namespace shape
{

SingularValues::SingularValues(Eigen::MatrixXd a, const Progress& progress)
  : Wide(a.rows() < a.cols())
{
  if (a.size() == 0 || !a.allFinite())
  {
    throw InvalidInput("the matrix to decompose is empty or has a value that is not finite");
  }
  const std::string size = std::to_string(a.rows()) + " x " + std::to_string(a.cols());
  if (this->Wide)
  {
    a.transposeInPlace();
  }
  this->Reflectors = std::move(a);
  const auto rows = static_cast<lapack_int>(this->Reflectors.rows());
  const auto columns = static_cast<lapack_int>(this->Reflectors.cols());
  this->Factors.resize(columns);
  const BlasThreads threads(BlasThreads::WorthSharing(columns));
  this->U.resize(columns, columns);
  this->S.resize(columns);
  this->Vt.resize(columns, columns);
  lapack_int status = LAPACK_WORK_MEMORY_ERROR;
  const auto decompose = [&]
  {
    // A = Q R, then R = U S V^T. If A is wide, its transpose is factorised.
    status = LAPACKE_dgeqrf(
      LAPACK_COL_MAJOR, rows, columns, this->Reflectors.data(), rows, this->Factors.data());
    if (status == 0)
    {
      Eigen::MatrixXd triangle = this->Reflectors.topRows(columns).triangularView<Eigen::Upper>();
      status = LAPACKE_dgesdd(LAPACK_COL_MAJOR, 'S', columns, columns, triangle.data(), columns,
        this->S.data(), this->U.data(), columns, this->Vt.data(), columns);
    }
  };
  const auto written = [](Eigen::Ref<Eigen::MatrixXd> values) {
    return CallResult{ values.data(), values.size() * sizeof(double) };
  };
  const double n = columns;
  RunInterruptibly(decompose, n * n * (2.0 * rows + 20.0 * n),
    { { &status, sizeof(status) }, written(this->Reflectors), written(this->Factors),
      written(this->U), written(this->S), written(this->Vt) },
    progress);
  if (status < 0)
  {
    throw std::bad_alloc(); // the arguments are valid, so LAPACKE could not allocate its workspace
  }
  if (status > 0)
  {
    throw SolveFailure("the singular value decomposition of a " + size +
      " matrix did not converge; change the number of sources");
  }
}

void SingularValues::ApplyQ(Eigen::MatrixXd& b, bool transposed) const
{
  const auto rows = static_cast<lapack_int>(this->Reflectors.rows());
  const auto reflectors = static_cast<lapack_int>(this->Reflectors.cols());
  const BlasThreads threads(BlasThreads::WorthSharing(reflectors));
  if (LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', transposed ? 'T' : 'N', rows,
        static_cast<lapack_int>(b.cols()), reflectors, this->Reflectors.data(), rows,
        this->Factors.data(), b.data(), rows) != 0)
  {
    throw std::bad_alloc();
  }
}

Eigen::MatrixXd SingularValues::Solve(const Eigen::MatrixXd& b, double threshold) const
{
  const int rank = this->Rank(threshold);
  const auto inverse = this->S.head(rank).cwiseInverse().asDiagonal();
  const Eigen::Index shorter = this->S.size();
  // A = (Q U S V^T)^T, so x = Q U S^-1 V^T b.
  if (this->Wide)
  {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(this->Reflectors.rows(), b.cols());
    x.topRows(shorter) = this->U.leftCols(rank) * (inverse * (this->Vt.topRows(rank) * b).eval());
    this->ApplyQ(x, false);
    return x;
  }
  // A = Q U S V^T, so x = V S^-1 U^T Q^T b.
  Eigen::MatrixXd c = b;
  this->ApplyQ(c, true);
  return this->Vt.topRows(rank).transpose() *
    (inverse * (this->U.leftCols(rank).transpose() * c.topRows(shorter)).eval());
}

Eigen::MatrixXd SingularValues::RightVectors(int first) const
{
  const Eigen::Index count = this->S.size() - first;
  if (!this->Wide)
  {
    return this->Vt.bottomRows(count).transpose();
  }
  // The right singular vectors of a wide matrix are the columns of Q U.
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(this->Reflectors.rows(), count);
  vectors.topRows(this->S.size()) = this->U.rightCols(count);
  if (count > 0)
  {
    this->ApplyQ(vectors, false);
  }
  return vectors;
}

int SingularValues::Rank(double threshold) const
{
  return static_cast<int>((this->S.array() >= threshold).count());
}

} // namespace shape
