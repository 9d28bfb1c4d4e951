#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct SphericalReinsertionResult
{
  Eigen::MatrixXd Points;      ///< n x 3, on the unit sphere
  std::vector<int> Reinserted; ///< the points that were moved, ascending
  bool Reached = false;        ///< whether no triangle is flipped and the sphere is covered once
};

/**
 * Repairs the flipped triangles of a map from a triangulated sphere to the unit sphere, locally.
 *
 * Each point of a flipped triangle is merged into a neighbour from which its whole ring is visible
 * (a half-edge collapse). If there is no such neighbour, points around it are merged first. This
 * continues until no flipped triangle is left. Then the points are reinserted in the reverse order,
 * each into the kernel of its ring: the positions from which the whole ring is visible. The kernel
 * is not empty. This is the progressive parameterisation of Praun & Hoppe 2003, applied only where
 * it is needed. After each insertion the point and the reinserted points next to it are relaxed
 * towards equal angles.
 *
 * triangles: m x 3, closed, oriented, Euler number 2, one component, every point used. points:
 * n x 3, of unit length. If the repair fails, Reached is false and Points are the given points. It
 * fails if the map does not cover the sphere exactly once, if more than `maximum` points would have
 * to be merged, or if rounding leaves no room for a point.
 */
SphericalReinsertionResult ReinsertFlipped(const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, int maximum, const Progress& progress = {});

/**
 * Maps a triangulated sphere with n >= 4 points to the unit sphere by the same method, without an
 * initial map. Points are merged until four are left, which form a regular tetrahedron. Then they
 * are reinserted level by level. Throws SolveFailure if rounding leaves no room for a point;
 * Aborted.
 *
 * areaWeight (>= 0) is the weight of equal areas relative to equal angles. At each level,
 * neighbouring triangles get areas in proportion to the number of points that are still to be
 * inserted there. With areaWeight 0, long extremities shrink exponentially. With areaWeight 3, the
 * smallest triangle of a figure with arms and legs has about 1e-4 of the mean area.
 */
SphericalReinsertionResult ReinsertAll(
  const Eigen::MatrixXi& triangles, int n, double areaWeight, const Progress& progress = {});

} // namespace shape
