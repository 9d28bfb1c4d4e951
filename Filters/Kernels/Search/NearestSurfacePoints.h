#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/// Returns, for each row of `queries` (q x d), the index of the nearest row of `rows` (n x d, n >=
/// 1). If several rows are equally near, it is the first. Distances are computed by matrix products
/// in single precision: in a hundred dimensions this is faster than any tree, and exact up to
/// rounding. Throws Aborted.
Eigen::VectorXi FindNearestRows(
  const Eigen::MatrixXd& queries, const Eigen::MatrixXd& rows, const Progress& progress = {});

/**
 * Finds, for each row of `queries` (q x d), a nearby point on a surface in d dimensions, whose
 * vertices are the rows of `points` (n x d). The search starts at the nearest vertex
 * (FindNearestRows) and takes the nearest point in its triangles. Then it walks to triangles that
 * share a corner while the distance decreases. In many dimensions this is a fast approximation of
 * the nearest point. The start is chosen among all vertices, because walks from a subset of them
 * could end on the wrong side of thin parts.
 *
 * triangles: m x 3; a vertex without a triangle is never a result. Throws Aborted.
 */
SurfacePoints FindNearestSurfacePoints(const Eigen::MatrixXd& queries,
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
