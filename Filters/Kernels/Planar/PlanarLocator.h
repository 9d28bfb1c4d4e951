#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace shape
{

/// Finds the triangle of a planar triangulation that contains a position; built in linear time.
class PlanarLocator
{
public:
  /// points: n x 2, finite. triangles: m x 3; those that are not counter-clockwise are ignored.
  /// Both are kept by reference. leftOut: rows of further triangles to ignore.
  PlanarLocator(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
    const std::vector<int>& leftOut = {});

  /// Returns the lowest-numbered triangle that contains the position, inside or on its boundary;
  /// -1 if none does. Exact.
  SurfacePoint Find(const Eigen::RowVector2d& position) const;

  /// Calls use(triangle) for the triangles whose boxes may intersect the given box, in a fixed
  /// order and possibly several times, until it returns true. Returns whether it did.
  bool AnyNear(const Eigen::RowVector2d& lower, const Eigen::RowVector2d& upper,
    const std::function<bool(int)>& use) const;

private:
  std::array<int, 2> CellOf(const Eigen::RowVector2d& position) const;

  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Triangles;
  Eigen::RowVector2d Lower, Upper; ///< the box of the points
  double CellSize = 1.0;
  std::array<int, 2> Cells = { 1, 1 };
  std::vector<int> First, Inside; ///< Inside[First[i]], ... are the triangles at cell i, ascending
};

} // namespace shape
