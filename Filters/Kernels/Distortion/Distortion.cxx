#include "Distortion/Distortion.h"

#include <cmath>

namespace shape
{
namespace
{

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

double Cubed(double s)
{
  return s * s * s;
}

/// The factor s - c is divided out by hand below, so there is no cancellation near s = c.
template <int D>
DistortionTerms<D> SymmetricDirichletTerms(const Vector<D>& s)
{
  DistortionTerms<D> terms{ s.squaredNorm() + s.cwiseInverse().squaredNorm(), {}, {} };
  for (int i = 0; i < D; ++i)
  {
    // c = 1, and s - s^-3 = (s - 1) (s + 1) (s^2 + 1) / s^3.
    terms.Gradient(i) = 2.0 * (s(i) - 1.0 / Cubed(s(i)));
    terms.Weights(i) = (s(i) + 1.0) * (s(i) * s(i) + 1.0) / Cubed(s(i));
  }
  return terms;
}

/// The exponent of AMIPS in the plane. Its derivative by one singular value s, with the other one o
/// fixed, is p (1 - c^2 / s^2) with p = 1 / (2 o) + o / 4.
DistortionTerms<2> AmipsTerms(const Vector<2>& s)
{
  const double product = s.prod();
  DistortionTerms<2> terms{ 0.5 * (s(0) / s(1) + s(1) / s(0)) + 0.25 * (product + 1.0 / product),
    {}, {} };
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

/// Returns the positive root of q c^4 + m c^3 - c / m - p for q, m, p > 0. There is one, because
/// the coefficients change their sign once.
double PositiveRoot(double q, double m, double p, double start)
{
  const auto value = [&](double c) { return ((q * c + m) * c * c - 1.0 / m) * c - p; };
  const auto slope = [&](double c) { return (4.0 * q * c + 3.0 * m) * c * c - 1.0 / m; };
  // The polynomial is convex for c > 0, so from the right of the root Newton's steps fall to it.
  double c = start;
  while (value(c) < 0.0)
  {
    c *= 2.0;
  }
  for (double next = c - value(c) / slope(c); next < c; next = c - value(c) / slope(c))
  {
    c = next;
  }
  return c;
}

/// The exponent of AMIPS in space. Its derivative by one singular value s, with the others fixed,
/// is (q s^4 + m s^3 - s / m - p) / (4 s^3), where p and q are the sums of the squares of the
/// others and of their inverses, and m is the product of the others.
DistortionTerms<3> AmipsTerms(const Vector<3>& s)
{
  const double product = s.prod(), squares = s.squaredNorm(),
               inverses = s.cwiseInverse().squaredNorm();
  DistortionTerms<3> terms{ 0.125 * (squares * inverses - 1.0) + 0.25 * (product + 1.0 / product),
    {}, {} };
  for (int i = 0; i < 3; ++i)
  {
    const double one = s(i), other = s((i + 1) % 3), third = s((i + 2) % 3);
    const double p = other * other + third * third;
    const double q = 1.0 / (other * other) + 1.0 / (third * third);
    const double m = other * third;
    const double c = PositiveRoot(q, m, p, one);
    terms.Gradient(i) = 0.25 * (q * one - p / Cubed(one) + m - 1.0 / (m * one * one));
    // The polynomial at s, less that at its root c, divided by s - c.
    const double quotient =
      q * (one + c) * (one * one + c * c) + m * (one * one + one * c + c * c) - 1.0 / m;
    terms.Weights(i) = quotient / (8.0 * Cubed(one));
  }
  return terms;
}

template <int D>
DistortionTerms<D> ConformalTerms(const Vector<D>& s)
{
  const double squares = s.squaredNorm(), size = std::pow(s.prod(), 2.0 / D);
  const double mean = std::sqrt(squares / D);
  DistortionTerms<D> terms{ squares / size, {}, {} };
  for (int i = 0; i < D; ++i)
  {
    // s^2 - c^2 = (s - c) (s + c) for the root mean square c.
    terms.Gradient(i) = 2.0 * (s(i) * s(i) - mean * mean) / (size * s(i));
    terms.Weights(i) = (s(i) + mean) / (size * s(i));
  }
  return terms;
}

template <int D>
DistortionTerms<D> HenckyTerms(const Vector<D>& s)
{
  DistortionTerms<D> terms{ s.array().log().square().sum(), {}, {} };
  for (int i = 0; i < D; ++i)
  {
    const double apart = s(i) - 1.0;
    // c = 1; log1p keeps log(s) / (s - 1) accurate near 1, where its limit is 1.
    terms.Gradient(i) = 2.0 * std::log(s(i)) / s(i);
    terms.Weights(i) = apart == 0.0 ? 1.0 : std::log1p(apart) / (s(i) * apart);
  }
  return terms;
}

template <int D>
DistortionTerms<D> Exponential(const DistortionTerms<D>& inner, double exponent)
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

template <int Dimension>
DistortionTerms<Dimension> EvaluateDistortion(
  Distortion distortion, double exponent, const Eigen::Matrix<double, Dimension, 1>& singular)
{
  switch (distortion)
  {
    case Distortion::SymmetricDirichlet:
      return SymmetricDirichletTerms<Dimension>(singular);
    case Distortion::ExponentialSymmetricDirichlet:
      return Exponential(SymmetricDirichletTerms<Dimension>(singular), exponent);
    case Distortion::AMIPS:
      return Exponential(AmipsTerms(singular), exponent);
    case Distortion::ConformalAMIPS:
      return ConformalTerms<Dimension>(singular);
    case Distortion::Hencky:
      return HenckyTerms<Dimension>(singular);
    case Distortion::ARAP:
      break;
  }
  // ARAP is a quadratic form already: all weights are 1.
  const Vector<Dimension> apart = singular.array() - 1.0;
  return { apart.squaredNorm(), 2.0 * apart, Vector<Dimension>::Ones() };
}

template DistortionTerms<2> EvaluateDistortion<2>(Distortion, double, const Vector<2>&);
template DistortionTerms<3> EvaluateDistortion<3>(Distortion, double, const Vector<3>&);

} // namespace shape
