#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface whose points and triangles are sorted by position, without unused points: what is
/// computed from it does not depend on the numbering, or on the distribution over processes.
struct SortedSurface
{
  Mesh Surface;
  std::vector<int> Points; ///< for each of its points, the given one
};
SortedSurface SortByPosition(const Mesh& surface);

/// Boundary and targets of a harmonic volume map. Each is moved to the origin and scaled so that
/// the longest side of its box is 1, because the method's thresholds are absolute. Points and
/// triangles are sorted (SortByPosition).
struct ScaledBoundary
{
  shape::Surface Surface;  ///< without unused points, facing outwards, sorted by position
  std::vector<int> Points; ///< for each of its points, the given one
  Eigen::MatrixXd Targets; ///< n x 3: the images of its points
  Eigen::RowVector3d Origin;
  double Size = 1.0;
  Eigen::RowVector3d TargetOrigin;
  double TargetSize = 1.0; ///< 1 if all targets coincide
};

/// Throws InvalidInput unless `boundary` is one closed surface that encloses a volume, and
/// `targets` has three finite coordinates for each of its points.
ScaledBoundary ScaleBoundary(const Surface& boundary, const Eigen::MatrixXd& targets);

} // namespace shape
