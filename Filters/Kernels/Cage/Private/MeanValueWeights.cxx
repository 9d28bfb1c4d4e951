#include "Cage/Private/MeanValueWeights.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// The angles of the edges, as seen from the position.
template <typename Number>
std::array<Number, 3> FindAngles(const CageTriangle& triangle, const TriangleView<Number>& view)
{
  std::array<Number, 3> angles;
  for (int k = 0; k < 3; ++k)
  {
    const Number& line = view.LineDistances[k];
    angles[k] = Angle(triangle.Lengths[k] * line, line * line + view.Begins[k] * view.Ends[k]);
  }
  return angles;
}

/// M / h from its definition: sum_k theta_k beta_k / (2 rho_k h), where beta_k is the side of edge
/// k. It loses as many digits as h is smaller than the distance.
template <typename Number>
Number ComputeHighMean(const TriangleView<Number>& view, const std::array<Number, 3>& angles)
{
  Number sum = MakeLinear<Number>(0.0, Eigen::Vector3d::Zero());
  for (int k = 0; k < 3; ++k)
  {
    sum = sum + angles[k] * view.Sides[k] / view.LineDistances[k];
  }
  return 0.5 * sum / view.Height;
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
Number ComputeLowMean(const TriangleView<Number>& view, const std::array<Number, 3>& angles)
{
  const Number& height = view.Height;
  const Number square = height * height;
  bool isInside = true;
  Number sum = MakeLinear<Number>(0.0, Eigen::Vector3d::Zero());
  for (int k = 0; k < 3; ++k)
  {
    const bool isBeyond = ValueOf(view.Sides[k]) < 0.0;
    isInside = isInside && !isBeyond;
    const Number side = NegateIf(isBeyond, view.Sides[k]);
    const Number& line = view.LineDistances[k];
    const auto difference = [&](const Number& s)
    { return Angle(s * square, (line + side) * (line * side + s * s)); };
    const Number rest = (difference(view.Ends[k]) - difference(view.Begins[k])) / height +
      angles[k] * height / (line * (line + side));
    sum = sum + NegateIf(isBeyond, rest);
  }
  const Number whole = MakeLinear<Number>(isInside ? M_PI : 0.0, Eigen::Vector3d::Zero());
  return whole / height - 0.5 * sum;
}

} // namespace

template <typename Number>
std::array<Number, 3> ComputeMeanValueShares(
  const CageTriangle& triangle, const TriangleView<Number>& view)
{
  // Lengths are relative to the size of the cage. A lower height changes the result by less.
  constexpr double flat = 1e-15;
  const double height = std::abs(ValueOf(view.Height));
  if (height < flat)
  {
    return { MakeLinear<Number>(0.0, Eigen::Vector3d::Zero()),
      MakeLinear<Number>(0.0, Eigen::Vector3d::Zero()),
      MakeLinear<Number>(0.0, Eigen::Vector3d::Zero()) };
  }
  const std::array<Number, 3> angles = FindAngles(triangle, view);
  const double nearest = std::min(
    { ValueOf(view.Distances[0]), ValueOf(view.Distances[1]), ValueOf(view.Distances[2]) });
  // Below a corner, the angles in the plane are undefined; there the definition loses a digit.
  const Number mean =
    20.0 * height > nearest ? ComputeHighMean(view, angles) : ComputeLowMean(view, angles);
  std::array<Number, 3> ratios;
  for (int k = 0; k < 3; ++k)
  {
    ratios[k] = (0.5 / (triangle.Lengths[k] * triangle.TwiceArea)) * angles[k] * view.Height /
      view.LineDistances[k];
  }
  std::array<Number, 3> shares;
  for (int i = 0; i < 3; ++i)
  {
    shares[i] = view.Barycentric[i] * mean + triangle.EdgeProducts(0, i) * ratios[0] +
      triangle.EdgeProducts(1, i) * ratios[1] + triangle.EdgeProducts(2, i) * ratios[2];
  }
  return shares;
}

template std::array<double, 3> ComputeMeanValueShares(
  const CageTriangle&, const TriangleView<double>&);
template std::array<LinearNumber, 3> ComputeMeanValueShares(
  const CageTriangle&, const TriangleView<LinearNumber>&);

} // namespace shape
