#pragma once

#include "Mesh/HalfEdges.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A triangulation of places in the plane that grows point by point: the triangles of their convex
 * hull and, beside each edge of it, one whose third corner, Far, is infinitely far away. So every
 * side has a twin. Side 3 t + k runs from corner k of triangle t to the next one, the triangle on
 * its left.
 *
 * Edges that are marked stay; the others are kept locally Delaunay by flips (Lawson 1977), with
 * exact tests.
 */
class PlanarTriangles
{
public:
  static constexpr int Far = -1;

  /// The number of the group of segments that an edge is a part of, or -1; and how many run along
  /// the side's direction less those that run against it.
  struct SegmentMark
  {
    int Group = -1;
    int Winding = 0;
  };

  /// points: n x 2; metric: circles are tested after this map. No triangle yet.
  PlanarTriangles(const Eigen::MatrixXd& points, const Eigen::Matrix2d& metric);

  /// The first triangle, of three points that do not lie on one line.
  void Start(int a, int b, int c);
  /// Makes a point a corner; returns it, or the corner that is there already.
  int Insert(int point);
  /// A new place's number, for Insert; and the last one away again.
  int AddPosition(const Eigen::RowVector2d& position);
  void RemoveLastPosition();

  int Points() const { return static_cast<int>(this->Positions.size()); }
  int Sides() const { return static_cast<int>(this->Begins.size()); }
  const Eigen::RowVector2d& Position(int point) const { return this->Positions[point]; }
  int Begin(int side) const { return this->Begins[side]; }
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  /// The corner that the side does not touch.
  int Apex(int side) const { return this->Begins[PreviousHalfEdge(side)]; }
  int Twin(int side) const { return this->Twins[side]; }
  /// A side that begins at a corner.
  int From(int point) const { return this->FirstEdges[point]; }
  bool IsFar(int triangle) const;
  /// 1 where three points run counter-clockwise, 0 where they lie on one line.
  int Turn(int a, int b, int c) const;

  const SegmentMark& Mark(int side) const { return this->Marks[side]; }
  /// Marks both of an edge's sides.
  void SetMark(int side, const SegmentMark& mark);

  /// Turns an edge to the other diagonal of its two triangles, which must be convex together:
  /// from x -> y to c -> d, where c was the apex. Then the side runs from d to c, its next one from
  /// c to x; the twin's next one from d to y. The triangles keep their numbers.
  void Flip(int side);
  /// Flips until each of these sides, and each that this changes, is locally Delaunay.
  void MakeDelaunay(std::vector<int> sides);

private:
  /// Where a place is: at a corner, or else on a side, or in the triangle of a side.
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
  bool HasMetric; ///< other than the plane's own
  std::vector<Eigen::RowVector2d> Positions;
  std::vector<Eigen::RowVector2d> Images; ///< of the places, where circles are tested
  std::vector<int> Begins, Twins;         ///< of each side
  std::vector<SegmentMark> Marks;         ///< of each side
  std::vector<int> FirstEdges;            ///< of each point
  std::vector<int> Suspects;              ///< sides opposite the new point that may need a flip
  int Last = 0;                           ///< a side near the last insertion, its triangle not far
};

} // namespace shape
