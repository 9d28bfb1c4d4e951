#pragma once

#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A surface without the points that no triangle uses.
struct CompactSurface
{
  /// name: of the surface, in messages. Throws InvalidInput when RequireManifold does.
  CompactSurface(const shape::Surface& given, const std::string& name);

  /// Returns the values of all given points (one per row). An unused point has those of the nearest
  /// corner of the closest triangle.
  Eigen::MatrixXd Expand(const Eigen::MatrixXd& values) const;
  SurfacePoints Expand(const SurfacePoints& map) const;

  shape::Surface Surface;
  std::vector<int> Points;    ///< their indices in the given surface
  Eigen::VectorXi PositionOf; ///< n: the index of each point in Points, or -1

private:
  /// Returns for each given point the compact point that stands for it.
  std::vector<int> Representatives() const;

  shape::Surface Given;
};

} // namespace shape
