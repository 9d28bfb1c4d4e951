#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A triangle of a star, which is the set of triangles around a central point A. B and C are its
/// other points, in counter-clockwise order. The cotangents belong to the target angles at A, B and
/// C.
struct StarTriangle
{
  int B;
  int C;
  double CotangentA;
  double CotangentB;
  double CotangentC;
  /// a term in the numerator of RelaxPoint's energy; a larger term gives a larger triangle
  double AreaTerm = 0.0;
};

/**
 * Moves a point of the unit sphere by one guarded Newton step for the energy of its star,
 *
 *   sum of (cotA |BC|^2 + cotB |CA|^2 + cotC |AB|^2 + AreaTerm) / det[A, B, C].
 *
 * The energy is minimal if each triangle has its target shape (MIPS, Hormann & Greiner 2000) and
 * infinite if a triangle loses its area. The energy is convex in the tangent plane. The step is
 * taken only if the energy decreases and every triangle still faces outwards, so no triangle flips.
 * Returns whether the point moved.
 */
bool RelaxPoint(Eigen::MatrixXd& points, int point, const std::vector<StarTriangle>& star);

/**
 * Applies RelaxPoint to each point of `movable`, in this order, in repeated sweeps. Stops after
 * `sweeps` sweeps, or when a sweep moves no point.
 *
 * points: n x 3, on the unit sphere. All triangles around the points of `movable` must face
 * outwards. cotangents: m x 3, the target cotangents at the corners of `triangles` (m x 3).
 */
void RelaxOnSphere(Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& cotangents, const std::vector<int>& movable, int sweeps,
  const Progress& progress = {});

} // namespace shape
