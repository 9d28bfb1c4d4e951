#pragma once

#include "Mesh/Surface.h"
#include "Search/TriangleBoxes.h"

#include <Eigen/Core>

#include <memory>

namespace shape
{

/// Counts how often rays cross a surface. Outside a closed surface the number is even, and inside
/// it is odd, whatever the orientation of the triangles. With holes, most rays still decide
/// correctly (Takayama, Jacobson, Kavan and Sorkine-Hornung, "A simple method for correcting facet
/// orientations in polygon meshes based on ray casting", 2014).
class CrossingCounter
{
public:
  /// surface: with at least one triangle.
  explicit CrossingCounter(Surface surface);

  /// Returns the number of triangles that a ray crosses, except the triangle `skipped`, which may
  /// be -1.
  int Count(
    const Eigen::RowVector3d& origin, const Eigen::RowVector3d& direction, int skipped) const;

  /// Returns whether most of `rays` rays from a position cross the surface an odd number of times.
  bool IsInside(const Eigen::RowVector3d& position, int rays) const;

  /// Returns the share of `rays` random positions in a set of triangles whose two sides are both
  /// inside or both outside: 0 for a part of the boundary of a solid, 1 for a wall in it or a sheet
  /// beside it.
  double ComputeRedundancy(const std::vector<int>& triangles, int rays) const;

private:
  shape::Surface Crossed;
  std::shared_ptr<const BoxTree> Boxes;
};

} // namespace shape
