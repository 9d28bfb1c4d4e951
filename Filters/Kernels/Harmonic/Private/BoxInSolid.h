#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <vector>

namespace shape
{

/// An axis-aligned cube.
struct BoxCube
{
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Half = 0.0; ///< half the length of an edge

  /// The corner with the largest coordinates.
  Eigen::Vector3d Corner() const { return this->Centre.array() + this->Half; }
  Eigen::AlignedBox3d Box() const
  {
    return { this->Centre.array() - this->Half, this->Centre.array() + this->Half };
  }
  /// One of eight parts. Bit i of the octant: whether coordinate i is larger.
  BoxCube Child(int octant) const
  {
    BoxCube child{ this->Centre, 0.5 * this->Half };
    for (int axis = 0; axis < 3; ++axis)
    {
      child.Centre(axis) += (octant >> axis & 1) != 0 ? child.Half : -child.Half;
    }
    return child;
  }
  /// The radius of a ball around the cube, enlarged by rounding.
  double Radius() const { return std::sqrt(3.0) * (1.0 + 1e-12) * this->Half; }
};

/// Returns those of `triangles` that have a point in the cube, which is enlarged by 1e-9 of its
/// edge. A triangle is left out only if it has none. bounds: extended by the parts of the triangles
/// in the enlarged cube.
std::vector<int> FindTrianglesInCube(const Mesh& mesh, const std::vector<int>& triangles,
  const BoxCube& cube, Eigen::AlignedBox3d* bounds = nullptr);

/// Returns the smallest box, up to rounding outwards, around the part of a cube inside a solid.
/// bounds: those of FindTrianglesInCube. isInside: whether a position is inside the solid.
Eigen::AlignedBox3d BoundSolidInCube(const BoxCube& cube, const Eigen::AlignedBox3d& bounds,
  const std::function<bool(const Eigen::Vector3d&)>& isInside);

/**
 * Returns the volume of the part of a cube inside a solid, by the divergence theorem in space, in
 * the top face and along an edge of it.
 *
 * mesh: closed, facing out of the solid. triangles: all that meet the cube. cornerInside: whether
 * cube.Corner() is inside the solid. The planes of the cube's faces must not contain a point of the
 * mesh. The result is exact up to rounding.
 */
double ComputeVolumeInCube(
  const Mesh& mesh, const std::vector<int>& triangles, const BoxCube& cube, bool cornerInside);

} // namespace shape
