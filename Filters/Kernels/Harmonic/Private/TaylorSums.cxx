#include "Harmonic/Private/TaylorSums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Harmonic/Private/TaylorSums.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace shape::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
using TaylorLanes = hn::CappedTag<double, 8>;

void SumTaylorTerms(const TaylorSums& given)
{
  constexpr std::size_t most = 8;
  const TaylorLanes wide;
  using Vector = hn::Vec<TaylorLanes>;
  const std::size_t lanes = hn::Lanes(wide);
  const int size = given.Size;
  const std::vector<int>& ids = *given.Ids;
  // The coefficients of 1 / |x - y|, then an entry that is always 0; and the sums.
  HWY_ALIGN double terms[(TaylorSums::MaximumSize + 1) * most];
  HWY_ALIGN double sums[3 * TaylorSums::MaximumSize * most];
  std::fill_n(terms + TaylorSums::MaximumSize * lanes, lanes, 0.0);
  std::fill_n(sums, 3 * size * lanes, 0.0);
  const auto term = [&](int i) { return hn::Load(wide, terms + i * lanes); };
  const Vector one = hn::Set(wide, 1.0), zero = hn::Zero(wide);
  Vector remainders[3] = { zero, zero, zero }, magnitudes[3] = { zero, zero, zero };
  for (std::size_t first = 0; first < ids.size(); first += lanes)
  {
    // Lanes without a charge repeat the last one, with charge 0.
    HWY_ALIGN double gathered[6 * most];
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      const std::size_t place = std::min(first + lane, ids.size() - 1);
      const double* column = given.Charges->data() + 6 * static_cast<std::size_t>(ids[place]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        gathered[c * lanes + lane] = given.Centre(static_cast<int>(c)) - column[c];
        gathered[(3 + c) * lanes + lane] = place == first + lane ? column[3 + c] : 0.0;
      }
    }
    Vector x = hn::Load(wide, gathered), y = hn::Load(wide, gathered + lanes),
           z = hn::Load(wide, gathered + 2 * lanes);
    const Vector charges[3] = { hn::Load(wide, gathered + 3 * lanes),
      hn::Load(wide, gathered + 4 * lanes), hn::Load(wide, gathered + 5 * lanes) };
    const Vector inverse = hn::Div(one, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))));
    const Vector root = hn::Sqrt(inverse);
    x = hn::Mul(x, inverse);
    y = hn::Mul(y, inverse);
    z = hn::Mul(z, inverse);
    hn::Store(root, wide, terms);
    for (int i = 0; i < size; ++i)
    {
      Vector value = root;
      if (i > 0)
      {
        const TaylorStep& step = given.Steps[i];
        const Vector lower = hn::MulAdd(x, term(step.Lower[0]),
          hn::MulAdd(y, term(step.Lower[1]), hn::Mul(z, term(step.Lower[2]))));
        const Vector lowest = hn::Add(term(step.Lowest[0]), term(step.Lowest[1]));
        value = hn::MulAdd(hn::Set(wide, step.LowerFactor), lower,
          hn::Mul(hn::Mul(hn::Set(wide, step.LowestFactor), inverse), lowest));
        hn::Store(value, wide, terms + i * lanes);
      }
      for (int c = 0; c < 3; ++c)
      {
        double* sum = sums + (3 * i + c) * lanes;
        hn::Store(hn::MulAdd(charges[c], value, hn::Load(wide, sum)), wide, sum);
      }
    }
    const Vector t = hn::Mul(hn::Set(wide, given.Radius), root);
    const Vector rest = hn::Sub(one, t);
    const Vector magnitude = hn::Div(inverse, hn::Mul(rest, rest));
    Vector tail = hn::Mul(
      magnitude, hn::NegMulAdd(hn::Set(wide, given.Degree), t, hn::Set(wide, given.Degree + 1.0)));
    for (int n = 0; n < given.Degree; ++n)
    {
      tail = hn::Mul(tail, t);
    }
    for (int c = 0; c < 3; ++c)
    {
      const Vector strength = hn::Abs(charges[c]);
      remainders[c] = hn::MulAdd(strength, tail, remainders[c]);
      magnitudes[c] = hn::MulAdd(strength, magnitude, magnitudes[c]);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < size; ++i)
    {
      given.Coefficients[c][i] +=
        hn::GetLane(hn::SumOfLanes(wide, hn::Load(wide, sums + (3 * i + c) * lanes)));
    }
    given.Remainder[c] += hn::GetLane(hn::SumOfLanes(wide, remainders[c]));
    given.Magnitude[c] += hn::GetLane(hn::SumOfLanes(wide, magnitudes[c]));
  }
}

} // namespace shape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace shape
{

namespace
{

HWY_EXPORT(SumTaylorTerms);

} // namespace

void AddTaylorSums(const TaylorSums& sums)
{
  return HWY_DYNAMIC_DISPATCH(SumTaylorTerms)(sums);
}

} // namespace shape

#endif
