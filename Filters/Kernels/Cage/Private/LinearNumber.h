#pragma once

#include <Eigen/Core>

#include <cmath>

namespace shape
{

/**
 * A number and its gradient with respect to the position at which it is evaluated. A formula that
 * is written for any type of number is evaluated with this one to differentiate it exactly, by the
 * chain rule.
 */
struct LinearNumber
{
  double Value = 0.0;
  Eigen::Vector3d Slope = Eigen::Vector3d::Zero();
};

inline LinearNumber operator+(const LinearNumber& a, const LinearNumber& b)
{
  return { a.Value + b.Value, a.Slope + b.Slope };
}

inline LinearNumber operator-(const LinearNumber& a, const LinearNumber& b)
{
  return { a.Value - b.Value, a.Slope - b.Slope };
}

inline LinearNumber operator*(const LinearNumber& a, const LinearNumber& b)
{
  return { a.Value * b.Value, a.Value * b.Slope + b.Value * a.Slope };
}

inline LinearNumber operator*(double a, const LinearNumber& b)
{
  return { a * b.Value, a * b.Slope };
}

inline LinearNumber operator/(const LinearNumber& a, const LinearNumber& b)
{
  const double quotient = a.Value / b.Value;
  return { quotient, (a.Slope - quotient * b.Slope) / b.Value };
}

inline LinearNumber operator+(const LinearNumber& a, double b)
{
  return { a.Value + b, a.Slope };
}

/// Returns `a` with its sign changed if `negative`.
template <typename Number>
Number NegateIf(bool negative, const Number& a)
{
  return negative ? -1.0 * a : a;
}

inline double ValueOf(double a)
{
  return a;
}

inline double ValueOf(const LinearNumber& a)
{
  return a.Value;
}

inline double Root(double a)
{
  return std::sqrt(a);
}

inline LinearNumber Root(const LinearNumber& a)
{
  const double root = std::sqrt(a.Value);
  return { root, a.Slope / (2.0 * root) };
}

inline double Logarithm(double a)
{
  return std::log(a);
}

inline LinearNumber Logarithm(const LinearNumber& a)
{
  return { std::log(a.Value), a.Slope / a.Value };
}

inline double Angle(double y, double x)
{
  return std::atan2(y, x);
}

inline LinearNumber Angle(const LinearNumber& y, const LinearNumber& x)
{
  return { std::atan2(y.Value, x.Value),
    (x.Value * y.Slope - y.Value * x.Slope) / (x.Value * x.Value + y.Value * y.Value) };
}

/// Returns a number with this value and gradient; a double has no gradient.
template <typename Number>
Number MakeLinear(double value, const Eigen::Vector3d& slope);

template <>
inline double MakeLinear<double>(double value, const Eigen::Vector3d&)
{
  return value;
}

template <>
inline LinearNumber MakeLinear<LinearNumber>(double value, const Eigen::Vector3d& slope)
{
  return { value, slope };
}

} // namespace shape
