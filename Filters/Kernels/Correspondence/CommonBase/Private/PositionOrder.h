#pragma once

#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface whose points and triangles are ordered by position, so that what is computed with it
/// does not depend on how the given surface was numbered or divided into pieces.
struct PositionOrder
{
  explicit PositionOrder(const Surface& given);

  Surface Shape;              ///< triangles keep the order of their corners
  std::vector<int> Points;    ///< for each point, the given one
  std::vector<int> Triangles; ///< for each triangle, the given one
  std::vector<int> PointOf;   ///< for each given point, the point here
};

/// Returns values at the given points, from those at the ordered points (a row for each).
Eigen::VectorXi AsGiven(const Eigen::VectorXi& values, const PositionOrder& order);

/// Returns a map of the given points of one surface to the given triangles of another one.
SurfacePoints AsGiven(const SurfacePoints& map, const PositionOrder& from, const PositionOrder& to);

} // namespace shape
