#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace shape
{

/// Finds the triangle of a planar triangulation that a place lies in; built in linear time.
class PlanarLocator
{
public:
  /// points: n x 2, finite; triangles: m x 3, of which those that are not counter-clockwise are
  /// left out. Both are kept by reference. left out: rows of triangles that do not count, either.
  PlanarLocator(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
    const std::vector<int>& leftOut = {});

  /// The lowest triangle that contains the place, inside or on its border, exactly; -1 if none
  /// does.
  SurfacePoint Find(const Eigen::RowVector2d& position) const;

  /// Calls use(triangle) for those whose boxes may meet a box, each once or more often, in a fixed
  /// order, until it returns true; returns whether it did.
  bool AnyNear(const Eigen::RowVector2d& lower, const Eigen::RowVector2d& upper,
    const std::function<bool(int)>& use) const;

private:
  std::array<int, 2> CellOf(const Eigen::RowVector2d& position) const;

  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Triangles;
  Eigen::RowVector2d Lower, Upper; ///< the box of the points
  double CellSize = 1.0;
  std::array<int, 2> Cells = { 1, 1 };
  std::vector<int> First, Inside; ///< of cell i: Inside from First[i] on, ascending
};

} // namespace shape
