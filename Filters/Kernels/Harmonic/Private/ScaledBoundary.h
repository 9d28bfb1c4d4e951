#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Boundary and targets of a harmonic volume map. Each is moved to the origin and scaled so that
/// the longest side of its box is 1, because the method's thresholds are absolute. Points and
/// triangles are sorted, so the map does not depend on the input's numbering or its distribution
/// over processes.
struct ScaledBoundary
{
  shape::Surface Surface;  ///< without unused points, facing outwards, sorted by position
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
