#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The sides of the triangles of a surface as frames in the plane: side 3 t + k runs from corner k
/// of triangle t to the next one along the x axis, from the origin on, and its triangle is above.
class HalfEdgeFrames
{
public:
  /// mesh: a consistently oriented 2-manifold, open or closed.
  explicit HalfEdgeFrames(const Mesh& mesh);

  int Begin(int side) const { return this->Begins[side]; } ///< the point
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  int Twin(int side) const { return this->Twins[side]; } ///< of the triangle beside; -1: none
  double Length(int side) const { return this->Lengths[side]; }
  /// The corner opposite, in the frame.
  const Eigen::Vector2d& Opposite(int side) const { return this->Opposites[side]; }

  double Angle(int point) const { return this->Angles[point]; } ///< of all its corners
  bool IsOnBoundary(int point) const { return this->OnBoundary[point] != 0; }
  const std::vector<int>& HalfEdgesFrom(int point) const { return this->From[point]; }

private:
  std::vector<int> Begins, Twins;
  std::vector<double> Lengths;
  std::vector<Eigen::Vector2d> Opposites;
  std::vector<double> Angles;
  std::vector<char> OnBoundary;
  std::vector<std::vector<int>> From;
};

} // namespace shape
