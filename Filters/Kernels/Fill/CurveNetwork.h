#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The boundary loops of the patches between curves.
struct CurveNetwork
{
  /// The points of each patch's boundary loop in order, with the patch to the left seen from the
  /// tips of the normals. Of coincident points, the first one is used. Patches that share a curve
  /// run through it in opposite directions.
  std::vector<std::vector<int>> Loops;
  Eigen::MatrixXd Normals; ///< n x 3: unit normals of the patches at the points; 0 at other points
  /// Number of ignored segments: those with an open end, or connected to such segments only.
  int LooseSegments = 0;
  /// Number of ignored faces: those that pass a point twice, such as one around an island.
  int SkippedFaces = 0;
};

/**
 * Finds the boundary loops of the patches between curves, which are closed curves or a network of
 * arcs.
 *
 * If no more than two segments meet at any point, each closed curve is a loop. It runs
 * counter-clockwise around the given normals. If these lie in its plane, or there are none, it runs
 * in the order of its points. Without normals, the normal is that of the curve's plane (its area
 * vector).
 *
 * If three or more segments meet at a point, the normal there orders the segments around it. This
 * defines the faces, as on the surface that the patches will form. Faces that run counter-clockwise
 * around their normals are loops; others, such as the outer face of a flat network, are not. A
 * network without normals must be near a plane, whose normal is then that of all points.
 *
 * points: n x 3. polylines: points in order. normals: n x 3 of any length, 0 if unknown, or 0 x 3
 * for none. Throws InvalidInput if a point is out of range or not finite. Also if a network with
 * neither normals nor a plane has points at which three segments meet; the message has their
 * number.
 */
CurveNetwork FindCurveLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals);

} // namespace shape
