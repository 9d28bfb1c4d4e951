#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace shape
{

/// A triangulated surface whose edges are collapsed, split and flipped: the corners of each
/// triangle and the triangles around each point. What is removed keeps its number until Compact.
class EditableSurface
{
public:
  using Triangle = std::array<int, 3>; ///< points; the first is -1 if the triangle is removed

  explicit EditableSurface(const Mesh& mesh);

  int PointCount() const { return static_cast<int>(this->Points.size()); }       ///< with removed
  int TriangleCount() const { return static_cast<int>(this->Triangles.size()); } ///< with removed
  const Triangle& Corners(int triangle) const { return this->Triangles[triangle]; }

  /// The triangles around a point; none if it is removed.
  const std::vector<int>& Around(int point) const { return this->Fans[point]; }
  bool Contains(int point) const { return !this->Fans[point].empty(); }

  const Eigen::Vector3d& Position(int point) const { return this->Points[point]; }
  void Move(int point, const Eigen::Vector3d& position) { this->Points[point] = position; }

  /// The squared distance of two points.
  double SquaredLength(int a, int b) const
  {
    return (this->Points[a] - this->Points[b]).squaredNorm();
  }
  double Length(int a, int b) const { return (this->Points[a] - this->Points[b]).norm(); }

  /// Normal to three points, of twice the area of their triangle.
  Eigen::Vector3d AreaVector(const Triangle& corners) const
  {
    const Eigen::Vector3d& p = this->Points[corners[0]];
    return (this->Points[corners[1]] - p).cross(this->Points[corners[2]] - p);
  }

  static bool Has(const Triangle& corners, int point)
  {
    return corners[0] == point || corners[1] == point || corners[2] == point;
  }

  /// Which corner a point of the triangle is.
  static int CornerOf(const Triangle& corners, int point)
  {
    return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
  }

  /// The corner opposite an edge of a triangle.
  int Opposite(int triangle, int a, int b) const
  {
    const Triangle& corners = this->Triangles[triangle];
    return corners[0] + corners[1] + corners[2] - a - b;
  }

  /// The neighbours of a point, ascending; on the boundary there is one more than triangles.
  void FindNeighbours(int point, std::vector<int>& found) const;

  /// The triangles beside an edge.
  std::vector<int> TrianglesOf(int a, int b) const;

  /// Merges a point into a neighbour (half-edge collapse). Returns the triangles of `point` that
  /// stay, which are then around `into`. The caller has checked the link condition.
  std::vector<int> Collapse(int point, int into);

  /// Splits an edge at its midpoint, which is returned, and the triangles beside it.
  int Split(int a, int b);

  /// Replaces edge a-b of the triangles t = (a, b, c) and s = (b, a, d) by edge c-d.
  void Flip(int t, int s, int a, int b);

  struct Compacted
  {
    Mesh Surface;
    std::vector<int> Points; ///< of each point of it: the number here, ascending
    std::vector<int> Rows;   ///< of each triangle here: its number there; -1 if it is removed
  };
  /// What is left, in the same order.
  Compacted Compact() const;

private:
  void Remove(int point, int triangle);

  std::vector<Eigen::Vector3d> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::vector<int>> Fans;
};

} // namespace shape
