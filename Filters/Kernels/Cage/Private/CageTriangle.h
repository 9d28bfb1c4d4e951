#pragma once

#include "Cage/Private/LinearNumber.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <array>
#include <type_traits>
#include <vector>

namespace shape
{

/// A triangle of a cage, with what all positions need. Edge k is opposite to corner k and leads
/// from corner k + 1 to corner k + 2.
struct CageTriangle
{
  std::array<int, 3> Corners;
  std::array<Eigen::Vector3d, 3> Points;
  Eigen::Vector3d Normal;                  ///< unit, outwards
  std::array<Eigen::Vector3d, 3> Tangents; ///< unit, along each edge
  std::array<Eigen::Vector3d, 3> Inward;   ///< unit, in the plane, from each edge into the triangle
  std::array<double, 3> Lengths;           ///< of the edges
  Eigen::Matrix3d EdgeProducts;            ///< dot products of the edges
  double TwiceArea;
};

/// Returns the triangles of a cage. Throws InvalidInput if one has no area.
std::vector<CageTriangle> MakeCageTriangles(const Mesh& cage);

/// A triangle in coordinates of its plane, as a position x sees it. Each entry is a double, or a
/// LinearNumber with its gradient with respect to x.
template <typename Number>
struct TriangleView
{
  Number Height;                       ///< of the plane above x, along the normal
  std::array<Number, 3> Distances;     ///< of the corners from x
  std::array<Number, 3> Sides;         ///< of x's projection from each edge's line, positive inside
  std::array<Number, 3> Begins;        ///< of each edge from x's projection, along the edge
  std::array<Number, 3> Ends;          ///< of each edge, in the same way
  std::array<Number, 3> LineDistances; ///< of each edge's line from x
  std::array<Number, 3> Barycentric;   ///< of x's projection
};

/// Returns a height that is not 0: in the plane the formulas are undefined, although their
/// gradients are continuous. It differs by 1e-8 of the distance from the edges. rays: to the
/// corners.
double LiftHeight(
  const CageTriangle& triangle, const std::array<Eigen::Vector3d, 3>& rays, double height);

template <typename Number>
TriangleView<Number> SeeTriangle(const CageTriangle& triangle, const Eigen::Vector3d& x)
{
  TriangleView<Number> view;
  const std::array<Eigen::Vector3d, 3> rays = { triangle.Points[0] - x, triangle.Points[1] - x,
    triangle.Points[2] - x };
  double height = triangle.Normal.dot(rays[0]);
  if constexpr (!std::is_same_v<Number, double>)
  {
    height = LiftHeight(triangle, rays, height);
  }
  view.Height = MakeLinear<Number>(height, -triangle.Normal);
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d& ray = rays[(k + 1) % 3];
    const double distance = rays[k].norm();
    view.Distances[k] = MakeLinear<Number>(distance, rays[k] / -distance);
    view.Sides[k] = MakeLinear<Number>(-triangle.Inward[k].dot(ray), triangle.Inward[k]);
    view.Begins[k] = MakeLinear<Number>(triangle.Tangents[k].dot(ray), -triangle.Tangents[k]);
    view.Ends[k] = view.Begins[k] + triangle.Lengths[k];
    view.LineDistances[k] = Root(view.Height * view.Height + view.Sides[k] * view.Sides[k]);
    view.Barycentric[k] = (triangle.Lengths[k] / triangle.TwiceArea) * view.Sides[k];
  }
  return view;
}

} // namespace shape
