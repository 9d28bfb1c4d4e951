#include "Linear/DenseSolve.h"

#include "Base/Errors.h"
#include "Base/LibraryCall.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <lapacke.h>
#include <new>
#include <string>
#include <utility>

namespace shape
{

SingularValues::SingularValues(Eigen::MatrixXd a, const Progress& progress)
  : Wide(a.rows() < a.cols())
{
  // A column at a time, because a large matrix takes long.
  bool finite = a.size() > 0;
  for (Eigen::Index column = 0; column < a.cols() && finite; ++column)
  {
    progress(0.01 * static_cast<double>(column) / static_cast<double>(a.cols()));
    finite = a.col(column).allFinite();
  }
  if (!finite)
  {
    throw InvalidInput("the matrix to decompose is empty or has a value that is not finite");
  }
  const std::string size = std::to_string(a.rows()) + " x " + std::to_string(a.cols());
  if (this->Wide)
  {
    Eigen::MatrixXd transposed(a.cols(), a.rows());
    ParallelFor(
      static_cast<int>(a.rows()), 64,
      [&](int begin, int end)
      { transposed.middleCols(begin, end - begin) = a.middleRows(begin, end - begin).transpose(); },
      progress.Part(0.01, 0.02));
    a.swap(transposed);
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
    progress.Part(0.02, 1.0));
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

void SingularValues::ApplyQ(Eigen::MatrixXd& b, bool transposed, const Progress& progress) const
{
  // Q is the product of the reflectors in order. They are applied in groups, with a report after
  // each: Q^T applies the first group first, Q the last one.
  constexpr Eigen::Index group = 256;
  const Eigen::Index rows = this->Reflectors.rows(), reflectors = this->Reflectors.cols();
  const Eigen::Index groups = (reflectors + group - 1) / group;
  const BlasThreads threads(BlasThreads::WorthSharing(static_cast<int>(reflectors)));
  for (Eigen::Index i = 0; i < groups; ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(groups));
    const Eigen::Index first = group * (transposed ? i : groups - 1 - i);
    const auto left = static_cast<lapack_int>(rows - first);
    if (LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', transposed ? 'T' : 'N', left,
          static_cast<lapack_int>(b.cols()),
          static_cast<lapack_int>(std::min(group, reflectors - first)),
          &this->Reflectors(first, first), static_cast<lapack_int>(rows), &this->Factors(first),
          &b(first, 0), static_cast<lapack_int>(rows)) != 0)
    {
      throw std::bad_alloc();
    }
  }
}

Eigen::MatrixXd SingularValues::Solve(
  const Eigen::MatrixXd& b, double threshold, const Progress& progress) const
{
  const int rank = this->Rank(threshold);
  const auto inverse = this->S.head(rank).cwiseInverse().asDiagonal();
  const Eigen::Index shorter = this->S.size();
  // A = (Q U S V^T)^T, so x = Q U S^-1 V^T b.
  if (this->Wide)
  {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(this->Reflectors.rows(), b.cols());
    x.topRows(shorter) = this->U.leftCols(rank) * (inverse * (this->Vt.topRows(rank) * b).eval());
    this->ApplyQ(x, false, progress);
    return x;
  }
  // A = Q U S V^T, so x = V S^-1 U^T Q^T b.
  Eigen::MatrixXd c = b;
  this->ApplyQ(c, true, progress);
  return this->Vt.topRows(rank).transpose() *
    (inverse * (this->U.leftCols(rank).transpose() * c.topRows(shorter)).eval());
}

Eigen::MatrixXd SingularValues::RightVectors(int first, const Progress& progress) const
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
    this->ApplyQ(vectors, false, progress);
  }
  return vectors;
}

int SingularValues::Rank(double threshold) const
{
  return static_cast<int>((this->S.array() >= threshold).count());
}

} // namespace shape
