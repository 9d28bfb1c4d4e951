#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Cage/Private/MeanValueMap.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Cage/Private/MeanValueMap.h"
#include "Cage/Private/TriangleView-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No names without a namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

/// The angles of the edges, as seen from the positions.
template <typename Number>
struct EdgeAngles
{
  Number Angles[3];
  Number Shares[3]; ///< divided by the distances of the edges' lines
};

template <typename Number>
HWY_INLINE EdgeAngles<Number> FindAngles(
  const CageTriangle& triangle, const TriangleView<Number>& view)
{
  EdgeAngles<Number> edges;
  for (int k = 0; k < 3; ++k)
  {
    const Number& line = view.LineDistances[k];
    edges.Angles[k] =
      Angle(Set(triangle.Lengths[k]) * line, line * line + view.Begins[k] * view.Ends[k]);
    edges.Shares[k] = edges.Angles[k] / line;
  }
  return edges;
}

/// M / h from its definition: sum_k theta_k beta_k / (2 rho_k h), where beta_k is the side of edge
/// k. It loses as many digits as h is smaller than the distance.
template <typename Number>
HWY_INLINE Number ComputeHighMean(const TriangleView<Number>& view, const EdgeAngles<Number>& edges)
{
  return Set(0.5) *
    (edges.Shares[0] * view.Sides[0] + edges.Shares[1] * view.Sides[1] +
      edges.Shares[2] * view.Sides[2]) /
    view.Height;
}

/**
 * M / h near the plane. In the plane the angles alpha_k of the edges sum to 2 pi inside the
 * triangle and to 0 outside, with the signs of beta_k. What is left, of the order of h^2, is summed
 * without cancellation:
 *
 *   alpha - theta beta / rho = (alpha - theta) + theta h^2 / (rho (rho + beta)),
 *   alpha - theta = [atan(s h^2 / ((rho + beta) (rho beta + s^2)))] from the begin s to the end.
 */
template <typename Number>
HWY_INLINE Number ComputeLowMean(const TriangleView<Number>& view, const EdgeAngles<Number>& edges)
{
  const Number& height = view.Height;
  const Number square = height * height;
  Mask isOutside = Set(0.0) < Set(0.0);
  Number sum = MakeConstant<Number>(0.0);
  for (int k = 0; k < 3; ++k)
  {
    const Mask isBeyond = ValueOf(view.Sides[k]) < Set(0.0);
    isOutside = hn::Or(isOutside, isBeyond);
    const Number side = NegateIf(isBeyond, view.Sides[k]);
    const Number& line = view.LineDistances[k];
    const Number around = line + side;
    const auto difference = [&](const Number& s) HWY_ATTR
    { return Angle(s * square, around * (line * side + s * s)); };
    const Number rest = (difference(view.Ends[k]) - difference(view.Begins[k])) / height +
      edges.Shares[k] * height / around;
    sum = sum + NegateIf(isBeyond, rest);
  }
  const Number whole =
    Select(isOutside, MakeConstant<Number>(0.0), MakeConstant<Number>(M_PI) / height);
  return whole - Set(0.5) * sum;
}

/**
 * Finds the shares of a triangle in the mean value weights of its corners, up to a factor that is
 * common to all points of the cage (Ju, Schaefer and Warren, "Mean value coordinates for closed
 * triangular meshes", 2005, section 4). They are 0 if the position lies in the triangle's plane; it
 * must not lie on the triangle.
 *
 * The paper's mean vector is m = sum_k theta_k n_k / 2, where theta_k is the angle of edge k and
 * n_k the normal of the plane through it and x. The weights of the corners, w_i = m . N_i / det
 * with N_i the cross product of the other two corners, cancel near the plane. In coordinates of the
 * plane they are
 *
 *   w_i = b_i M / h + h / (2 A) sum_k theta_k e_k . e_i / (2 |e_k| rho_k),
 *
 * with the height h, the area A, the edges e_k, the barycentric coordinates b_i of x's projection,
 * the distances rho_k of the edges' lines, and M = m . n = h^2 (integral of 1 / r^4 over the
 * triangle).
 */
template <typename Number>
HWY_INLINE void FindShares(
  const CageTriangle& triangle, const TriangleView<Number>& view, Number (&shares)[3])
{
  // Lengths are relative to the size of the cage. A lower height changes the result by less.
  const Wide flat = Set(1e-15);
  const Wide height = Absolute(ValueOf(view.Height));
  const Mask isFlat = height < flat;
  const EdgeAngles<Number> edges = FindAngles(triangle, view);
  const Wide nearest = Smaller(
    ValueOf(view.Distances[0]), Smaller(ValueOf(view.Distances[1]), ValueOf(view.Distances[2])));
  // Below a corner, the angles in the plane are undefined; there the definition loses a digit.
  const Mask isHigh = nearest < Set(20.0) * height;
  Number mean = ComputeHighMean(view, edges);
  if (!hn::AllTrue(Tag(), isHigh))
  {
    mean = Select(isHigh, mean, ComputeLowMean(view, edges));
  }
  Number ratios[3];
  for (int k = 0; k < 3; ++k)
  {
    ratios[k] =
      Set(0.5 / (triangle.Lengths[k] * triangle.TwiceArea)) * edges.Shares[k] * view.Height;
  }
  for (int i = 0; i < 3; ++i)
  {
    const Number share = view.Barycentric[i] * mean + Set(triangle.EdgeProducts(0, i)) * ratios[0] +
      Set(triangle.EdgeProducts(1, i)) * ratios[1] + Set(triangle.EdgeProducts(2, i)) * ratios[2];
    shares[i] = Select(isFlat, MakeConstant<Number>(0.0), share);
  }
}

/// A row of sums for each coordinate, and the sum of the shares.
template <typename Number>
struct MeanValueSums
{
  Number Steps[3];
  Number Total;
};

template <typename Number>
HWY_INLINE MeanValueSums<Number> Sum(const std::vector<CageTriangle>& triangles,
  const Eigen::Matrix3Xd& steps, const PositionBlock& block, int lane)
{
  const Number zero = MakeConstant<Number>(0.0);
  const WideVector position = Load(block.Points, lane), near = Load(block.Near, lane);
  MeanValueSums<Number> sums{ { zero, zero, zero }, zero };
  for (const CageTriangle& triangle : triangles)
  {
    Number shares[3];
    FindShares(triangle, SeeTriangle<Number>(triangle, position), shares);
    for (int k = 0; k < 3; ++k)
    {
      // Relative to the step of the closest point, whose neighbours have large weights.
      const WideVector step = Set(steps.col(triangle.Corners[k])) - near;
      sums.Steps[0] = sums.Steps[0] + step.X * shares[k];
      sums.Steps[1] = sums.Steps[1] + step.Y * shares[k];
      sums.Steps[2] = sums.Steps[2] + step.Z * shares[k];
      sums.Total = sums.Total + shares[k];
    }
  }
  return sums;
}

void MeanValueSteps(const std::vector<CageTriangle>& triangles, const Eigen::Matrix3Xd& steps,
  const PositionBlock& block, StepBlock& result)
{
  for (int lane = 0; lane < PositionBlock::Size; lane += static_cast<int>(hn::Lanes(Tag())))
  {
    const MeanValueSums<Wide> sums = Sum<Wide>(triangles, steps, block, lane);
    for (int r = 0; r < 3; ++r)
    {
      Store(Load(block.Near[r] + lane) + sums.Steps[r] / sums.Total, result.Steps[r] + lane);
    }
  }
}

void MeanValueSlopes(const std::vector<CageTriangle>& triangles, const Eigen::Matrix3Xd& steps,
  const PositionBlock& block, SlopeBlock& result)
{
  for (int lane = 0; lane < PositionBlock::Size; lane += static_cast<int>(hn::Lanes(Tag())))
  {
    const MeanValueSums<WideLinear> sums = Sum<WideLinear>(triangles, steps, block, lane);
    for (int r = 0; r < 3; ++r)
    {
      const WideLinear step = sums.Steps[r] / sums.Total;
      for (int c = 0; c < 3; ++c)
      {
        Store(step.Slope[c], result.Slopes[3 * r + c] + lane);
      }
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace shape
{

HWY_EXPORT(MeanValueSteps);
HWY_EXPORT(MeanValueSlopes);

MeanValueMap::MeanValueMap(const Mesh& cage, const Eigen::MatrixXd& steps)
  : TriangleSumMap(cage, steps)
{
}

void MeanValueMap::FindSteps(const PositionBlock& block, StepBlock& result) const
{
  HWY_DYNAMIC_DISPATCH(MeanValueSteps)(this->Triangles, this->Steps, block, result);
}

void MeanValueMap::FindSlopes(const PositionBlock& block, SlopeBlock& result) const
{
  HWY_DYNAMIC_DISPATCH(MeanValueSlopes)(this->Triangles, this->Steps, block, result);
}

} // namespace shape

#endif // HWY_ONCE
