#pragma once

#include <cstddef>

namespace shape
{

/// A range [Begin, End) of sources.
struct SourceSpan
{
  int Begin = 0, End = 0;
};

/// The relative error of each 1/r: rounding error, or at most 1e-8 at half the cost.
enum class RootError
{
  Rounding,
  Small
};

/**
 * Arguments of the innermost loop: sums of q_j / r and of its gradient, r = |y_i - x_j|, over
 * ranges of sources.
 *
 * The lanes of a vector are points; each source is read once for two or more vectors of points. The
 * instruction set is chosen at run time (Highway). 1/r is computed by the processor's approximation
 * and Newton steps. Where that approximation is in single precision, squared distances must lie in
 * 1e-37..1e37, so callers scale the coordinates to about one. The sums are not finite if a point
 * coincides with a source. The sum at a point has the same bits for any set of other points.
 */
struct InverseDistanceSum
{
  const double* Sources = nullptr; ///< interleaved: x y z q_1 .. q_Columns of each source
  int Columns = 3;                 ///< 1, 2 or 3
  const SourceSpan* Spans = nullptr;
  int SpanCount = 0;
  const double* Points = nullptr; ///< coordinate c of point i: Points[i + c * PointStride]
  std::ptrdiff_t PointStride = 0;
  int PointCount = 0;
  double* Values = nullptr; ///< output, added to: Values[i + column * ValueStride]
  std::ptrdiff_t ValueStride = 0;
  RootError Error = RootError::Rounding;
};

/// Adds sum_j q_j / r to the values, one column for each column of the charges.
void AddPotentials(const InverseDistanceSum& sum);

/// Adds the gradients: column 3 c + d is the derivative along axis d of the potential of charge c.
void AddGradients(const InverseDistanceSum& sum);

} // namespace shape
