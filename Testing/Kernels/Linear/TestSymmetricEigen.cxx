#include "Linear/SymmetricEigen.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

TEST(FindLargestEigenpairs, SolveTheEigenvalueEquationInFallingOrder)
{
  std::mt19937_64 generator(3);
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(
    40, 40, [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; });
  const Eigen::MatrixXd matrix = half + half.transpose();
  const shape::Eigenpairs all = shape::FindLargestEigenpairs(matrix, 40);
  EXPECT_NEAR(all.Values.sum(), matrix.trace(), 1e-12 * matrix.norm());
  const shape::Eigenpairs some = shape::FindLargestEigenpairs(matrix, 7);
  ASSERT_EQ(some.Vectors.cols(), 7);
  EXPECT_LT((some.Values - all.Values.head(7)).norm(), 1e-12 * matrix.norm());
  for (Eigen::Index k = 0; k < 7; ++k)
  {
    const Eigen::VectorXd vector = some.Vectors.col(k);
    EXPECT_NEAR(vector.norm(), 1.0, 1e-12);
    EXPECT_LT((matrix * vector - some.Values(k) * vector).norm(), 1e-12 * matrix.norm());
    EXPECT_GE(some.Values(k), all.Values(k + 1));
  }
}

} // namespace
