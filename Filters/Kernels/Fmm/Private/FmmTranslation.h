#pragma once

#include <cstddef>

namespace shape
{

/// A translation from box From to box To. Both boxes are mirrored along the axes whose bits are set
/// in Mirror: bit 0 is x, bit 1 is y and bit 2 is z.
struct BoxPair
{
  int To = 0, From = 0, Mirror = 0;
};

/**
 * Arguments of out[To] += signs * (matrix * (signs * in[From])), for many pairs of boxes with one
 * matrix.
 *
 * A box has `Columns` columns of coefficients, one after the other. The matrix is multiplied by
 * twelve columns at a time, with vector instructions chosen at run time (Highway). The order of
 * summation in a column does not depend on the other columns. All strides are multiples of 16.
 */
template <typename Real>
struct FmmTranslation
{
  /// Maximum number of rows, and of columns, of a matrix.
  static constexpr int Most = 1600;

  /// column by column; each column starts RowStride numbers after the previous one
  const Real* Matrix = nullptr;
  int RowStride = 0;
  int Rows = 0;  ///< number of rows of the matrix, which is padded with zeros to whole vectors
  int Inner = 0; ///< number of columns of the matrix
  /// For each group of sixteen rows, the number of leading columns that are multiplied; descending.
  /// Null: all Inner columns.
  const int* Extents = nullptr;
  /// 8 x SignStride: the signs for each value of Mirror; null: no mirroring
  const Real* Signs = nullptr;
  int SignStride = 0;
  int Columns = 3; ///< number of columns of a box: 1, 2 or 3
  const Real* In = nullptr;
  int InStride = 0; ///< each column starts this many numbers after the previous one
  Real* Out = nullptr;
  int OutStride = 0;
};

void AddProducts(const FmmTranslation<float>& product, const BoxPair* pairs, std::ptrdiff_t count);
void AddProducts(const FmmTranslation<double>& product, const BoxPair* pairs, std::ptrdiff_t count);

} // namespace shape
