#pragma once

#include <Eigen/Core>

namespace shape
{

/// Options of TriangulateInPlane: which triangles are kept, and whether points may be added.
struct PlanarDelaunayOptions
{
  enum class KeepType
  {
    All,   ///< the convex hull of the points
    Oddly, ///< the regions enclosed an odd number of times by closed outlines of any orientation
    Wound  ///< the regions with nonzero winding number
  };
  KeepType Keep = KeepType::All;
  int Outlines = -1; ///< the number of segments, first in the list, that are outlines; -1: all
  bool AddCrossings = false; ///< whether segments may cross; a point is added at each crossing
  /// Circles are tested in the plane after this linear map (p -> p Metric), with determinant >= 0.
  /// So a triangle can be given in coordinates where its corners are (0, 0), (1, 0) and (0, 1) and
  /// its edges are exact, and is still split well.
  Eigen::Matrix2d Metric = Eigen::Matrix2d::Identity();
};

/// A constrained Delaunay triangulation in the plane.
struct PlanarTriangulation
{
  Eigen::MatrixXd Points;    ///< the given points (n x 2), then those added at crossings
  Eigen::MatrixXi Triangles; ///< m x 3, counter-clockwise, none without area
  /// n: the first point at the same position, used in Triangles and Edges
  Eigen::VectorXi SamePoint;
  /// e x 2: the edges of the segments, segment by segment and in order along each
  Eigen::MatrixXi Edges;
  /// e: segment of each edge; an edge of several segments is listed once for each
  Eigen::VectorXi EdgeSegments;
};

/**
 * Triangulates points and segments between them. No edge crosses a segment, and the circumcircle of
 * a triangle contains no point that is visible from inside the triangle (Lee and Lin 1986). If four
 * points lie on one circle, the order of the points decides.
 *
 * Points are inserted one by one along a space-filling curve, and edges are flipped (Lawson 1977).
 * Then each segment becomes an edge by flips. All predicates are exact (EvaluateOrientation,
 * EvaluateInCircle), so collinear, cocircular and nearly coincident points are no special cases.
 * The time is O(n log n).
 *
 * points: n x 2, finite; the longest side of their box is 0, or between 1e-50 and 1e50. segments:
 * k x 2 indices. A segment whose ends coincide is ignored; one that runs through a point is split
 * there. If all points are collinear there are no triangles and no edges. Unless Keep is All, only
 * triangles inside the outlines are kept; every segment is an edge, even one that bounds no
 * triangle.
 *
 * Throws InvalidInput if the input is not as above, if segments cross and AddCrossings is off, or
 * if the outlines are not closed and Keep is not All. Throws SolveFailure if rounded crossings
 * cause new crossings without end.
 */
PlanarTriangulation TriangulateInPlane(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& segments = Eigen::MatrixXi(0, 2),
  const PlanarDelaunayOptions& options = {});

} // namespace shape
