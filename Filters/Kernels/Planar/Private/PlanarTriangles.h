#pragma once

#include "Mesh/HalfEdges.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A triangulation of points in the plane that grows point by point. Its triangles fill the convex
 * hull of the points. Outside each hull edge there is one more triangle, whose third corner, Far,
 * is at infinity. So every half-edge has a twin. Half-edge 3 t + k runs from corner k of triangle t
 * to the next one, with the triangle on its left.
 *
 * Marked edges are fixed. The others are kept locally Delaunay by flips (Lawson 1977), with exact
 * predicates.
 */
class PlanarTriangles
{
public:
  static constexpr int Far = -1;

  /// Group: the group of segments that contain an edge, or -1. Winding: the number of outline
  /// segments in the half-edge's direction, minus the number of those in the opposite direction.
  struct SegmentMark
  {
    int Group = -1;
    int Winding = 0;
  };

  /// points: n x 2. metric: PlanarDelaunayOptions::Metric. There is no triangle before Start.
  PlanarTriangles(const Eigen::MatrixXd& points, const Eigen::Matrix2d& metric);

  /// Creates the first triangle from three points that are not collinear.
  void Start(int a, int b, int c);
  /// Inserts a point as a corner. Returns the point, or the corner that is already at its position.
  int Insert(int point);
  /// Appends a position and returns its number, for Insert.
  int AddPosition(const Eigen::RowVector2d& position);
  void RemoveLastPosition();

  int Points() const { return static_cast<int>(this->Positions.size()); }
  int Sides() const { return static_cast<int>(this->Begins.size()); }
  const Eigen::RowVector2d& Position(int point) const { return this->Positions[point]; }
  int Begin(int side) const { return this->Begins[side]; }
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  /// Returns the corner opposite the half-edge.
  int Apex(int side) const { return this->Begins[PreviousHalfEdge(side)]; }
  int Twin(int side) const { return this->Twins[side]; }
  /// Returns a half-edge that begins at a point.
  int From(int point) const { return this->FirstEdges[point]; }
  bool IsFar(int triangle) const;
  /// Returns 1 if three points are counter-clockwise, 0 if they are collinear, else -1.
  int Turn(int a, int b, int c) const;

  const SegmentMark& Mark(int side) const { return this->Marks[side]; }
  /// Marks both half-edges of an edge.
  void SetMark(int side, const SegmentMark& mark);

  /// Replaces an edge by the other diagonal of its two triangles, which must form a convex
  /// quadrilateral. Let `side` run from x to y, with the apex c, and let d be the apex of its twin.
  /// Afterwards `side` runs from d to c, its next half-edge from c to x, and the next one of its
  /// twin from d to y. The triangles keep their numbers.
  void Flip(int side);
  /// Flips edges until each of the given half-edges, and each half-edge affected by a flip, is
  /// locally Delaunay.
  void MakeDelaunay(std::vector<int> sides);

private:
  /// Location of a position: at a corner, on a half-edge, or in the triangle of a half-edge.
  struct Location
  {
    int Side;
    bool IsOnEdge = false;
    int Corner = Far;
  };

  Location Locate(const Eigen::RowVector2d& position) const;
  bool Contains(int triangle, const Eigen::RowVector2d& position) const;
  Location LocateIn(int triangle, const Eigen::RowVector2d& position) const;
  bool SplitsBetter(int side) const;
  void SplitTriangle(int triangle, int point);
  void SplitEdge(int side, int point);
  void FlipAround();
  int NewTriangle();
  void SetBegin(int side, int point);
  void Link(int side, int twin);
  void Move(int from, int to);

  Eigen::Matrix2d Metric;
  bool HasMetric; ///< whether Metric is not the identity
  std::vector<Eigen::RowVector2d> Positions;
  std::vector<Eigen::RowVector2d> Images; ///< positions after Metric, where circles are tested
  std::vector<int> Begins, Twins;         ///< for each half-edge
  std::vector<SegmentMark> Marks;         ///< for each half-edge
  std::vector<int> FirstEdges;            ///< for each point
  std::vector<int> Suspects; ///< half-edges opposite the new point that may need a flip
  int Last = 0;              ///< a half-edge near the last insertion, in a finite triangle
};

} // namespace shape
