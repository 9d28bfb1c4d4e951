#pragma once

#include <Eigen/Core>

namespace shape
{

/// What TriangulateInPlane keeps, and may add.
struct PlanarDelaunayOptions
{
  enum class KeepType
  {
    All,   ///< the points' convex hull
    Oddly, ///< what outlines, closed, in any sense, go around an odd number of times
    Wound  ///< what they wind around, clockwise or not, more often one way than the other
  };
  KeepType Keep = KeepType::All;
  int Outlines = -1;         ///< how many of the segments, the first ones, are outlines; -1: all
  bool AddCrossings = false; ///< whether segments may cross, at a point that is added there
  /// Circles are those of the plane after this map (p -> p Metric), with determinant >= 0: so that
  /// a triangle whose corners are at (0, 0), (1, 0) and (0, 1), and whose edges are met exactly, is
  /// split well.
  Eigen::Matrix2d Metric = Eigen::Matrix2d::Identity();
};

/// A constrained Delaunay triangulation in the plane.
struct PlanarTriangulation
{
  Eigen::MatrixXd Points;       ///< the given ones (n x 2), then those added where segments cross
  Eigen::MatrixXi Triangles;    ///< m x 3, counter-clockwise, none without area
  Eigen::VectorXi SamePoint;    ///< n: the first point at the same place, which stands for all
  Eigen::MatrixXi Edges;        ///< what the segments became: e x 2, segment by segment, along each
  Eigen::VectorXi EdgeSegments; ///< e: of which segment; an edge of several comes once for each
};

/**
 * Triangulates points and segments between them: no edge crosses a segment, and the circle through
 * a triangle's corners has no point inside that can be seen from within the triangle (Lee and Lin
 * 1986). Where four points lie on one circle, the order of the points decides.
 *
 * Points are inserted one by one along a space-filling curve and edges flipped (Lawson 1977); then
 * each segment becomes an edge by flips. All tests are exact (Orientation, EvaluateInCircle), so
 * points on one line, on one circle, or that all but coincide are no special cases. Takes n log n.
 *
 * points: n x 2, finite; their box's longest side is 0, or between 1e-50 and 1e50. segments: k x 2
 * indices; one that begins and ends at one place is left out; one that runs through a point is
 * split there. Where all points lie on one line there is no triangle, and no edge. With Keep other
 * than All only triangles inside are kept; every segment is an edge also where it bounds nothing.
 *
 * Throws InvalidInput where the input is not as above, where segments cross and AddCrossings is
 * off, and where with Keep other than All the segments are no closed outlines; SolveFailure where
 * rounded crossings have new crossings without end.
 */
PlanarTriangulation TriangulateInPlane(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& segments = Eigen::MatrixXi(0, 2),
  const PlanarDelaunayOptions& options = {});

} // namespace shape
