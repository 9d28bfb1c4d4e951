#include "Base/Errors.h"
#include "Linear/SparseSolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

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

/// The Laplacian of a grid of size^3 points with 26 neighbours each, plus `shift` times the
/// identity. Its factor has supernodes of more columns than one product computes.
Eigen::SparseMatrix<double> GridLaplacian(int size, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto inside = [&](int i) { return i >= 0 && i < size; };
  for (int point = 0; point < size * size * size; ++point)
  {
    const int x = point % size, y = point / size % size, z = point / size / size;
    entries.emplace_back(point, point, 26.0 + shift);
    for (int move = 0; move < 27; ++move)
    {
      const int u = x + move % 3 - 1, v = y + move / 3 % 3 - 1, w = z + move / 9 - 1;
      if (move != 13 && inside(u) && inside(v) && inside(w))
      {
        entries.emplace_back(point, u + size * (v + size * w), -1.0);
      }
    }
  }
  const int count = size * size * size;
  Eigen::SparseMatrix<double> a(count, count);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

} // namespace

TEST(SparseCholesky, SolvesALargeSystemWithTheSameBitsForAnyThreads)
{
  const Eigen::SparseMatrix<double> a = GridLaplacian(24, 0.0);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(a.rows(), 2);
  Eigen::MatrixXd solutions[2];
  for (const int threads : { 1, 2 })
  {
    setenv("VTK_SMP_MAX_THREADS", std::to_string(threads).c_str(), 1);
    shape::SparseCholesky cholesky;
    cholesky.Factorize(a);
    solutions[threads - 1] = cholesky.Solve(b);
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_LT((a * solutions[0] - b).norm(), 1e-10 * b.norm());
  EXPECT_EQ(solutions[0], solutions[1]);
}

#ifdef SHAPEMAP_CHOLMOD
TEST(SparseCholesky, ReportsAndCanBeAborted)
{
  const Eigen::SparseMatrix<double> a = GridLaplacian(32, 0.0);
  std::vector<double> shares;
  shape::SparseCholesky cholesky;
  cholesky.Factorize(
    a, shape::Progress([&](double share) { return shares.push_back(share), true; }));
  EXPECT_GT(shares.size(), 20u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.back(), 0.95);
  EXPECT_LE(shares.back(), 1.0);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(a.rows());
  for (const double until : { 0.0, 0.2, 0.5, 0.9 })
  {
    int after = 0;
    const shape::Progress abort(
      [&](double share)
      {
        after += share >= until;
        return share < until;
      });
    shape::SparseCholesky other;
    EXPECT_THROW(other.Factorize(a, abort), shape::Aborted);
    EXPECT_EQ(after, 1) << "it went on after an abort";
    // It can be used after an abort.
    other.Factorize(a);
    EXPECT_EQ(other.Solve(b), cholesky.Solve(b));
  }
}
#endif

TEST(SparseCholesky, AnIndefiniteMatrixWithLargeSupernodesIsAFailure)
{
  shape::SparseCholesky cholesky;
  EXPECT_THROW(cholesky.Factorize(GridLaplacian(14, -3.0)), shape::SolveFailure);
}

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
