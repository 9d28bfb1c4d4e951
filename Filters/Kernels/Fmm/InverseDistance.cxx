#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fmm/InverseDistance.cxx"
// Targets that would only repeat the code of AVX-512 and SSE4.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Fmm/InverseDistance.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Vector = hn::Vec<Tag>;

#if HWY_TARGET == HWY_AVX3
// The seed is accurate to 2^-14. A Newton step y (3 - s y y) = 2 / sqrt(s) is accurate to 6e-9,
// another one to rounding. The constant factors are removed from the sums at the end.
template <RootError Error>
constexpr double RootFactor = Error == RootError::Rounding ? 16.0 : 2.0;

template <RootError Error>
HWY_INLINE Vector InverseRoot(Tag d, Vector squared)
{
  const Vector seed{ _mm512_rsqrt14_pd(squared.raw) };
  const Vector once = hn::Mul(seed, hn::NegMulAdd(hn::Mul(squared, seed), seed, hn::Set(d, 3.0)));
  if constexpr (Error == RootError::Small)
  {
    return once;
  }
  else
  {
    return hn::Mul(once, hn::NegMulAdd(hn::Mul(squared, once), once, hn::Set(d, 12.0)));
  }
}
#elif HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
// Without vectors, square root and division cost no more than Newton steps from a rough seed.
template <RootError Error>
constexpr double RootFactor = 1.0;

template <RootError Error>
HWY_INLINE Vector InverseRoot(Tag d, Vector squared)
{
  return hn::Div(hn::Set(d, 1.0), hn::Sqrt(squared));
}
#else
// The single precision seed is accurate to 4e-4 or better. Then y (1 + e/2 + 3/8 e e), e = 1 - s y
// y, is accurate to 2e-10, and one more Newton step to rounding.
template <RootError Error>
constexpr double RootFactor = Error == RootError::Rounding ? 2.0 : 1.0;

template <RootError Error>
HWY_INLINE Vector InverseRoot(Tag d, Vector squared)
{
  const hn::Rebind<float, Tag> single;
  const Vector seed =
    hn::PromoteTo(d, hn::ApproximateReciprocalSqrt(hn::DemoteTo(single, squared)));
  const Vector e = hn::NegMulAdd(hn::Mul(squared, seed), seed, hn::Set(d, 1.0));
  const Vector once =
    hn::MulAdd(hn::Mul(seed, e), hn::MulAdd(e, hn::Set(d, 0.375), hn::Set(d, 0.5)), seed);
  if constexpr (Error == RootError::Small)
  {
    return once;
  }
  else
  {
    return hn::Mul(once, hn::NegMulAdd(hn::Mul(squared, once), once, hn::Set(d, 3.0)));
  }
}
#endif

/// Computes the sums at `Vectors` vectors of points, with coordinates at points[c * pointStride].
template <int Columns, bool Gradient, RootError Error, int Vectors>
HWY_INLINE void SumBlock(const InverseDistanceSum& sum, const double* points,
  std::ptrdiff_t pointStride, double* values, std::ptrdiff_t valueStride)
{
  constexpr int sums = Gradient ? 3 * Columns : Columns;
  const Tag d;
  const std::ptrdiff_t lanes = hn::Lanes(d);
  Vector position[Vectors][3], total[Vectors][sums];
  for (int v = 0; v < Vectors; ++v)
  {
    for (int c = 0; c < 3; ++c)
    {
      position[v][c] = hn::LoadU(d, points + v * lanes + c * pointStride);
    }
    for (int c = 0; c < sums; ++c)
    {
      total[v][c] = hn::Zero(d);
    }
  }
  for (int s = 0; s < sum.SpanCount; ++s)
  {
    // Each source is read once and broadcast to all lanes.
    const double* source = sum.Sources + sum.Spans[s].Begin * std::ptrdiff_t(3 + Columns);
    const double* const end = sum.Sources + sum.Spans[s].End * std::ptrdiff_t(3 + Columns);
    for (; source != end; source += 3 + Columns)
    {
      for (int v = 0; v < Vectors; ++v)
      {
        const Vector x = hn::Sub(position[v][0], hn::Set(d, source[0]));
        const Vector y = hn::Sub(position[v][1], hn::Set(d, source[1]));
        const Vector z = hn::Sub(position[v][2], hn::Set(d, source[2]));
        const Vector inverse =
          InverseRoot<Error>(d, hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x))));
        if constexpr (Gradient)
        {
          // The gradient of 1 / r is -(y - x) / r^3; the sign is applied at the end.
          const Vector cube = hn::Mul(hn::Mul(inverse, inverse), inverse);
          const Vector along[3] = { hn::Mul(x, cube), hn::Mul(y, cube), hn::Mul(z, cube) };
          for (int c = 0; c < sums; ++c)
          {
            total[v][c] = hn::MulAdd(hn::Set(d, source[3 + c / 3]), along[c % 3], total[v][c]);
          }
        }
        else
        {
          for (int c = 0; c < sums; ++c)
          {
            total[v][c] = hn::MulAdd(hn::Set(d, source[3 + c]), inverse, total[v][c]);
          }
        }
      }
    }
  }
  // The factor of InverseRoot is in each 1 / r, so a gradient has its cube.
  constexpr double factor = RootFactor<Error>;
  const Vector scale = hn::Set(d, Gradient ? -1.0 / (factor * factor * factor) : 1.0 / factor);
  for (int v = 0; v < Vectors; ++v)
  {
    for (int c = 0; c < sums; ++c)
    {
      double* to = values + v * lanes + c * valueStride;
      hn::StoreU(hn::MulAdd(total[v][c], scale, hn::LoadU(d, to)), d, to);
    }
  }
}

template <int Columns, bool Gradient, RootError Error>
void SumAll(const InverseDistanceSum& sum)
{
  // As many vectors as fit in the registers.
  constexpr int vectors = HWY_TARGET == HWY_AVX3 ? (Gradient && Columns > 1 ? 1 : 2) : 1;
  constexpr int sums = Gradient ? 3 * Columns : Columns;
  const int lanes = static_cast<int>(hn::Lanes(Tag()));
  int i = 0;
  for (; i + vectors * lanes <= sum.PointCount; i += vectors * lanes)
  {
    SumBlock<Columns, Gradient, Error, vectors>(
      sum, sum.Points + i, sum.PointStride, sum.Values + i, sum.ValueStride);
  }
  for (; i < sum.PointCount; i += lanes)
  {
    if (i + lanes <= sum.PointCount)
    {
      SumBlock<Columns, Gradient, Error, 1>(
        sum, sum.Points + i, sum.PointStride, sum.Values + i, sum.ValueStride);
      continue;
    }
    // The last points are copied to a buffer; the last one fills the remaining lanes.
    constexpr int maximum = static_cast<int>(hn::MaxLanes(Tag()));
    double points[3 * maximum], values[sums * maximum];
    for (int lane = 0; lane < lanes; ++lane)
    {
      const int from = i + lane < sum.PointCount ? i + lane : sum.PointCount - 1;
      for (int c = 0; c < 3; ++c)
      {
        points[c * maximum + lane] = sum.Points[from + c * sum.PointStride];
      }
      for (int c = 0; c < sums; ++c)
      {
        values[c * maximum + lane] = sum.Values[from + c * sum.ValueStride];
      }
    }
    SumBlock<Columns, Gradient, Error, 1>(sum, points, maximum, values, maximum);
    for (int lane = 0; i + lane < sum.PointCount; ++lane)
    {
      for (int c = 0; c < sums; ++c)
      {
        sum.Values[i + lane + c * sum.ValueStride] = values[c * maximum + lane];
      }
    }
  }
}

template <bool Gradient, RootError Error>
void SumColumns(const InverseDistanceSum& sum)
{
  switch (sum.Columns)
  {
    case 1:
      return SumAll<1, Gradient, Error>(sum);
    case 2:
      return SumAll<2, Gradient, Error>(sum);
    default:
      return SumAll<3, Gradient, Error>(sum);
  }
}

template <bool Gradient>
void SumFor(const InverseDistanceSum& sum)
{
  return sum.Error == RootError::Rounding ? SumColumns<Gradient, RootError::Rounding>(sum)
                                          : SumColumns<Gradient, RootError::Small>(sum);
}

} // namespace

// Not in the unnamed namespace, because the dispatch below takes their addresses for every target.
void PotentialsFor(const InverseDistanceSum& sum)
{
  SumFor<false>(sum);
}

void GradientsFor(const InverseDistanceSum& sum)
{
  SumFor<true>(sum);
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shape
{

HWY_EXPORT(PotentialsFor);
HWY_EXPORT(GradientsFor);

void AddPotentials(const InverseDistanceSum& sum)
{
  HWY_DYNAMIC_DISPATCH(PotentialsFor)(sum);
}

void AddGradients(const InverseDistanceSum& sum)
{
  HWY_DYNAMIC_DISPATCH(GradientsFor)(sum);
}

} // namespace shape
#endif
