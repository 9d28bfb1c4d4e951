#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A triangle of a star, seen from its central point A: the points B, C that follow
/// counter-clockwise and the cotangents that its angles should have.
struct StarTriangle
{
  int B;
  int C;
  double CotangentA;
  double CotangentB;
  double CotangentC;
  double AreaTerm = 0.0; ///< added to the numerator of its energy: a triangle with more gets larger
};

/**
 * One guarded Newton step of point `point` of the unit sphere for the energy of its star
 *
 *   sum of (cotA |BC|^2 + cotB |CA|^2 + cotC |AB|^2 + AreaTerm) / det[A, B, C],
 *
 * minimal if each triangle has the wanted shape (MIPS, Hormann & Greiner 2000) and infinite if one
 * loses its area. It is convex in the tangent plane. The step is taken only where the energy
 * falls and every triangle still faces outwards, so it never flips one. Returns whether it moved.
 */
bool RelaxPoint(Eigen::MatrixXd& points, int point, const std::vector<StarTriangle>& star);

/**
 * RelaxPoint for each of `movable`, in that order, `sweeps` times, or until a sweep moves none.
 *
 * points: n x 3 on the unit sphere, all triangles of the stars of `movable` facing outwards.
 * cotangents: m x 3, of the corners of `triangles` (m x 3).
 */
void RelaxOnSphere(Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& cotangents, const std::vector<int>& movable, int sweeps,
  const Progress& progress = {});

} // namespace shape
