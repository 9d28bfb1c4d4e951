#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace shape
{

/// Finds the triangle of a planar triangulation that contains a position. A locator is built in
/// linear time.
class PlanarLocator
{
public:
  /// points: n x 2, finite. triangles: m x 3; a triangle that is not counter-clockwise is ignored.
  /// Both arguments are kept by reference. leftOut: numbers of further triangles to ignore.
  PlanarLocator(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
    const std::vector<int>& leftOut = {});

  /// Returns the lowest-numbered triangle that contains the position, inside or on its boundary;
  /// -1 if none does. The choice of the triangle is exact; the barycentric coordinates are rounded.
  SurfacePoint Find(const Eigen::RowVector2d& position) const;

  /// Calls use(triangle) for the triangles whose boxes may intersect the given box, until a call
  /// returns true. The order is fixed, and a triangle may be visited several times. Returns whether
  /// a call returned true.
  bool AnyNear(const Eigen::RowVector2d& lower, const Eigen::RowVector2d& upper,
    const std::function<bool(int)>& use) const;

private:
  std::array<int, 2> CellOf(const Eigen::RowVector2d& position) const;

  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Triangles;
  Eigen::RowVector2d Lower, Upper; ///< the corners of the points' bounding box
  double CellSize = 1.0;
  std::array<int, 2> Cells = { 1, 1 };
  /// the triangles at cell i, ascending: Inside[First[i]] to Inside[First[i + 1] - 1]
  std::vector<int> First, Inside;
};

} // namespace shape
