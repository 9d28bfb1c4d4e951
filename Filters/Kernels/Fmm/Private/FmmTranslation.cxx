#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fmm/Private/FmmTranslation.cxx"
// Targets that would only repeat the code of AVX-512 and SSE4.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Fmm/Private/FmmTranslation.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

/// Number of columns that are multiplied by the matrix together.
constexpr int Tile = 12;
/// Number of columns in one pass of the innermost loop: as many as fit in the registers.
constexpr int Pass = HWY_TARGET == HWY_AVX3 ? 12 : 6;

/// Multiplies rows [row, row + Vectors x lanes) of the matrix by `Pass` columns of x, into y. The
/// columns of x and y are `pitch` apart.
template <int Vectors, typename Real>
HWY_INLINE void Multiply(
  const FmmTranslation<Real>& product, int row, const Real* x, Real* y, std::ptrdiff_t pitch)
{
  const hn::ScalableTag<Real> d;
  using Vector = hn::Vec<decltype(d)>;
  const std::ptrdiff_t lanes = hn::Lanes(d);
  Vector sums[Pass][Vectors];
  for (int c = 0; c < Pass; ++c)
  {
    for (int v = 0; v < Vectors; ++v)
    {
      sums[c][v] = hn::Zero(d);
    }
  }
  const Real* column = product.Matrix + row;
  const int inner = product.Extents ? product.Extents[row / 16] : product.Inner;
  for (int j = 0; j < inner; ++j, column += product.RowStride)
  {
    Vector entries[Vectors];
    for (int v = 0; v < Vectors; ++v)
    {
      entries[v] = hn::LoadU(d, column + v * lanes);
    }
    for (int c = 0; c < Pass; ++c)
    {
      const Vector factor = hn::Set(d, x[c * pitch + j]);
      for (int v = 0; v < Vectors; ++v)
      {
        sums[c][v] = hn::MulAdd(factor, entries[v], sums[c][v]);
      }
    }
  }
  for (int c = 0; c < Pass; ++c)
  {
    for (int v = 0; v < Vectors; ++v)
    {
      hn::StoreU(sums[c][v], d, y + c * pitch + row + v * lanes);
    }
  }
}

template <typename Real>
void ProductsFor(const FmmTranslation<Real>& product, const BoxPair* pairs, std::ptrdiff_t count)
{
  // The pitch is not a multiple of 4096 bytes, so the columns lie in different sets of the cache.
  constexpr std::ptrdiff_t pitch = FmmTranslation<Real>::Most + 16;
  const hn::ScalableTag<Real> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int columns = product.Columns;
  const int atOnce = Tile / columns;
  const int rows = (product.Rows + lanes - 1) / lanes * lanes;
  const std::ptrdiff_t inBox = std::ptrdiff_t(columns) * product.InStride;
  const std::ptrdiff_t outBox = std::ptrdiff_t(columns) * product.OutStride;
  // The columns of several boxes are gathered, with their signs; multiplied; and added to the boxes
  // that receive them, with the same signs.
  HWY_ALIGN Real x[Tile * pitch];
  HWY_ALIGN Real y[Tile * pitch];
  for (std::ptrdiff_t first = 0; first < count; first += atOnce)
  {
    const int size = static_cast<int>(count - first < atOnce ? count - first : atOnce);
    for (int column = 0; column < Tile; ++column)
    {
      // Missing columns repeat the last one, so every column of a pass is defined.
      const int at = column < size * columns ? column : size * columns - 1;
      const BoxPair pair = pairs[first + at / columns];
      const Real* in = product.In + pair.From * inBox + (at % columns) * product.InStride;
      const Real* signs = product.Signs + std::ptrdiff_t(pair.Mirror) * product.SignStride;
      for (int i = 0; i < product.Inner; i += lanes)
      {
        const auto number = hn::LoadU(d, in + i);
        hn::StoreU(product.Signs ? hn::Mul(hn::LoadU(d, signs + i), number) : number, d,
          x + column * pitch + i);
      }
    }
    for (int column = 0; column < size * columns; column += Pass)
    {
      int row = 0;
      for (; row + 2 * lanes <= rows; row += 2 * lanes)
      {
        Multiply<2>(product, row, x + column * pitch, y + column * pitch, pitch);
      }
      if (row < rows)
      {
        Multiply<1>(product, row, x + column * pitch, y + column * pitch, pitch);
      }
    }
    for (int column = 0; column < size * columns; ++column)
    {
      const BoxPair pair = pairs[first + column / columns];
      Real* out = product.Out + pair.To * outBox + (column % columns) * product.OutStride;
      const Real* signs = product.Signs + std::ptrdiff_t(pair.Mirror) * product.SignStride;
      for (int i = 0; i < rows; i += lanes)
      {
        const auto number = hn::LoadU(d, y + column * pitch + i);
        hn::StoreU(hn::Add(hn::LoadU(d, out + i),
                     product.Signs ? hn::Mul(hn::LoadU(d, signs + i), number) : number),
          d, out + i);
      }
    }
  }
}

} // namespace

// Not in the unnamed namespace, because the dispatch below takes their addresses for every target.
void FloatProducts(const FmmTranslation<float>& product, const BoxPair* pairs, std::ptrdiff_t count)
{
  ProductsFor(product, pairs, count);
}

void DoubleProducts(
  const FmmTranslation<double>& product, const BoxPair* pairs, std::ptrdiff_t count)
{
  ProductsFor(product, pairs, count);
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shape
{

HWY_EXPORT(FloatProducts);
HWY_EXPORT(DoubleProducts);

void AddProducts(const FmmTranslation<float>& product, const BoxPair* pairs, std::ptrdiff_t count)
{
  HWY_DYNAMIC_DISPATCH(FloatProducts)(product, pairs, count);
}

void AddProducts(const FmmTranslation<double>& product, const BoxPair* pairs, std::ptrdiff_t count)
{
  HWY_DYNAMIC_DISPATCH(DoubleProducts)(product, pairs, count);
}

} // namespace shape
#endif
