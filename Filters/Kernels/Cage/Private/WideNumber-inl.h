// Included once for each set of instructions, so without #pragma once.
#if defined(SHAPE_CAGE_WIDE_NUMBER) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPE_CAGE_WIDE_NUMBER
#undef SHAPE_CAGE_WIDE_NUMBER
#else
#define SHAPE_CAGE_WIDE_NUMBER
#endif

#include "Cage/Private/PositionBlock.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace shape::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, PositionBlock::Size>;
using Mask = hn::Mask<Tag>;

/// A number for each position of some.
struct Wide
{
  hn::Vec<Tag> Lanes;
};

HWY_INLINE Wide Set(double a)
{
  return { hn::Set(Tag(), a) };
}

HWY_INLINE Wide Load(const double* from)
{
  return { hn::LoadU(Tag(), from) };
}

HWY_INLINE void Store(const Wide& a, double* to)
{
  hn::StoreU(a.Lanes, Tag(), to);
}

HWY_INLINE Wide operator+(const Wide& a, const Wide& b)
{
  return { hn::Add(a.Lanes, b.Lanes) };
}

HWY_INLINE Wide operator-(const Wide& a, const Wide& b)
{
  return { hn::Sub(a.Lanes, b.Lanes) };
}

HWY_INLINE Wide operator*(const Wide& a, const Wide& b)
{
  return { hn::Mul(a.Lanes, b.Lanes) };
}

HWY_INLINE Wide operator/(const Wide& a, const Wide& b)
{
  return { hn::Div(a.Lanes, b.Lanes) };
}

HWY_INLINE Mask operator<(const Wide& a, const Wide& b)
{
  return hn::Lt(a.Lanes, b.Lanes);
}

HWY_INLINE Wide Absolute(const Wide& a)
{
  return { hn::Abs(a.Lanes) };
}

HWY_INLINE Wide Smaller(const Wide& a, const Wide& b)
{
  return { hn::Min(a.Lanes, b.Lanes) };
}

HWY_INLINE Wide Larger(const Wide& a, const Wide& b)
{
  return { hn::Max(a.Lanes, b.Lanes) };
}

/// The magnitude of `a`, which is not negative, with the sign of `b`.
HWY_INLINE Wide WithSign(const Wide& a, const Wide& b)
{
  return { hn::CopySignToAbs(a.Lanes, b.Lanes) };
}

/// `a` in the lanes of the mask, else `b`. What is not chosen need not be finite.
HWY_INLINE Wide Select(Mask mask, const Wide& a, const Wide& b)
{
  return { hn::IfThenElse(mask, a.Lanes, b.Lanes) };
}

HWY_INLINE Wide Root(const Wide& a)
{
  return { hn::Sqrt(a.Lanes) };
}

HWY_INLINE Wide Logarithm(const Wide& a)
{
  return { hn::Log(Tag(), a.Lanes) };
}

/// As std::atan2.
HWY_INLINE Wide Angle(const Wide& y, const Wide& x)
{
  const Wide zero = Set(0.0);
  const Mask none =
    hn::And(hn::Eq(x.Lanes, zero.Lanes), hn::Eq(y.Lanes, zero.Lanes)); // the angle is 0
  const Wide angle{ hn::Atan(Tag(), (y / Select(none, Set(1.0), x)).Lanes) };
  return angle + Select(x < zero, WithSign(Set(M_PI), y), zero);
}

/**
 * Numbers and their gradients with respect to the positions at which they are evaluated. A formula
 * that is written for any type of number is evaluated with this one to differentiate it exactly, by
 * the chain rule.
 */
struct WideLinear
{
  Wide Value;
  Wide Slope[3];
};

/// Returns the number whose gradient is first * a.Slope + second * b.Slope.
HWY_INLINE WideLinear Chain(const Wide& value, const Wide& first, const WideLinear& a,
  const Wide& second, const WideLinear& b)
{
  return { value,
    { first * a.Slope[0] + second * b.Slope[0], first * a.Slope[1] + second * b.Slope[1],
      first * a.Slope[2] + second * b.Slope[2] } };
}

/// Returns the number whose gradient is first * a.Slope.
HWY_INLINE WideLinear Chain(const Wide& value, const Wide& first, const WideLinear& a)
{
  return { value, { first * a.Slope[0], first * a.Slope[1], first * a.Slope[2] } };
}

HWY_INLINE WideLinear operator+(const WideLinear& a, const WideLinear& b)
{
  return { a.Value + b.Value,
    { a.Slope[0] + b.Slope[0], a.Slope[1] + b.Slope[1], a.Slope[2] + b.Slope[2] } };
}

HWY_INLINE WideLinear operator-(const WideLinear& a, const WideLinear& b)
{
  return { a.Value - b.Value,
    { a.Slope[0] - b.Slope[0], a.Slope[1] - b.Slope[1], a.Slope[2] - b.Slope[2] } };
}

HWY_INLINE WideLinear operator*(const WideLinear& a, const WideLinear& b)
{
  return Chain(a.Value * b.Value, b.Value, a, a.Value, b);
}

HWY_INLINE WideLinear operator*(const Wide& a, const WideLinear& b)
{
  return Chain(a * b.Value, a, b);
}

HWY_INLINE WideLinear operator/(const WideLinear& a, const WideLinear& b)
{
  const Wide inverse = Set(1.0) / b.Value, quotient = a.Value / b.Value;
  return Chain(quotient, inverse, a, Set(0.0) - quotient * inverse, b);
}

HWY_INLINE WideLinear operator+(const WideLinear& a, const Wide& b)
{
  return { a.Value + b, { a.Slope[0], a.Slope[1], a.Slope[2] } };
}

HWY_INLINE WideLinear Select(Mask mask, const WideLinear& a, const WideLinear& b)
{
  return { Select(mask, a.Value, b.Value),
    { Select(mask, a.Slope[0], b.Slope[0]), Select(mask, a.Slope[1], b.Slope[1]),
      Select(mask, a.Slope[2], b.Slope[2]) } };
}

HWY_INLINE WideLinear Root(const WideLinear& a)
{
  const Wide root = Root(a.Value);
  return Chain(root, Set(0.5) / root, a);
}

HWY_INLINE WideLinear Logarithm(const WideLinear& a)
{
  return Chain(Logarithm(a.Value), Set(1.0) / a.Value, a);
}

HWY_INLINE WideLinear Angle(const WideLinear& y, const WideLinear& x)
{
  const Wide inverse = Set(1.0) / (x.Value * x.Value + y.Value * y.Value);
  return Chain(Angle(y.Value, x.Value), x.Value * inverse, y, Set(0.0) - y.Value * inverse, x);
}

HWY_INLINE const Wide& ValueOf(const Wide& a)
{
  return a;
}

HWY_INLINE const Wide& ValueOf(const WideLinear& a)
{
  return a.Value;
}

/// `a` with its sign changed in the lanes of the mask.
template <typename Number>
HWY_INLINE Number NegateIf(Mask mask, const Number& a)
{
  return Select(mask, Set(-1.0) * a, a);
}

/// Numbers with this value and gradient; those of type Wide have no gradient.
template <typename Number>
HWY_INLINE Number MakeNumber(const Wide& value, const Wide& x, const Wide& y, const Wide& z);

template <>
HWY_INLINE Wide MakeNumber<Wide>(const Wide& value, const Wide&, const Wide&, const Wide&)
{
  return value;
}

template <>
HWY_INLINE WideLinear MakeNumber<WideLinear>(
  const Wide& value, const Wide& x, const Wide& y, const Wide& z)
{
  return { value, { x, y, z } };
}

/// Numbers that do not depend on the position.
template <typename Number>
HWY_INLINE Number MakeConstant(double value)
{
  return MakeNumber<Number>(Set(value), Set(0.0), Set(0.0), Set(0.0));
}

} // namespace shape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
