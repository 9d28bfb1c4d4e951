#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// What curves alone bound.
struct CurveNetwork
{
  /// Points of each patch's rim in order, the patch to the left seen from the tips of the normals;
  /// of points at the same place the first. Patches that share a curve run through it against each
  /// other.
  std::vector<std::vector<int>> Loops;
  Eigen::MatrixXd Normals; ///< n x 3: unit, of the patches at the points; 0 at others
  int LooseSegments = 0;   ///< that end in the open, or belong to ends that do: left out
  int SkippedFaces = 0;    ///< that come back to a place, as around an island: left out
};

/**
 * The rims of the patches between curves: closed ones, or a network of arcs.
 *
 * Where no more than two segments meet, each closed curve is a rim. It runs counter-clockwise
 * around the normals given; where these do not tell, being along its plane, or there are none, as
 * its points are in order. Without normals, they are that of the curve's own plane (its area
 * vector).
 *
 * Where three or more meet, the normals there put the segments around a point in order, and so
 * tell the faces, as on the surface that the patches will be. Those that run counter-clockwise
 * around their normals are rims; the others, such as the outer one of a flat network, are not. A
 * network without normals must be near a plane, whose normal is then that of all.
 *
 * points: n x 3. polylines: points in order. normals: n x 3 of any length, 0 where unknown, or 0 x
 * 3 for none. Throws InvalidInput where a point is out of range or not finite, and where a network
 * with neither normals nor a plane has points where three segments meet, with their number.
 */
CurveNetwork FindCurveLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals);

} // namespace shape
