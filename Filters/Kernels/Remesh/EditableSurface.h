#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace shape
{

/// A triangulated surface whose edges can be collapsed, split and flipped. It stores the corners of
/// each triangle and the triangles around each point. Removed items keep their indices until
/// Compact.
class EditableSurface
{
public:
  using Triangle = std::array<int, 3>; ///< its points; the first is -1 if the triangle is removed

  explicit EditableSurface(const Mesh& mesh);

  ///@{
  /// The number of points or triangles, including removed ones.
  int PointCount() const { return static_cast<int>(this->Points.size()); }
  int TriangleCount() const { return static_cast<int>(this->Triangles.size()); }
  ///@}
  const Triangle& Corners(int triangle) const { return this->Triangles[triangle]; }

  /// The triangles around a point; empty if the point is removed.
  const std::vector<int>& Around(int point) const { return this->Fans[point]; }
  bool Contains(int point) const { return !this->Fans[point].empty(); }

  const Eigen::Vector3d& Position(int point) const { return this->Points[point]; }
  void Move(int point, const Eigen::Vector3d& position) { this->Points[point] = position; }

  /// Returns the squared distance between two points.
  double SquaredLength(int a, int b) const
  {
    return (this->Points[a] - this->Points[b]).squaredNorm();
  }
  double Length(int a, int b) const { return (this->Points[a] - this->Points[b]).norm(); }

  /// Returns the normal vector of a triangle, with twice the triangle's area as its length.
  Eigen::Vector3d AreaVector(const Triangle& corners) const
  {
    const Eigen::Vector3d& p = this->Points[corners[0]];
    return (this->Points[corners[1]] - p).cross(this->Points[corners[2]] - p);
  }

  static bool Has(const Triangle& corners, int point)
  {
    return corners[0] == point || corners[1] == point || corners[2] == point;
  }

  /// Returns the index (0 to 2) of a point among the corners of a triangle.
  static int CornerOf(const Triangle& corners, int point)
  {
    return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
  }

  /// Returns the corner opposite an edge of a triangle.
  int Opposite(int triangle, int a, int b) const
  {
    const Triangle& corners = this->Triangles[triangle];
    return corners[0] + corners[1] + corners[2] - a - b;
  }

  /// Finds the neighbours of a point, in ascending order. A boundary point has one more neighbour
  /// than triangles.
  void FindNeighbours(int point, std::vector<int>& found) const;

  /// Returns the triangles that share an edge.
  std::vector<int> TrianglesOf(int a, int b) const;

  /// Merges `point` into its neighbour `into` (half-edge collapse). Returns the triangles of
  /// `point` that remain, which then belong to `into`. The caller must have checked the link
  /// condition.
  std::vector<int> Collapse(int point, int into);

  /// Splits an edge at its midpoint, together with the triangles that share it. Returns the new
  /// point.
  int Split(int a, int b);

  /// Replaces edge a-b of the triangles t = (a, b, c) and s = (b, a, d) by edge c-d.
  void Flip(int t, int s, int a, int b);

  struct Compacted
  {
    Mesh Surface;
    std::vector<int> Points; ///< for each point of Surface: its index before Compact, ascending
    std::vector<int> Rows;   ///< for each triangle before Compact: its index in Surface, or -1
  };
  /// Returns the remaining points and triangles, in the same order as before.
  Compacted Compact() const;

private:
  void Remove(int point, int triangle);

  std::vector<Eigen::Vector3d> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::vector<int>> Fans;
};

} // namespace shape
