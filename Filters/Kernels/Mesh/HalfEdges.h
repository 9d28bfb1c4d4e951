#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace shape
{

/// One triangle's side, from the point Begin at its corner Corner to End at the next one.
struct HalfEdge
{
  int Begin;
  int End;
  int Triangle;
  int Corner;
  int Low() const { return std::min(this->Begin, this->End); }
  int High() const { return std::max(this->Begin, this->End); }
};

/// The sides of all triangles (m x 3, indices less than `points`): those of one edge side by side,
/// in the order of Low, High, Triangle.
std::vector<HalfEdge> SortHalfEdges(const Eigen::MatrixXi& triangles, Eigen::Index points);

/// Of side 3 t + k, which runs from corner k of triangle t to the next one, the side of the
/// triangle beside it, or -1 on the border. triangles: an oriented 2-manifold's.
std::vector<int> FindTwins(const Eigen::MatrixXi& triangles, Eigen::Index points);

/// The same of SortHalfEdges.
std::vector<int> FindTwins(const std::vector<HalfEdge>& sorted);

///@{
/// The sides of the same triangle after and before a side.
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
