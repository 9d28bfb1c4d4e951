// Included once for each set of instructions, so without #pragma once.
#if defined(SHAPE_CAGE_TRIANGLE_VIEW) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPE_CAGE_TRIANGLE_VIEW
#undef SHAPE_CAGE_TRIANGLE_VIEW
#else
#define SHAPE_CAGE_TRIANGLE_VIEW
#endif

#include "Cage/Private/CageTriangle.h"
#include "Cage/Private/WideNumber-inl.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace shape::HWY_NAMESPACE
{

/// A vector for each position.
struct WideVector
{
  Wide X, Y, Z;
};

HWY_INLINE WideVector Load(const double (&from)[3][PositionBlock::Size], int lane)
{
  return { Load(from[0] + lane), Load(from[1] + lane), Load(from[2] + lane) };
}

HWY_INLINE WideVector Set(const Eigen::Vector3d& a)
{
  return { Set(a.x()), Set(a.y()), Set(a.z()) };
}

HWY_INLINE WideVector operator-(const WideVector& a, const WideVector& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

HWY_INLINE WideVector operator*(const Wide& a, const WideVector& b)
{
  return { a * b.X, a * b.Y, a * b.Z };
}

HWY_INLINE Wide Dot(const WideVector& a, const WideVector& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

/// A number with this value and gradient.
template <typename Number>
HWY_INLINE Number MakeNumber(const Wide& value, const WideVector& slope)
{
  return MakeNumber<Number>(value, slope.X, slope.Y, slope.Z);
}

/// A triangle in coordinates of its plane, as positions x see it. Number: Wide, or WideLinear with
/// the gradients with respect to x.
template <typename Number>
struct TriangleView
{
  Number Height;           ///< of the plane above x, along the normal
  Number Distances[3];     ///< of the corners from x
  Number Sides[3];         ///< of x's projection from each edge's line, positive inside
  Number Begins[3];        ///< of each edge from x's projection, along the edge
  Number Ends[3];          ///< of each edge, in the same way
  Number LineDistances[3]; ///< of each edge's line from x
  Number Barycentric[3];   ///< of x's projection
};

/// Returns heights that are not 0: in the plane the formulas are undefined, although their
/// gradients are continuous. They differ by 1e-8 of the distance from the edges. rays: to the
/// corners.
HWY_INLINE Wide LiftHeight(
  const CageTriangle& triangle, const WideVector (&rays)[3], const Wide& height)
{
  Wide square = Dot(rays[0], rays[0]); // of the distance from the edges
  for (int k = 0; k < 3; ++k)
  {
    const WideVector& ray = rays[(k + 1) % 3];
    const WideVector tangent = Set(triangle.Tangents[k]);
    const Wide back = // from the closest point of the edge to its begin
      Smaller(Larger(Dot(tangent, ray), Set(-triangle.Lengths[k])), Set(0.0));
    const WideVector closest = ray - back * tangent;
    square = Smaller(square, Dot(closest, closest));
  }
  const Wide lowest = Set(1e-8) * Root(square);
  return Select(Absolute(height) < lowest, WithSign(lowest, height), height);
}

template <typename Number>
HWY_INLINE TriangleView<Number> SeeTriangle(const CageTriangle& triangle, const WideVector& x)
{
  const WideVector rays[3] = { Set(triangle.Points[0]) - x, Set(triangle.Points[1]) - x,
    Set(triangle.Points[2]) - x };
  Wide height = Dot(Set(triangle.Normal), rays[0]);
  if constexpr (!std::is_same_v<Number, Wide>)
  {
    height = LiftHeight(triangle, rays, height);
  }
  TriangleView<Number> view;
  view.Height = MakeNumber<Number>(height, Set(-triangle.Normal));
  for (int k = 0; k < 3; ++k)
  {
    const WideVector& ray = rays[(k + 1) % 3];
    const WideVector inward = Set(triangle.Inward[k]), tangent = Set(triangle.Tangents[k]);
    const Wide distance = Root(Dot(rays[k], rays[k]));
    view.Distances[k] = MakeNumber<Number>(distance, (Set(-1.0) / distance) * rays[k]);
    view.Sides[k] = MakeNumber<Number>(Set(0.0) - Dot(inward, ray), inward);
    view.Begins[k] = MakeNumber<Number>(Dot(tangent, ray), Set(-1.0) * tangent);
    view.Ends[k] = view.Begins[k] + Set(triangle.Lengths[k]);
    view.LineDistances[k] = Root(view.Height * view.Height + view.Sides[k] * view.Sides[k]);
    view.Barycentric[k] = Set(triangle.Lengths[k] / triangle.TwiceArea) * view.Sides[k];
  }
  return view;
}

} // namespace shape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
