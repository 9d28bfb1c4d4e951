#pragma once

#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"

#include <functional>
#include <vector>

namespace shape
{

/// Returns values at the points of a cage (3 x n), interpolated at the point closest to position i.
Eigen::Vector3d InterpolateOnCage(const std::vector<CageTriangle>& triangles,
  const Eigen::Matrix3Xd& values, const CagePositions& positions, Eigen::Index i);

/// Calls step(i) for each position and, if gradients are asked for, gradient(i), in parallel.
/// triangles: the number of those that each call takes. Throws Aborted.
CageMotion MoveEach(const CagePositions& positions, int triangles,
  const std::function<Eigen::RowVector3d(Eigen::Index i)>& step,
  const std::function<Eigen::Matrix3d(Eigen::Index i)>& gradient, const Progress& progress);

} // namespace shape
