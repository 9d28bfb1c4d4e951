#include "Cage/Private/GreenWeights.h"

#include <cmath>

namespace shape
{
namespace
{

/// The solid angle of the triangle, positive if its back is seen (Van Oosterom and Strackee, "The
/// solid angle of a plane triangle", 1983).
template <typename Number>
Number ComputeSolidAngle(const CageTriangle& triangle, const TriangleView<Number>& view)
{
  Number below = view.Distances[0] * view.Distances[1] * view.Distances[2];
  for (int k = 0; k < 3; ++k)
  {
    // The product of the edge's two ends, as vectors from the position.
    const Number product =
      view.LineDistances[k] * view.LineDistances[k] + view.Begins[k] * view.Ends[k];
    below = below + view.Distances[k] * product;
  }
  return 2.0 * Angle(triangle.TwiceArea * view.Height, below);
}

/// The integral of 1 / r along edge k. The position must not lie on the edge.
template <typename Number>
Number ComputeEdgePotential(const TriangleView<Number>& view, int k)
{
  const Number& begin = view.Begins[k];
  const Number& end = view.Ends[k];
  const Number& first = view.Distances[(k + 1) % 3];
  const Number& last = view.Distances[(k + 2) % 3];
  if (ValueOf(begin) > 0.0)
  {
    return Logarithm((last + end) / (first + begin));
  }
  if (ValueOf(end) < 0.0)
  {
    return Logarithm((first - begin) / (last - end));
  }
  return Logarithm(
    (last + end) * (first - begin) / (view.LineDistances[k] * view.LineDistances[k]));
}

} // namespace

template <typename Number>
GreenShares<Number> ComputeGreenShares(
  const CageTriangle& triangle, const TriangleView<Number>& view)
{
  // Lengths are relative to the size of the cage.
  constexpr double flat = 1e-13;
  const Number zero = MakeLinear<Number>(0.0, Eigen::Vector3d::Zero());
  const bool isFlat = std::abs(ValueOf(view.Height)) < flat;
  const Number angle = isFlat ? zero : ComputeSolidAngle(triangle, view);
  GreenShares<Number> shares{ { zero, zero, zero }, (0.25 / M_PI) * angle,
    isFlat ? zero : -1.0 * view.Height * angle };
  for (int k = 0; k < 3; ++k)
  {
    if (ValueOf(view.LineDistances[k]) < flat)
    {
      continue; // the potential is infinite, or times a length of 0
    }
    const Number potential = ComputeEdgePotential(view, k);
    shares.Normal = shares.Normal + view.Sides[k] * potential;
    const Number moment =
      (0.25 / (M_PI * triangle.TwiceArea * triangle.Lengths[k])) * view.Height * potential;
    for (int i = 0; i < 3; ++i)
    {
      shares.Points[i] = shares.Points[i] + triangle.EdgeProducts(k, i) * moment;
    }
  }
  shares.Normal = (0.25 / M_PI) * shares.Normal;
  return shares;
}

template GreenShares<double> ComputeGreenShares(const CageTriangle&, const TriangleView<double>&);
template GreenShares<LinearNumber> ComputeGreenShares(
  const CageTriangle&, const TriangleView<LinearNumber>&);

} // namespace shape
