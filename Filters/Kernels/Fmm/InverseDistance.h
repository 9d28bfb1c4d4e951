#pragma once

#include <cstddef>

namespace shape
{

/// A range [Begin, End) of sources.
struct SourceSpan
{
  int Begin = 0, End = 0;
};

/// The relative error of each 1/r. Rounding: only rounding errors. Small: at most 1e-8, in half the
/// time.
enum class RootError
{
  Rounding,
  Small
};

/**
 * Arguments of the innermost loop, which sums q_j / r or its gradient over ranges of sources, with
 * r = |y_i - x_j|.
 *
 * The lanes of a vector are points; each source is read once for one or two vectors of points. The
 * instruction set is chosen at run time (Highway). Newton steps improve the processor's
 * approximation of 1/r. On processors where this approximation is in single precision, squared
 * distances must lie between 1e-37 and 1e37. Callers therefore scale the coordinates to about one.
 * The sums at a point that coincides with a source are not finite. The sum at a point has the same
 * bits for any set of other points.
 */
struct InverseDistanceSum
{
  const double* Sources = nullptr; ///< for each source: x, y, z, q_1, ..., q_Columns
  int Columns = 3;                 ///< number of charges of a source: 1, 2 or 3
  const SourceSpan* Spans = nullptr;
  int SpanCount = 0;
  const double* Points = nullptr; ///< coordinate c of point i is Points[i + c * PointStride]
  std::ptrdiff_t PointStride = 0;
  int PointCount = 0;
  double* Values = nullptr; ///< sum number c at point i is added to Values[i + c * ValueStride]
  std::ptrdiff_t ValueStride = 0;
  RootError Error = RootError::Rounding;
};

/// Adds sum_j q_j / r to the values: column c is the potential of charge c.
void AddPotentials(const InverseDistanceSum& sum);

/// Adds the gradients: column 3 c + d is the derivative along axis d of the potential of charge c.
void AddGradients(const InverseDistanceSum& sum);

} // namespace shape
