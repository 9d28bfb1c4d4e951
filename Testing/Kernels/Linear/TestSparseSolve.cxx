#include "Base/Errors.h"
#include "Linear/SparseSolve.h"

#include <gtest/gtest.h>

namespace
{

/// The second-difference matrix plus `shift` times the identity.
Eigen::SparseMatrix<double> SecondDifference(int n, double shift)
{
  Eigen::SparseMatrix<double> a(n, n);
  for (int i = 0; i < n; ++i)
  {
    a.insert(i, i) = 2.0 + shift;
    if (i > 0)
    {
      a.insert(i, i - 1) = -1.0;
      a.insert(i - 1, i) = -1.0;
    }
  }
  return a;
}

} // namespace

TEST(SparseCholesky, SolvesTwoSystemsOfOnePattern)
{
  shape::SparseCholesky cholesky;
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(50, 3);
  for (const double shift : { 0.0, 1.0 })
  {
    const Eigen::SparseMatrix<double> a = SecondDifference(50, shift);
    cholesky.Factorize(a);
    EXPECT_LT((a * cholesky.Solve(b) - b).norm(), 1e-10);
  }
}

TEST(SparseCholesky, AnIndefiniteMatrixIsAFailure)
{
  shape::SparseCholesky cholesky;
  EXPECT_THROW(cholesky.Factorize(SecondDifference(10, -3.0)), shape::SolveFailure);
}
