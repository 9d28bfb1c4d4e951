#include "Distortion/Distortion.h"
#include "Distortion/SimplexElements.h"
#include "Support/Distortions.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

using shape::Distortion;
using shape::EvaluateDistortion;

namespace
{

using shapetest::AllMeasures;

template <int D>
void ExpectGradientsOfTheValues(const Eigen::Matrix<double, D, 1>& s)
{
  for (const Distortion measure : AllMeasures)
  {
    const shape::DistortionTerms<D> terms = EvaluateDistortion<D>(measure, 0.7, s);
    for (int i = 0; i < D; ++i)
    {
      Eigen::Matrix<double, D, 1> more = s, less = s;
      more(i) += 1e-6;
      less(i) -= 1e-6;
      const double slope = (EvaluateDistortion<D>(measure, 0.7, more).Value -
                             EvaluateDistortion<D>(measure, 0.7, less).Value) /
        2e-6;
      EXPECT_NEAR(terms.Gradient(i), slope, 1e-6 * std::max(1.0, std::abs(slope)))
        << static_cast<int>(measure);
      EXPECT_GT(terms.Weights(i), 0.0);
    }
  }
}

template <int D>
void ExpectLeastAtIsometries()
{
  using Vector = Eigen::Matrix<double, D, 1>;
  const Vector one = Vector::Ones();
  EXPECT_EQ(EvaluateDistortion<D>(Distortion::SymmetricDirichlet, 1.0, one).Value, 2.0 * D);
  EXPECT_EQ(EvaluateDistortion<D>(Distortion::AMIPS, 1.0, one).Value, std::exp(1.5));
  EXPECT_EQ(EvaluateDistortion<D>(Distortion::ConformalAMIPS, 1.0, one).Value, D);
  EXPECT_EQ(EvaluateDistortion<D>(Distortion::Hencky, 1.0, one).Value, 0.0);
  // sqrt(g / (2 (s - 1))) with g = 2 (s - s^-3) tends to 2.
  EXPECT_EQ(EvaluateDistortion<D>(Distortion::SymmetricDirichlet, 1.0, one).Weights(0), 4.0);
  Vector near = one;
  near(0) += 1e-9;
  near(1) -= 1e-9;
  for (const Distortion measure : AllMeasures)
  {
    EXPECT_LT(EvaluateDistortion<D>(measure, 1.0, one).Gradient.cwiseAbs().maxCoeff(), 1e-15);
    const Vector at = EvaluateDistortion<D>(measure, 1.0, one).Weights;
    EXPECT_LT((EvaluateDistortion<D>(measure, 1.0, near).Weights - at).norm(), 1e-6 * at.norm());
  }
}

} // namespace

TEST(Distortion, GradientsAreThoseOfTheValues)
{
  for (const Eigen::Vector2d& s : { Eigen::Vector2d(1.3, 0.8), Eigen::Vector2d(0.9, 0.4),
         Eigen::Vector2d(2.0, 1.5), Eigen::Vector2d(1.0, 1.0) })
  {
    ExpectGradientsOfTheValues<2>(s);
  }
  for (const Eigen::Vector3d& s : { Eigen::Vector3d(1.3, 1.1, 0.8), Eigen::Vector3d(0.9, 0.5, 0.4),
         Eigen::Vector3d(2.0, 1.5, 1.5), Eigen::Vector3d(1.0, 1.0, 1.0) })
  {
    ExpectGradientsOfTheValues<3>(s);
  }
}

TEST(Distortion, IsometriesHaveTheLeastValuesAndTheWeightsTheirLimits)
{
  ExpectLeastAtIsometries<2>();
  ExpectLeastAtIsometries<3>();
}

TEST(Distortion, TheWeightsGiveTheGradient)
{
  // Where c = 1: Weights (s - 1)^2 has the gradient 2 Weights (s - 1).
  const Eigen::Vector3d s(3.0, 1.7, 0.3);
  for (const Distortion measure : { Distortion::SymmetricDirichlet,
         Distortion::ExponentialSymmetricDirichlet, Distortion::Hencky, Distortion::ARAP })
  {
    const auto terms = EvaluateDistortion<3>(measure, 0.3, s);
    const Eigen::Vector3d gradient = 2.0 * terms.Weights.cwiseProduct(s - Eigen::Vector3d::Ones());
    EXPECT_LT((gradient - terms.Gradient).norm(), 1e-13 * gradient.norm());
  }
  // Where c is the root mean square.
  const auto terms = EvaluateDistortion<3>(Distortion::ConformalAMIPS, 1.0, s);
  const double mean = s.norm() / std::sqrt(3.0);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(2.0 * terms.Weights(i) * (s(i) - mean), terms.Gradient(i), 1e-13);
  }
}

TEST(Distortion, AmipsHasTheGradientOfItsFormInSpace)
{
  // Weights (s - c)^2 has the gradient of AMIPS for the c at which AMIPS has none.
  const double exponent = 1e-8; // so that the exponential of the worst one is finite
  for (const Eigen::Vector3d& s : { Eigen::Vector3d(3.0, 1.7, 0.3), Eigen::Vector3d(1e-3, 2.0, 5.0),
         Eigen::Vector3d(0.2, 0.2, 0.2) })
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto terms = EvaluateDistortion<3>(Distortion::AMIPS, exponent, s);
      Eigen::Vector3d centre = s;
      centre(i) = s(i) - terms.Gradient(i) / (2.0 * terms.Weights(i));
      EXPECT_GT(centre(i), 0.0);
      // The exponent's derivative at c, against its value at s.
      const auto at = EvaluateDistortion<3>(Distortion::AMIPS, exponent, centre);
      EXPECT_LT(
        std::abs(at.Gradient(i) / at.Value), 1e-9 * std::abs(terms.Gradient(i) / terms.Value))
        << s.transpose() << ", " << i;
    }
  }
}

TEST(Distortion, DecompositionsMultiplyToTheMatrix)
{
  for (const Eigen::Matrix2d& matrix :
    { (Eigen::Matrix2d() << 1, 2, -3, 4).finished(), (Eigen::Matrix2d() << -1, 0, 0, -1).finished(),
      (Eigen::Matrix2d() << 1e-9, 5, -2e-9, 1).finished() })
  {
    const shape::PositiveDecomposition<2> parts = shape::DecomposePositive(matrix);
    const Eigen::Matrix2d product = parts.U * parts.Singular.asDiagonal() * parts.V.transpose();
    EXPECT_LT((product - matrix).norm(), 1e-14 * matrix.norm());
    EXPECT_NEAR(parts.U.determinant(), 1.0, 1e-14);
    EXPECT_NEAR(parts.V.determinant(), 1.0, 1e-14);
    EXPECT_GE(parts.Singular(0), parts.Singular(1));
    EXPECT_GT(parts.Singular(1), 0.0);
    EXPECT_NEAR(parts.Singular.prod() / matrix.determinant(), 1.0, 1e-14);
  }
}

TEST(Distortion, DecompositionsInSpaceMultiplyToTheMatrix)
{
  for (const Eigen::Matrix3d& matrix :
    { (Eigen::Matrix3d() << 1, 2, 0, -3, 4, 1, 0, 0, 2).finished(),
      (Eigen::Matrix3d() << -1, 0, 0, 0, -1, 0, 0, 0, 1).finished() })
  {
    const auto parts = shape::DecomposePositive(matrix);
    const Eigen::Matrix3d product = parts.U * parts.Singular.asDiagonal() * parts.V.transpose();
    EXPECT_LT((product - matrix).norm(), 1e-14 * matrix.norm());
    EXPECT_NEAR(parts.U.determinant(), 1.0, 1e-14);
    EXPECT_NEAR(parts.V.determinant(), 1.0, 1e-14);
    EXPECT_GT(parts.Singular.minCoeff(), 0.0);
  }
}
