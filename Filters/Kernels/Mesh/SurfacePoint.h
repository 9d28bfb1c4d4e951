#pragma once

#include <Eigen/Core>

namespace shape
{

/// A point on a surface: a triangle, and barycentric coordinates >= 0 in it whose sum is 1. Those
/// opposite an edge that it lies on are exactly 0; at a vertex one of them is exactly 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

} // namespace shape
