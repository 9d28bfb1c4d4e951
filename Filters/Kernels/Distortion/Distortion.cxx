#include "Parameterize/PlanarDistortion.h"

#include <cmath>

namespace shape
{
namespace
{

using Eigen::Vector2d;

double Cubed(double s)
{
  return s * s * s;
}

/// The factor s - c is divided out by hand below, so there is no cancellation near s = c.
DistortionTerms SymmetricDirichletTerms(const Vector2d& s)
{
  DistortionTerms terms{ s.squaredNorm() + s.cwiseInverse().squaredNorm(), {}, {} };
  for (int i = 0; i < 2; ++i)
  {
    // c = 1, and s - s^-3 = (s - 1) (s + 1) (s^2 + 1) / s^3.
    terms.Gradient(i) = 2.0 * (s(i) - 1.0 / Cubed(s(i)));
    terms.Weights(i) = (s(i) + 1.0) * (s(i) * s(i) + 1.0) / Cubed(s(i));
  }
  return terms;
}

/// The exponent of AMIPS. Its derivative by one singular value s, with the other one o fixed, is p
/// (1 - c^2 / s^2) with p = 1 / (2 o) + o / 4.
DistortionTerms AmipsTerms(const Vector2d& s)
{
  const double product = s(0) * s(1);
  DistortionTerms terms{ 0.5 * (s(0) / s(1) + s(1) / s(0)) + 0.25 * (product + 1.0 / product), {},
    {} };
  for (int i = 0; i < 2; ++i)
  {
    const double other = s(1 - i);
    const double slope = 0.5 / other + 0.25 * other;
    const double centre = std::sqrt((0.5 * other + 0.25 / other) / slope);
    terms.Gradient(i) = slope * (1.0 - centre * centre / (s(i) * s(i)));
    terms.Weights(i) = 0.5 * slope * (s(i) + centre) / (s(i) * s(i));
  }
  return terms;
}

/// c is the geometric mean of s1 and s2: a similarity of the same area.
DistortionTerms ConformalTerms(const Vector2d& s)
{
  DistortionTerms terms{ s(0) / s(1) + s(1) / s(0), {}, {} };
  const Vector2d roots = s.cwiseSqrt();
  for (int i = 0; i < 2; ++i)
  {
    const double other = s(1 - i);
    // With the other value o and c = sqrt(s o): the gradient is (s - o) (s + o) / (o s^2), and (s -
    // o) / (s - c) = (sqrt s + sqrt o) / sqrt s.
    terms.Gradient(i) = 1.0 / other - other / (s(i) * s(i));
    terms.Weights(i) = roots.sum() * s.sum() / (2.0 * roots(i) * other * s(i) * s(i));
  }
  return terms;
}

DistortionTerms LogarithmicTerms(const Vector2d& s)
{
  DistortionTerms terms{ s.array().log().square().sum(), {}, {} };
  for (int i = 0; i < 2; ++i)
  {
    const double apart = s(i) - 1.0;
    // c = 1; log1p keeps log(s) / (s - 1) accurate near 1, where its limit is 1.
    terms.Gradient(i) = 2.0 * std::log(s(i)) / s(i);
    terms.Weights(i) = apart == 0.0 ? 1.0 : std::log1p(apart) / (s(i) * apart);
  }
  return terms;
}

DistortionTerms Exponential(const DistortionTerms& inner, double exponent)
{
  // The chain rule: both are multiplied by the derivative of the exponential.
  const double value = std::exp(exponent * inner.Value);
  return { value, exponent * value * inner.Gradient, exponent * value * inner.Weights };
}

} // namespace

bool IsExponential(Distortion distortion)
{
  return distortion == Distortion::ExponentialSymmetricDirichlet || distortion == Distortion::AMIPS;
}

DistortionTerms EvaluateDistortion(
  Distortion distortion, double exponent, const Eigen::Vector2d& singular)
{
  switch (distortion)
  {
    case Distortion::SymmetricDirichlet:
      return SymmetricDirichletTerms(singular);
    case Distortion::ExponentialSymmetricDirichlet:
      return Exponential(SymmetricDirichletTerms(singular), exponent);
    case Distortion::AMIPS:
      return Exponential(AmipsTerms(singular), exponent);
    case Distortion::ConformalAMIPS:
      return ConformalTerms(singular);
    case Distortion::LogARAP:
      return LogarithmicTerms(singular);
    case Distortion::ARAP:
      break;
  }
  // ARAP is a quadratic form already: all weights are 1.
  const Vector2d apart = singular.array() - 1.0;
  return { apart.squaredNorm(), 2.0 * apart, Vector2d::Ones() };
}

} // namespace shape
