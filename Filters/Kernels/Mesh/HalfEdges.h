#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace shape
{

/// An edge of one triangle. It runs from the point Begin, at the triangle's corner Corner, to the
/// point End at the next corner.
struct HalfEdge
{
  int Begin;
  int End;
  int Triangle;
  int Corner;
  int Low() const { return std::min(this->Begin, this->End); }
  int High() const { return std::max(this->Begin, this->End); }
};

/// Returns the half-edges of all triangles (m x 3, indices less than `points`), sorted by Low, High
/// and Triangle. The half-edges of an edge are therefore adjacent.
std::vector<HalfEdge> SortHalfEdges(const Eigen::MatrixXi& triangles, Eigen::Index points);

/// Returns the twin of each half-edge, or -1 on the boundary. Half-edge 3 t + k runs from corner k
/// of triangle t to the next corner. triangles: an oriented 2-manifold.
std::vector<int> FindTwins(const Eigen::MatrixXi& triangles, Eigen::Index points);

/// The same, for half-edges sorted by SortHalfEdges.
std::vector<int> FindTwins(const std::vector<HalfEdge>& sorted);

///@{
/// Return the next and the previous half-edge of the same triangle.
inline int NextHalfEdge(int side)
{
  return side - side % 3 + (side + 1) % 3;
}
inline int PreviousHalfEdge(int side)
{
  return side - side % 3 + (side + 2) % 3;
}
///@}

} // namespace shape
