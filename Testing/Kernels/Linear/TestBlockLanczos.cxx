#include "Linear/BlockLanczos.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace
{

/// A symmetric matrix with these eigenvalues; its eigenvectors are those of the unit matrix after
/// two reflections.
class Reflected
{
public:
  explicit Reflected(Eigen::VectorXd values)
    : Values(std::move(values))
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (Eigen::VectorXd& normal : this->Normals)
    {
      normal = Eigen::VectorXd::NullaryExpr(this->Values.size(), [&] { return uniform(random); });
      normal.normalize();
    }
  }

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const
  {
    return this->Turned(this->Values.asDiagonal() * this->TurnedBack(columns));
  }

  Eigen::MatrixXd Vectors(int count) const
  {
    return this->Turned(Eigen::MatrixXd::Identity(this->Values.size(), count));
  }

private:
  static void Reflect(const Eigen::VectorXd& normal, Eigen::MatrixXd& columns)
  {
    columns -= 2.0 * normal * (normal.transpose() * columns).eval();
  }

  Eigen::MatrixXd Turned(Eigen::MatrixXd columns) const
  {
    Reflect(this->Normals[0], columns);
    Reflect(this->Normals[1], columns);
    return columns;
  }

  Eigen::MatrixXd TurnedBack(Eigen::MatrixXd columns) const
  {
    Reflect(this->Normals[1], columns);
    Reflect(this->Normals[0], columns);
    return columns;
  }

  Eigen::VectorXd Values;
  Eigen::VectorXd Normals[2];
};

Eigen::VectorXd Falling(int n)
{
  return Eigen::VectorXd::LinSpaced(n, 1.0, n).cwiseInverse();
}

void ExpectPairs(
  const Reflected& matrix, const Eigen::VectorXd& wanted, const shape::Eigenpairs& pairs)
{
  ASSERT_EQ(pairs.Values.size(), wanted.size());
  EXPECT_LT((pairs.Values - wanted).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd gram = pairs.Vectors.transpose() * pairs.Vectors;
  EXPECT_LT(
    (gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-11);
  const Eigen::MatrixXd residuals =
    matrix(pairs.Vectors) - pairs.Vectors * pairs.Values.asDiagonal();
  EXPECT_LT(
    (residuals.colwise().norm().transpose().array() / pairs.Values.array()).maxCoeff(), 2e-9);
}

} // namespace

TEST(BlockLanczos, FindsTheLargestEigenvaluesAndTheirVectors)
{
  const Eigen::VectorXd values = Falling(3000);
  const Reflected matrix(values);
  const shape::Eigenpairs pairs =
    shape::FindExtremeEigenpairs(matrix, Eigen::MatrixXd(3000, 0), 150);
  ExpectPairs(matrix, values.head(150), pairs);
  // Alone, so each is determined but for its sign.
  EXPECT_GT(
    (pairs.Vectors.transpose() * matrix.Vectors(150)).diagonal().cwiseAbs().minCoeff(), 1.0 - 1e-9);
}

TEST(BlockLanczos, FindsMoreEqualOnesThanItsBlocksHaveColumns)
{
  Eigen::VectorXd values = Falling(1000);
  values.head(50).setConstant(2.0);
  const Reflected matrix(values);
  ExpectPairs(
    matrix, values.head(80), shape::FindExtremeEigenpairs(matrix, Eigen::MatrixXd(1000, 0), 80));
}

TEST(BlockLanczos, DoesNotFindWhatIsKnown)
{
  const Eigen::VectorXd values = Falling(1000);
  const Reflected matrix(values);
  const Eigen::MatrixXd known = matrix.Vectors(20);
  const shape::Eigenpairs pairs = shape::FindExtremeEigenpairs(matrix, known, 30);
  ExpectPairs(matrix, values.segment(20, 30), pairs);
  EXPECT_LT((known.transpose() * pairs.Vectors).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(BlockLanczos, GoesOnWhereABlockBringsNothingNew)
{
  // Two eigenvalues: the second block lies in what the first one spans.
  Eigen::VectorXd values = Eigen::VectorXd::Constant(500, 1.0);
  values.head(40).setConstant(3.0);
  const Reflected matrix(values);
  Eigen::VectorXd wanted = Eigen::VectorXd::Constant(60, 1.0);
  wanted.head(40).setConstant(3.0);
  ExpectPairs(matrix, wanted, shape::FindExtremeEigenpairs(matrix, Eigen::MatrixXd(500, 0), 60));
}
