#pragma once

#include "Correspondence/CommonBase/BaseGenus.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace shape
{

/// The value of 2 g closed 1-forms on an edge.
using FormValues = std::array<signed char, 2 * MaximumBaseGenus>;

/// Returns the sum of two values; with a sign of -1, their difference.
FormValues AddForms(const FormValues& forms, const FormValues& others, int sign = 1);

/// A closed surface whose edges can be split, with paths marked along its edges. Half-edge 3 t + k
/// runs from corner k of triangle t to the next corner. The given points come first.
class PathSurface
{
public:
  /// given: an oriented closed 2-manifold.
  explicit PathSurface(const Surface& given);

  int Begin(int side) const { return this->Corners[side]; }
  int End(int side) const { return this->Corners[NextHalfEdge(side)]; }
  int Apex(int side) const { return this->Corners[PreviousHalfEdge(side)]; }
  int Twin(int side) const { return this->Twins[side]; }
  int PathOf(int side) const { return this->Paths[side]; } ///< or -1
  /// Whether the point lies on a path.
  bool IsOnPath(int point) const { return this->OnPath[point]; }
  /// Returns a half-edge that begins at the point.
  int Leaving(int point) const { return this->Out[point]; }
  /// Returns the next half-edge, counter-clockwise, that begins at the same point.
  int TurnLeft(int side) const { return this->Twins[PreviousHalfEdge(side)]; }
  /// Returns the next half-edge, clockwise, that begins at the same point.
  int TurnRight(int side) const { return NextHalfEdge(this->Twins[side]); }
  /// Returns the half-edge from one point to another, or -1.
  int Find(int from, int to) const;
  int SideCount() const { return static_cast<int>(this->Corners.size()); }
  int PointCount() const { return static_cast<int>(this->Positions.size()); }
  const Eigen::RowVector3d& PositionOf(int point) const { return this->Positions[point]; }
  Eigen::RowVector3d Midpoint(int side) const
  {
    return 0.5 * (this->Positions[this->Begin(side)] + this->Positions[this->End(side)]);
  }
  double Length(int side) const
  {
    return (this->Positions[this->End(side)] - this->Positions[this->Begin(side)]).norm();
  }

  /// Splits an edge that is not on a path, and both its triangles. Returns the new point, at the
  /// share of the way along the half-edge.
  int Split(int side, double share);
  /// Splits each edge off the paths that joins two points of paths. No edge then cuts off a part of
  /// a patch that touches one path only, which a convex combination map would collapse (Floater
  /// 2003, "One-to-one piecewise linear mappings over triangulations", theorem 4.1).
  void SplitChords();
  /// Marks an edge as part of a path.
  void Mark(int side, int path);

  ///@{
  /// Closed 1-forms on the edges, which Split extends. A path along edges that is closed is the sum
  /// of as many copies of the i-th basis loop as the i-th form's integral over it.
  const FormValues& FormsOf(int side) const { return this->Forms[side]; }
  void SetForm(int side, int form, signed char value);
  ///@}

  /// Returns for each point that Split has made the ends of the edge, in order.
  const std::vector<std::array<int, 2>>& SplitEdges() const { return this->Ends; }
  /// Returns the surface as it is now.
  Mesh ToMesh() const;
  /// Returns the given triangle that contains a triangle, and the barycentric coordinates of its
  /// corners there, one per row.
  std::pair<int, Eigen::Matrix3d> Given(int triangle) const
  {
    return { this->Givens[triangle], this->Barycentrics[triangle] };
  }

private:
  void Link(int side, int twin);

  std::vector<Eigen::RowVector3d> Positions;
  std::vector<int> Corners, Twins, Paths;
  std::vector<int> Out;
  std::vector<bool> OnPath;
  std::vector<std::array<int, 2>> Ends;
  std::vector<FormValues> Forms;
  std::vector<int> Givens;
  std::vector<Eigen::Matrix3d> Barycentrics;
};

} // namespace shape
