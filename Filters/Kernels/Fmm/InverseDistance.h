#pragma once

#include <cstddef>

namespace shape
{

/// A run [Begin, End) of sources.
struct SourceSpan
{
  int Begin = 0, End = 0;
};

/// The relative error of each 1/r: of the order of rounding, or at most 1e-8 for half the work.
enum class RootError
{
  Rounding,
  Small
};

/**
 * One job of the innermost loop: sums of q_j / r and of its gradient, r = |y_i - x_j|, over spans
 * of sources.
 *
 * Lanes of a vector are points; each source is read once for two or more vectors of them. The
 * vector instructions are chosen at run time (Highway). 1/r is the processor's approximation and
 * Newton steps: where that approximation is single precision, squared distances have to lie in
 * 1e-37..1e37, so callers scale the coordinates to about one. The sums are not finite where a point
 * coincides with a source. A point's sum is the same bits whichever points stand beside it.
 */
struct InverseDistanceSum
{
  const double* Sources = nullptr; ///< x y z q_1 .. q_Columns of each source, one after the other
  int Columns = 3;                 ///< 1, 2 or 3
  const SourceSpan* Spans = nullptr;
  int SpanCount = 0;
  const double* Points = nullptr; ///< coordinate c of point i: Points[i + c * PointStride]
  std::ptrdiff_t PointStride = 0;
  int PointCount = 0;
  double* Values = nullptr; ///< what is added to: Values[i + column * ValueStride]
  std::ptrdiff_t ValueStride = 0;
  RootError Error = RootError::Rounding;
};

/// Adds sum_j q_j / r to one column of the values for each column of the charges.
void AddPotentials(const InverseDistanceSum& sum);

/// Adds the gradients: column 3 c + d is the derivative along axis d of the potential of charge c.
void AddGradients(const InverseDistanceSum& sum);

} // namespace shape
