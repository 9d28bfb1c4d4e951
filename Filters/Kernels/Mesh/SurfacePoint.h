#pragma once

#include <Eigen/Core>

namespace shape
{

/// A point on a surface: a triangle, and barycentric coordinates >= 0 whose sum is 1. On an edge
/// the coordinate of the opposite corner is exactly 0; at a vertex one coordinate is exactly 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

} // namespace shape
