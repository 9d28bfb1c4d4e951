#include "Core/DenseSolve.h"
#include "Core/Errors.h"

#include <gtest/gtest.h>

#include <limits>

TEST(SingularValues, SolvesAnOverdeterminedSystemInTheLeastSquaresSense)
{
  Eigen::MatrixXd a(4, 2);
  a << 1, 0, 1, 1, 1, 2, 1, 3;
  Eigen::MatrixXd b(4, 1);
  b << 1, 3, 4, 7;
  const Eigen::MatrixXd x = shape::SingularValues(a).Solve(b, 1e-12);
  // The residual of a least-squares solution is orthogonal to the columns.
  EXPECT_LT((a.transpose() * (a * x - b)).norm(), 1e-12);
}

TEST(SingularValues, TheThresholdGivesTheLeastNormSolutionOfASingularSystem)
{
  Eigen::MatrixXd a(2, 3);
  a << 1, 1, 0, 1, 1, 0;
  Eigen::MatrixXd b(2, 1);
  b << 2, 2;
  const shape::SingularValues svd(a);
  EXPECT_EQ(svd.Rank(1e-5), 1);
  EXPECT_NEAR((svd.Solve(b, 1e-5) - Eigen::Vector3d(1, 1, 0)).norm(), 0.0, 1e-12);
}

TEST(SingularValues, RefusesWhatIsNotFinite)
{
  EXPECT_THROW(shape::SingularValues(Eigen::MatrixXd(0, 0)), shape::InvalidInput);
  EXPECT_THROW(shape::SingularValues(
                 Eigen::MatrixXd::Constant(2, 2, std::numeric_limits<double>::quiet_NaN())),
    shape::InvalidInput);
}
