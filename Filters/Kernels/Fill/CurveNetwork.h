#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// What curves alone bound.
struct CurveNetwork
{
  /// The points of each patch's boundary loop in order, with the patch to the left seen from the
  /// tips of the normals. Of coincident points, the first one. Patches that share a curve run
  /// through it in opposite directions.
  std::vector<std::vector<int>> Loops;
  Eigen::MatrixXd Normals; ///< n x 3: unit, of the patches at the points; 0 at others
  int LooseSegments = 0;   ///< with an open end, or connected to such segments only: left out
  int SkippedFaces = 0;    ///< that pass a point twice, as around an island: left out
};

/**
 * The boundary loops of the patches between curves: closed ones, or a network of arcs.
 *
 * If no more than two segments meet anywhere, each closed curve is a loop. It runs
 * counter-clockwise around the given normals; if these lie in its plane, or there are none, it runs
 * in the order of its points. Without normals, the normal is that of the curve's own plane (its
 * area vector).
 *
 * If three or more meet, the normals there put the segments around a point in order, and this
 * defines the faces, as on the surface that the patches will be. Those that run counter-clockwise
 * around their normals are loops; the others, such as the outer one of a flat network, are not. A
 * network without normals must be near a plane, whose normal is then that of all points.
 *
 * points: n x 3. polylines: points in order. normals: n x 3 of any length, 0 if unknown, or 0 x 3
 * for none. Throws InvalidInput if a point is out of range or not finite, or if a network with
 * neither normals nor a plane has points where three segments meet, with their number.
 */
CurveNetwork FindCurveLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals);

} // namespace shape
