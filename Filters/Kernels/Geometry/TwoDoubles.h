#pragma once

#include <Eigen/Core>

#include <cmath>

namespace shape
{

/// A number as the sum of two doubles, about 32 decimal digits: the second is at most half a unit
/// in the last place of the first. Sums and products are those of Dekker, "A floating-point
/// technique for extending the available precision" (1971).
struct TwoDoubles
{
  double High = 0.0;
  double Low = 0.0;

  TwoDoubles() = default;
  TwoDoubles(double value) // NOLINT(google-explicit-constructor): as a double is any number
    : High(value)
  {
  }
  TwoDoubles(double high, double low)
    : High(high)
    , Low(low)
  {
  }

  explicit operator double() const { return this->High; }

  TwoDoubles& operator+=(const TwoDoubles& other);
  TwoDoubles& operator-=(const TwoDoubles& other);
  TwoDoubles& operator*=(const TwoDoubles& other);
  TwoDoubles& operator/=(const TwoDoubles& other);
};

/// a + b, exactly: the operation Two-Sum of Shewchuk 1997 (Orientation.h), for any two doubles
/// without overflow.
inline TwoDoubles ExactSum(double a, double b)
{
  const double high = a + b;
  const double part = high - a;
  return { high, (a - (high - part)) + (b - part) };
}

/// a * b, exactly: the operation Two-Product of Shewchuk 1997.
inline TwoDoubles ExactProduct(double a, double b)
{
  // Halves of 26 bits, whose products are exact.
  const auto split = [](double x)
  {
    const double large = 134217729.0 * x; // 2^27 + 1
    const double high = large - (large - x);
    return TwoDoubles(high, x - high);
  };
  const double high = a * b;
  const TwoDoubles x = split(a), y = split(b);
  const double error = high - x.High * y.High - x.Low * y.High - x.High * y.Low;
  return { high, x.Low * y.Low - error };
}

inline TwoDoubles operator-(const TwoDoubles& a)
{
  return { -a.High, -a.Low };
}

inline TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b)
{
  const TwoDoubles high = ExactSum(a.High, b.High), low = ExactSum(a.Low, b.Low);
  const TwoDoubles sum = ExactSum(high.High, high.Low + low.High);
  return ExactSum(sum.High, sum.Low + low.Low);
}

inline TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b)
{
  return a + -b;
}

inline TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b)
{
  const TwoDoubles product = ExactProduct(a.High, b.High);
  return ExactSum(product.High, product.Low + (a.High * b.Low + a.Low * b.High));
}

inline TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b)
{
  // Two steps of long division; the third quotient is below the precision.
  const double first = a.High / b.High;
  const TwoDoubles rest = a - b * TwoDoubles(first);
  const double second = rest.High / b.High;
  const TwoDoubles last = rest - b * TwoDoubles(second);
  return ExactSum(first, second) + TwoDoubles(last.High / b.High);
}

inline TwoDoubles& TwoDoubles::operator+=(const TwoDoubles& other)
{
  return *this = *this + other;
}
inline TwoDoubles& TwoDoubles::operator-=(const TwoDoubles& other)
{
  return *this = *this - other;
}
inline TwoDoubles& TwoDoubles::operator*=(const TwoDoubles& other)
{
  return *this = *this * other;
}
inline TwoDoubles& TwoDoubles::operator/=(const TwoDoubles& other)
{
  return *this = *this / other;
}

inline bool operator<(const TwoDoubles& a, const TwoDoubles& b)
{
  return a.High < b.High || (a.High == b.High && a.Low < b.Low);
}
inline bool operator>(const TwoDoubles& a, const TwoDoubles& b)
{
  return b < a;
}
inline bool operator>=(const TwoDoubles& a, const TwoDoubles& b)
{
  return !(a < b);
}
inline bool operator==(const TwoDoubles& a, const TwoDoubles& b)
{
  return a.High == b.High && a.Low == b.Low;
}

inline TwoDoubles abs(const TwoDoubles& a)
{
  return a < TwoDoubles() ? -a : a;
}

/// One step of Newton's method from the root of the first part doubles its digits.
inline TwoDoubles sqrt(const TwoDoubles& a)
{
  if (!(a > TwoDoubles()))
  {
    return {};
  }
  const TwoDoubles root = std::sqrt(a.High);
  return root + (a - root * root) / (root + root);
}

} // namespace shape

namespace Eigen
{

template <>
struct NumTraits<shape::TwoDoubles> : GenericNumTraits<shape::TwoDoubles>
{
  enum
  {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 25
  };
};

} // namespace Eigen
