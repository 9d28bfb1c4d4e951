#include "Base/Errors.h"
#include "Linear/DenseSolve.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

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

TEST(SingularValues, AreThoseOfEigenWithTheirVectors)
{
  for (const auto& [rows, columns] : { std::pair(30, 12), std::pair(12, 30), std::pair(9, 9) })
  {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(rows, columns);
    const shape::SingularValues svd(a);
    const Eigen::JacobiSVD<Eigen::MatrixXd> truth(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
    EXPECT_LT((svd.Values() - truth.singularValues()).norm(), 1e-12);
    const Eigen::MatrixXd vectors = svd.RightVectors(2);
    ASSERT_EQ(vectors.rows(), columns);
    ASSERT_EQ(vectors.cols(), 7 + std::min(rows, columns) - 9);
    EXPECT_LT((vectors.transpose() * vectors).diagonal().array().abs().maxCoeff() - 1.0, 1e-12);
    const Eigen::VectorXd stretched = (a * vectors).colwise().norm();
    EXPECT_LT((stretched - svd.Values().tail(vectors.cols())).norm(), 1e-12);
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(rows, 3);
    EXPECT_LT((svd.Solve(b, 1e-12) - truth.solve(b)).norm(), 1e-10);
  }
}

TEST(SingularValues, RefusesWhatIsNotFinite)
{
  EXPECT_THROW(shape::SingularValues(Eigen::MatrixXd(0, 0)), shape::InvalidInput);
  EXPECT_THROW(shape::SingularValues(
                 Eigen::MatrixXd::Constant(2, 2, std::numeric_limits<double>::quiet_NaN())),
    shape::InvalidInput);
}
