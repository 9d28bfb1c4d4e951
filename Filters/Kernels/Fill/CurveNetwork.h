#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The boundary loops of the patches between curves.
struct CurveNetwork
{
  /// For each patch, the points of its boundary loop in order. The patch is to the left, seen from
  /// the tips of the normals. Of coincident points, the first one is used. The loops of two patches
  /// run through a common curve in opposite directions.
  std::vector<std::vector<int>> Loops;
  Eigen::MatrixXd Normals; ///< n x 3: unit normals of the patches at the points; 0 at other points
  /// Number of ignored segments: segments with an open end are removed repeatedly until none is
  /// left.
  int LooseSegments = 0;
  /// Number of ignored faces: faces that pass through a point twice, such as a face around an
  /// island.
  int SkippedFaces = 0;
};

/**
 * Finds the boundary loops of the patches between curves. The curves are closed, or they form a
 * network of arcs.
 *
 * If no more than two segments meet at any point, each closed curve is a loop. The loop runs
 * counter-clockwise around the given normals. If the normals lie in the curve's plane or are not
 * given, the loop runs in the order of its points. Normals that are not given are those of the
 * curve's plane (its area vector).
 *
 * If three or more segments meet at a point, the normal there orders the segments around it. This
 * defines the faces, as on the surface that the patches will form. Faces that run counter-clockwise
 * around their normals are loops; others, such as the outer face of a flat network, are not. A
 * network without normals must be nearly planar; the normal of its plane is then used at all
 * points.
 *
 * points: n x 3. polylines: for each polyline, the indices of its points in order. normals: n x 3
 * vectors of any length, 0 where unknown; no rows if there are no normals. Throws InvalidInput if
 * an index is out of range or a point is not finite. Also throws InvalidInput if three segments
 * meet at a point of a network that has no normals and is not planar.
 */
CurveNetwork FindCurveLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals);

} // namespace shape
