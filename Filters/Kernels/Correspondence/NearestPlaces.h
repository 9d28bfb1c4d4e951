#pragma once

#include "Core/PreciseMap.h"
#include "Core/Progress.h"

#include <Eigen/Core>

namespace shape
{

/**
 * For each row of `queries` (q x d) a place of the surface whose points are the rows of `points` (n
 * x d) that is near to it in all d dimensions: around the point nearest of all, or of 8000 of them
 * where there are more (NearestRows), the
 * nearest place in the triangles there, and on from triangle to triangle that share a corner while
 * they lead nearer. In many dimensions a quick stand-in for the nearest place of all, which is
 * hardly ever elsewhere.
 *
 * triangles: m x 3; points without one are no targets. Throws Aborted.
 */
PreciseMap NearestPlaces(const Eigen::MatrixXd& queries, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
