#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Cage/Private/GreenMap.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Cage/Private/GreenMap.h"
#include "Cage/Private/TriangleView-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No names without a namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

/// The solid angle of the triangle, positive if its back is seen (Van Oosterom and Strackee, "The
/// solid angle of a plane triangle", 1983).
template <typename Number>
HWY_INLINE Number ComputeSolidAngle(const CageTriangle& triangle, const TriangleView<Number>& view)
{
  Number below = view.Distances[0] * view.Distances[1] * view.Distances[2];
  for (int k = 0; k < 3; ++k)
  {
    // The product of the edge's two ends, as vectors from the position.
    const Number product =
      view.LineDistances[k] * view.LineDistances[k] + view.Begins[k] * view.Ends[k];
    below = below + view.Distances[k] * product;
  }
  return Set(2.0) * Angle(Set(triangle.TwiceArea) * view.Height, below);
}

/// The integral of 1 / r along edge k. The position must not lie on the edge. Which of three
/// formulas loses no digits depends on the side on which the edge is.
template <typename Number>
HWY_INLINE Number ComputeEdgePotential(const TriangleView<Number>& view, int k)
{
  const Number& begin = view.Begins[k];
  const Number& end = view.Ends[k];
  const Number& first = view.Distances[(k + 1) % 3];
  const Number& last = view.Distances[(k + 2) % 3];
  const Mask isAhead = Set(0.0) < ValueOf(begin), isBehind = ValueOf(end) < Set(0.0);
  const Number ahead = last + end, behind = first - begin;
  const Number above = Select(isAhead, ahead, Select(isBehind, behind, ahead * behind));
  const Number below = Select(isAhead, first + begin,
    Select(isBehind, last - end, view.LineDistances[k] * view.LineDistances[k]));
  return Logarithm(above / below);
}

/// The share of a triangle in Green coordinates.
template <typename Number>
struct GreenShares
{
  Number Points[3]; ///< phi of its corners
  Number Normal;    ///< psi
};

/**
 * Returns the integrals over a triangle in Green's third identity (Lipman, Levin and Cohen-Or,
 * "Green coordinates", 2008, equations 4 and 5): phi_i is the double layer potential of corner i's
 * hat function, and psi the single layer potential. Both are in closed form (Wilton et al.,
 * "Potential integrals for uniform and linear source distributions on polygonal and polyhedral
 * domains", 1984). With the height h, the edges e_k and their potentials l_k, the integrals of 1 /
 * r along them, and the solid angle Omega:
 *
 *   4 pi phi_i = b_i Omega + h / (2 A) sum_k e_i . e_k / |e_k| l_k,
 *   4 pi psi = sum_k beta_k l_k - h Omega.
 *
 * In the triangle's plane, Omega is 0 and phi_i is the mean of both sides of the plane.
 */
template <typename Number>
HWY_INLINE GreenShares<Number> FindShares(
  const CageTriangle& triangle, const TriangleView<Number>& view)
{
  // Lengths are relative to the size of the cage.
  const Wide flat = Set(1e-13), unit = Set(0.25 / M_PI);
  const Number zero = MakeConstant<Number>(0.0);
  const Number angle =
    Select(Absolute(ValueOf(view.Height)) < flat, zero, unit * ComputeSolidAngle(triangle, view));
  GreenShares<Number> shares{ { view.Barycentric[0] * angle, view.Barycentric[1] * angle,
                                view.Barycentric[2] * angle },
    Set(-1.0) * view.Height * angle };
  for (int k = 0; k < 3; ++k)
  {
    // On the edge's line the potential is infinite, or times a length of 0.
    const Number potential =
      Select(ValueOf(view.LineDistances[k]) < flat, zero, unit * ComputeEdgePotential(view, k));
    shares.Normal = shares.Normal + view.Sides[k] * potential;
    const Number moment =
      Set(1.0 / (triangle.TwiceArea * triangle.Lengths[k])) * view.Height * potential;
    for (int i = 0; i < 3; ++i)
    {
      shares.Points[i] = shares.Points[i] + Set(triangle.EdgeProducts(k, i)) * moment;
    }
  }
  return shares;
}

/// The displacements relative to that of the closest points, without these.
template <typename Number>
struct GreenSums
{
  Number Steps[3];
};

template <typename Number>
HWY_INLINE GreenSums<Number> Sum(const std::vector<CageTriangle>& triangles,
  const Eigen::Matrix3Xd& steps, const Eigen::Matrix3Xd& normalSteps, const PositionBlock& block,
  int lane)
{
  const Number zero = MakeConstant<Number>(0.0);
  const WideVector position = Load(block.Points, lane), near = Load(block.Near, lane);
  GreenSums<Number> sums{ { zero, zero, zero } };
  const auto add = [&](const Number& share, const WideVector& step) HWY_ATTR
  {
    sums.Steps[0] = sums.Steps[0] + step.X * share;
    sums.Steps[1] = sums.Steps[1] + step.Y * share;
    sums.Steps[2] = sums.Steps[2] + step.Z * share;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const CageTriangle& triangle = triangles[t];
    const GreenShares<Number> shares =
      FindShares(triangle, SeeTriangle<Number>(triangle, position));
    add(shares.Normal, Set(normalSteps.col(static_cast<Eigen::Index>(t))));
    for (int k = 0; k < 3; ++k)
    {
      add(shares.Points[k], Set(steps.col(triangle.Corners[k])) - near);
    }
  }
  return sums;
}

void GreenSteps(const std::vector<CageTriangle>& triangles, const Eigen::Matrix3Xd& steps,
  const Eigen::Matrix3Xd& normalSteps, const PositionBlock& block, StepBlock& result)
{
  for (int lane = 0; lane < PositionBlock::Size; lane += static_cast<int>(hn::Lanes(Tag())))
  {
    // The solid angles sum to 1 inside. On the cage, those of the triangles around the point are
    // left out; what is missing belongs to the point (the jump of the double layer potential).
    const GreenSums<Wide> sums = Sum<Wide>(triangles, steps, normalSteps, block, lane);
    for (int r = 0; r < 3; ++r)
    {
      Store(Load(block.Near[r] + lane) + sums.Steps[r], result.Steps[r] + lane);
    }
  }
}

void GreenSlopes(const std::vector<CageTriangle>& triangles, const Eigen::Matrix3Xd& steps,
  const Eigen::Matrix3Xd& normalSteps, const PositionBlock& block, SlopeBlock& result)
{
  for (int lane = 0; lane < PositionBlock::Size; lane += static_cast<int>(hn::Lanes(Tag())))
  {
    const GreenSums<WideLinear> sums = Sum<WideLinear>(triangles, steps, normalSteps, block, lane);
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c < 3; ++c)
      {
        Store(sums.Steps[r].Slope[c], result.Slopes[3 * r + c] + lane);
      }
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{

HWY_EXPORT(GreenSteps);
HWY_EXPORT(GreenSlopes);

namespace
{

/**
 * The normal of the moved triangle, times its stretch (Lipman, Levin and Cohen-Or 2008, section 4),
 *
 *   s = sqrt(|u'|^2 |v|^2 - 2 u'.v' u.v + |v'|^2 |u|^2) / (sqrt(8) area),
 *
 * with two edges u, v before and u', v' after the motion. s is the root mean square of the singular
 * values of the triangle's linear map. A moved triangle without area has no normal: 0.
 */
Eigen::Vector3d StretchNormal(const CageTriangle& triangle, const Eigen::MatrixXd& moved)
{
  const Eigen::Vector3d u = triangle.Points[1] - triangle.Points[0],
                        v = triangle.Points[2] - triangle.Points[0],
                        first = moved.row(triangle.Corners[0]),
                        movedU = moved.row(triangle.Corners[1]).transpose() - first,
                        movedV = moved.row(triangle.Corners[2]).transpose() - first;
  const double square = movedU.squaredNorm() * v.squaredNorm() -
    2.0 * movedU.dot(movedV) * u.dot(v) + movedV.squaredNorm() * u.squaredNorm();
  const double stretch = std::sqrt(std::max(0.0, square)) / (std::sqrt(2.0) * triangle.TwiceArea);
  return stretch * movedU.cross(movedV).normalized();
}

} // namespace

GreenMap::GreenMap(const Mesh& cage, const Eigen::MatrixXd& moved)
  : TriangleSumMap(cage, moved - cage.Points)
  , NormalSteps(3, cage.Triangles.rows())
{
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    this->NormalSteps.col(static_cast<Eigen::Index>(t)) =
      StretchNormal(this->Triangles[t], moved) - this->Triangles[t].Normal;
  }
}

void GreenMap::FindSteps(const PositionBlock& block, StepBlock& result) const
{
  HWY_DYNAMIC_DISPATCH(GreenSteps)
  (this->Triangles, this->Steps, this->NormalSteps, block, result);
}

void GreenMap::FindSlopes(const PositionBlock& block, SlopeBlock& result) const
{
  HWY_DYNAMIC_DISPATCH(GreenSlopes)
  (this->Triangles, this->Steps, this->NormalSteps, block, result);
}

} // namespace shape

#endif // HWY_ONCE
