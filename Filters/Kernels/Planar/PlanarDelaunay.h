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
  /// the first Outlines segments are the outlines; -1: all segments are
  int Outlines = -1;
  bool AddCrossings = false; ///< whether segments may cross; a point is added at each crossing
  /// The linear map p -> p Metric is applied to the points before circumcircles are tested; its
  /// determinant is >= 0. With it, a triangle in space can be given in barycentric coordinates,
  /// with corners (0, 0), (1, 0) and (0, 1). Positions on its edges are then exact, but it is still
  /// split into triangles that are well-shaped in space.
  Eigen::Matrix2d Metric = Eigen::Matrix2d::Identity();
};

/// A constrained Delaunay triangulation in the plane.
struct PlanarTriangulation
{
  Eigen::MatrixXd Points;    ///< the given points (n x 2), then the points added at crossings
  Eigen::MatrixXi Triangles; ///< m x 3, counter-clockwise, none without area
  /// n: for each point, the first point at the same position; Triangles and Edges use only these
  Eigen::VectorXi SamePoint;
  /// e x 2: the edges that the segments consist of, segment by segment, in order along each segment
  Eigen::MatrixXi Edges;
  /// e: the segment of each edge; an edge of several segments is listed once for each
  Eigen::VectorXi EdgeSegments;
};

/**
 * Computes the constrained Delaunay triangulation of points and segments between them. No edge
 * crosses a segment, and the circumcircle of a triangle contains no point that is visible from
 * inside the triangle (Lee and Lin 1986). If four points lie on one circle, the result depends on
 * the order of the points.
 *
 * Points are inserted one by one along a space-filling curve, and edges are flipped (Lawson 1977).
 * Then edges are flipped until each segment is an edge. All predicates are exact
 * (EvaluateOrientation, EvaluateInCircle), so collinear, cocircular and nearly coincident points
 * need no special treatment. The time is O(n log n).
 *
 * points: n x 2, finite; the longest side of their bounding box is 0, or between 1e-50 and 1e50.
 * segments: k x 2 indices of points. A segment whose ends coincide is ignored. A segment that runs
 * through a point is split there. If all points are collinear, there are no triangles and no edges.
 * Unless Keep is All, only triangles inside the outlines are kept. Edges lists every segment, even
 * one that bounds no triangle.
 *
 * Throws InvalidInput if the points or segments are not as described above, if segments cross and
 * AddCrossings is off, or if the outlines are not closed and Keep is not All. Throws SolveFailure
 * if rounded crossings cause new crossings without end.
 */
PlanarTriangulation TriangulateInPlane(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& segments = Eigen::MatrixXi(0, 2),
  const PlanarDelaunayOptions& options = {});

} // namespace shape
