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
/// orientations in polygon meshes based on ray casting", 2014). Each connected component is taken
/// by itself: where two components cross each other, the number is even inside of both.
class CrossingCounter
{
public:
  /// surface: with at least one triangle.
  explicit CrossingCounter(Surface surface);

  /// Returns whether most of `rays` rays from a position cross the component of a point an odd
  /// number of times.
  bool IsInside(const Eigen::RowVector3d& position, int point, int rays) const;

  /// Returns the share of `rays` random positions in a set of connected triangles whose two sides
  /// are both inside or both outside: 0 for a part of the boundary of a solid, 1 for a wall in it
  /// or a sheet beside it.
  double ComputeRedundancy(const std::vector<int>& triangles, int rays) const;

private:
  /// Returns the number of triangles of a component that a ray crosses, except the triangle
  /// `skipped`, which may be -1.
  int Count(const Eigen::RowVector3d& origin, const Eigen::RowVector3d& direction, int component,
    int skipped) const;

  shape::Surface Crossed;
  std::shared_ptr<const BoxTree> Boxes;
};

} // namespace shape
