#include "Parameterize/PlanarDistortion.h"
#include "Parameterize/Private/PlanarElements.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

using shape::Distortion;
using shape::EvaluateDistortion;

namespace
{

constexpr Distortion AllMeasures[] = { Distortion::SymmetricDirichlet,
  Distortion::ExponentialSymmetricDirichlet, Distortion::AMIPS, Distortion::ConformalAMIPS,
  Distortion::LogARAP, Distortion::ARAP };

} // namespace

TEST(PlanarDistortion, GradientsAreThoseOfTheValues)
{
  for (const Distortion measure : AllMeasures)
  {
    for (const Eigen::Vector2d& s : { Eigen::Vector2d(1.3, 0.8), Eigen::Vector2d(0.9, 0.4),
           Eigen::Vector2d(2.0, 1.5), Eigen::Vector2d(1.0, 1.0) })
    {
      const shape::DistortionTerms terms = EvaluateDistortion(measure, 0.7, s);
      for (int i = 0; i < 2; ++i)
      {
        Eigen::Vector2d more = s, less = s;
        more(i) += 1e-6;
        less(i) -= 1e-6;
        const double slope = (EvaluateDistortion(measure, 0.7, more).Value -
                               EvaluateDistortion(measure, 0.7, less).Value) /
          2e-6;
        EXPECT_NEAR(terms.Gradient(i), slope, 1e-6 * std::max(1.0, std::abs(slope)))
          << static_cast<int>(measure);
        EXPECT_GT(terms.Weights(i), 0.0);
      }
    }
  }
}

TEST(PlanarDistortion, IsometriesHaveTheLeastValuesAndTheWeightsTheirLimits)
{
  const Eigen::Vector2d one(1.0, 1.0);
  EXPECT_EQ(EvaluateDistortion(Distortion::SymmetricDirichlet, 1.0, one).Value, 4.0);
  EXPECT_EQ(EvaluateDistortion(Distortion::AMIPS, 1.0, one).Value, std::exp(1.5));
  EXPECT_EQ(EvaluateDistortion(Distortion::ConformalAMIPS, 1.0, one).Value, 2.0);
  EXPECT_EQ(EvaluateDistortion(Distortion::LogARAP, 1.0, one).Value, 0.0);
  for (const Distortion measure : AllMeasures)
  {
    EXPECT_LT(EvaluateDistortion(measure, 1.0, one).Gradient.cwiseAbs().maxCoeff(), 1e-15);
  }
  // sqrt(g / (2 (s - 1))) with g = 2 (s - s^-3) tends to 2.
  EXPECT_EQ(EvaluateDistortion(Distortion::SymmetricDirichlet, 1.0, one).Weights(0), 4.0);
  const Eigen::Vector2d near(1.0 + 1e-9, 1.0 - 1e-9);
  for (const Distortion measure : AllMeasures)
  {
    const auto at = EvaluateDistortion(measure, 1.0, one).Weights;
    EXPECT_LT((EvaluateDistortion(measure, 1.0, near).Weights - at).norm(), 1e-6 * at.norm());
  }
}

TEST(PlanarDistortion, TheWeightsGiveTheGradient)
{
  // Where c = 1: Weights (s - 1)^2 has the gradient 2 Weights (s - 1).
  for (const Distortion measure : { Distortion::SymmetricDirichlet,
         Distortion::ExponentialSymmetricDirichlet, Distortion::LogARAP, Distortion::ARAP })
  {
    const Eigen::Vector2d s(1.7, 0.3);
    const auto terms = EvaluateDistortion(measure, 0.3, s);
    const Eigen::Vector2d gradient = 2.0 * terms.Weights.cwiseProduct(s - Eigen::Vector2d::Ones());
    EXPECT_LT((gradient - terms.Gradient).norm(), 1e-13 * gradient.norm());
  }
  // Where c is the geometric mean.
  const Eigen::Vector2d s(3.0, 0.5);
  const auto terms = EvaluateDistortion(Distortion::ConformalAMIPS, 1.0, s);
  const double mean = std::sqrt(s(0) * s(1));
  EXPECT_NEAR(2.0 * terms.Weights(0) * (s(0) - mean), terms.Gradient(0), 1e-13);
  EXPECT_NEAR(2.0 * terms.Weights(1) * (s(1) - mean), terms.Gradient(1), 1e-13);
}

TEST(PlanarDistortion, DecompositionsMultiplyToTheMatrix)
{
  for (const Eigen::Matrix2d& matrix :
    { (Eigen::Matrix2d() << 1, 2, -3, 4).finished(), (Eigen::Matrix2d() << -1, 0, 0, -1).finished(),
      (Eigen::Matrix2d() << 1e-9, 5, -2e-9, 1).finished() })
  {
    const shape::PlanarDecomposition parts = shape::DecomposePlanar(matrix);
    const Eigen::Matrix2d product = parts.U * parts.Singular.asDiagonal() * parts.V.transpose();
    EXPECT_LT((product - matrix).norm(), 1e-14 * matrix.norm());
    EXPECT_NEAR(parts.U.determinant(), 1.0, 1e-14);
    EXPECT_NEAR(parts.V.determinant(), 1.0, 1e-14);
    EXPECT_GE(parts.Singular(0), parts.Singular(1));
    EXPECT_GT(parts.Singular(1), 0.0);
    EXPECT_NEAR(parts.Singular.prod() / matrix.determinant(), 1.0, 1e-14);
  }
}
