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
  bool Reached = false;        ///< no triangle is flipped, and the sphere is covered once
};

/**
 * Ends the flips of a map of a triangulated sphere to the unit sphere locally.
 *
 * Points of flipped triangles are merged into a neighbour that sees their whole ring (half-edge
 * collapses), and if none does, points around them, until no flipped triangle is left; then they
 * come back in the opposite order, each into the kernel of its ring, which is not empty: the
 * progressive parameterisation of Praun & Hoppe 2003, confined to where it is needed. After each
 * insertion the new point and the new ones next to it are relaxed towards equal angles.
 *
 * triangles: m x 3, closed, oriented, Euler number 2, one component, every point used.
 * points: n x 3, of unit length. Reached is false, and Points are those given, if the map does
 * not cover the sphere once or more than `maximum` points would have to be merged.
 */
SphericalReinsertionResult ReinsertFlipped(const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, int maximum, const Progress& progress = {});

/**
 * The same for the whole sphere, from no map at all: points are merged down to a regular
 * tetrahedron, whatever their positions, and come back level by level. It ends for every
 * triangulated sphere unless rounding leaves no room for a point: SolveFailure. n >= 4 points.
 *
 * areaWeight (>= 0) pulls towards equal areas against equal angles: triangles next to each other
 * get areas in proportion to the points they still have to take, level by level. 0 lets long
 * extremities shrink exponentially; 3 keeps the smallest triangle of a figure with limbs near 1e-4
 * of the mean.
 */
SphericalReinsertionResult ReinsertAll(
  const Eigen::MatrixXi& triangles, int n, double areaWeight, const Progress& progress = {});

} // namespace shape
