#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <array>
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

} // namespace shape
