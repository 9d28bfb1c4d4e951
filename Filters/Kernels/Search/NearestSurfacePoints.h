#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/// Returns, for each row of `queries` (q x d), the nearest row of `rows` (n x d, n >= 1); the first
/// if several are equally near. Matrix products in single precision compute the distances: in a
/// hundred dimensions this is faster than any tree, and exact up to rounding. Throws Aborted.
Eigen::VectorXi FindNearestRows(
  const Eigen::MatrixXd& queries, const Eigen::MatrixXd& rows, const Progress& progress = {});

/**
 * Finds, for each row of `queries` (q x d), a nearby point on the surface whose vertices are the
 * rows of `points` (n x d), in all d dimensions. The search starts at the nearest vertex
 * (FindNearestRows), takes the nearest point in the triangles there, and walks to triangles that
 * share a corner while the distance falls. In many dimensions this is a fast approximation of the
 * nearest point. Starting from a subset of the vertices would end elsewhere on thin parts, where
 * maps would then be wrong.
 *
 * triangles: m x 3; vertices without a triangle are never targets. Throws Aborted.
 */
SurfacePoints FindNearestSurfacePoints(const Eigen::MatrixXd& queries,
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
