#pragma once

#include <cstddef>

namespace shape
{

/// Box From is translated to box To; both are mirrored along the axes in `Mirror`.
struct BoxPair
{
  int To = 0, From = 0, Mirror = 0;
};

/**
 * Arguments of out[To] += signs x matrix x (signs x in[From]) for many pairs of boxes with one
 * matrix.
 *
 * A box has `Columns` contiguous columns. Twelve columns are multiplied by the matrix together,
 * with vector instructions chosen at run time (Highway). The order of summation in a column does
 * not depend on the other columns. All strides are multiples of 16.
 */
template <typename Real>
struct FmmTranslation
{
  /// Maximum number of rows, and of columns, of a matrix.
  static constexpr int Most = 1600;

  const Real* Matrix = nullptr; ///< stored by columns, RowStride apart
  int RowStride = 0;
  int Rows = 0;  ///< rows of the matrix; it is padded with zeros to whole vectors
  int Inner = 0; ///< columns of the matrix
  /// Number of leading columns that are not zero, for each sixteen rows, descending; null: Inner.
  const int* Extents = nullptr;
  const Real* Signs = nullptr; ///< [mirror][SignStride]; null: no mirroring
  int SignStride = 0;
  int Columns = 3; ///< columns of a box: 1, 2 or 3
  const Real* In = nullptr;
  int InStride = 0; ///< distance between columns
  Real* Out = nullptr;
  int OutStride = 0;
};

void AddProducts(const FmmTranslation<float>& product, const BoxPair* pairs, std::ptrdiff_t count);
void AddProducts(const FmmTranslation<double>& product, const BoxPair* pairs, std::ptrdiff_t count);

} // namespace shape
