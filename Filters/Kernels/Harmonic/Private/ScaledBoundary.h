#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Boundary and targets of a harmonic volume map, each moved to the origin and scaled to a box of
/// longest side 1: the method's thresholds are absolute in these coordinates. Points and triangles
/// are in an order of their own, so that the map does not depend on how the input was numbered, or
/// cut among processes.
struct ScaledBoundary
{
  shape::Surface Surface;  ///< without unused points, facing outwards, ordered by position
  Eigen::MatrixXd Targets; ///< n x 3, of its points
  Eigen::RowVector3d Origin;
  double Size = 1.0;
  Eigen::RowVector3d TargetOrigin;
  double TargetSize = 1.0; ///< 1 where all targets are one point
};

/// Throws InvalidInput unless `boundary` is one closed surface that encloses a volume, and
/// `targets` has three finite coordinates for each of its points.
ScaledBoundary ScaleBoundary(const Surface& boundary, const Eigen::MatrixXd& targets);

} // namespace shape
