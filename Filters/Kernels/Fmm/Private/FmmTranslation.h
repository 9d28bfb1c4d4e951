#pragma once

#include <cstddef>

namespace shape
{

/// The numbers of box From become numbers of box To; both are mirrored along the axes in `Mirror`.
struct BoxPair
{
  int To = 0, From = 0, Mirror = 0;
};

/**
 * out[To] += signs x matrix x (signs x in[From]) for many pairs of boxes with one matrix.
 *
 * A box has `Columns` columns, one after the other. Twelve columns go through the matrix together,
 * in vector instructions chosen at run time (Highway); each column's sums are taken in the same
 * order whichever columns stand beside it. All strides are multiples of 16.
 */
template <typename Real>
struct FmmTranslation
{
  /// Most rows, and most columns, of a matrix.
  static constexpr int Most = 1600;

  const Real* Matrix = nullptr; ///< by columns, RowStride apart
  int RowStride = 0;
  int Rows = 0;  ///< of the matrix; rounded up to whole vectors, the rest is zero
  int Inner = 0; ///< columns of the matrix
  /// For each sixteen rows the columns from which on they are zero, not rising; null: Inner.
  const int* Extents = nullptr;
  const Real* Signs = nullptr; ///< [mirror][SignStride]; null: nothing is mirrored
  int SignStride = 0;
  int Columns = 3; ///< of a box: 1, 2 or 3
  const Real* In = nullptr;
  int InStride = 0; ///< from one column to the next
  Real* Out = nullptr;
  int OutStride = 0;
};

void AddProducts(const FmmTranslation<float>& product, const BoxPair* pairs, std::ptrdiff_t count);
void AddProducts(const FmmTranslation<double>& product, const BoxPair* pairs, std::ptrdiff_t count);

} // namespace shape
