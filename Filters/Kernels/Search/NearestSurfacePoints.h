#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/// For each row of `queries` (q x d) the row of `rows` (n x d, at least one) nearest to it, by
/// products of matrices in single precision: in a hundred dimensions quicker than any tree, and
/// exact but for that rounding; the first of those equally near. Throws Aborted.
Eigen::VectorXi FindNearestRows(
  const Eigen::MatrixXd& queries, const Eigen::MatrixXd& rows, const Progress& progress = {});

/**
 * For each row of `queries` (q x d) a place of the surface whose points are the rows of `points` (n
 * x d) that is near to it in all d dimensions: around the point nearest of all (FindNearestRows),
 * the nearest place in the triangles there, and on from triangle to triangle that share a corner
 * while they lead nearer. In many dimensions a quick stand-in for the nearest place of all. From
 * the nearest of fewer points walks end elsewhere on thin limbs, and maps go wrong there.
 *
 * triangles: m x 3; points without one are no targets. Throws Aborted.
 */
SurfacePoints FindNearestSurfacePoints(const Eigen::MatrixXd& queries,
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
