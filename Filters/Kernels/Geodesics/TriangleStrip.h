#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A path on a surface that is straight in each triangle.
struct SurfacePath
{
  /// its two ends, and where it passes points and crosses edges, in order
  std::vector<SurfacePoint> Positions;
  /// for each segment between consecutive positions, a triangle that contains it
  std::vector<int> Triangles;
  double Length = 0.0;
};

/// The one, two or three mesh points with nonzero weight at a point on a surface.
struct PointSupport
{
  PointSupport(const Mesh& surface, const SurfacePoint& position);

  /// Whether all these mesh points are corners of the triangle.
  bool IsIn(const Eigen::RowVector3i& triangle) const;
  /// Whether each of these mesh points is `a` or `b`.
  bool IsOn(int a, int b) const;
  /// Returns the same point on the surface, given in a triangle for which IsIn is true.
  SurfacePoint In(const Mesh& surface, int triangle) const;

  int Count = 0;
  std::array<int, 3> Points = { -1, -1, -1 };
  std::array<double, 3> Weights = { 0.0, 0.0, 0.0 };
};

/// A strip of triangles between two points on a surface, and the shortest path within it, computed
/// in the plane (Lee and Preparata, "Euclidean shortest paths in the presence of rectilinear
/// barriers", 1984).
class TriangleStrip
{
public:
  /// twins: for each half-edge, the opposite one, or -1 on the boundary. first: the first triangle,
  /// which contains `from`. sides: the half-edges that the strip crosses, in order. Each half-edge
  /// belongs to the triangle before the crossing.
  TriangleStrip(const Mesh& surface, const std::vector<int>& twins, const SurfacePoint& from,
    const SurfacePoint& to, int first, std::vector<int> sides);

  /// Finds the shortest path within the strip.
  void FindPath();
  /// Leads the strip around the other side of each turn where this shortens the path. Returns
  /// whether there was such a turn; if so, call FindPath again.
  bool LeadAround();

  double Length() const { return this->PathLength; }
  /// Returns the path that the last FindPath found. LeadAround must not have changed the strip
  /// since.
  SurfacePath Path() const;

private:
  /// A crossed half-edge in the plane: its left and right ends, seen along the path.
  struct Portal
  {
    Eigen::RowVector2d Left, Right;
  };
  /// A point where the path turns. First and Last are the indices in Sides of the first and the
  /// last half-edge that touches the point.
  struct Turn
  {
    int First, Last;
    bool IsLeft;
    int Point;
    Eigen::RowVector2d Position;
  };

  int TriangleAt(int step) const;
  int Begin(int side) const;
  int End(int side) const;
  int Apex(int side) const;
  bool Touches(int side, int point) const;
  void Trim();
  void LayOut();
  Eigen::RowVector2d ApexPosition(
    int side, const Eigen::RowVector2d& begin, const Eigen::RowVector2d& end) const;
  Eigen::RowVector2d PositionOf(const PointSupport& support, int side,
    const Eigen::RowVector2d& begin, const Eigen::RowVector2d& end,
    const Eigen::RowVector2d& apex) const;
  void FindTurns();
  double AngleInStrip(std::size_t turn) const;
  double AngleAround(int side, int point) const;
  bool Detour(const Turn& turn, std::vector<int>& sides) const;
  SurfacePoint Crossing(
    int step, const Eigen::RowVector2d& before, const Eigen::RowVector2d& after) const;
  int TriangleOfBoth(const PointSupport& a, const PointSupport& b, int first, int last) const;

  const Mesh& Triangulation;
  const std::vector<int>& Twins;
  PointSupport From, To;
  int First;
  std::vector<int> Sides;
  std::vector<Portal> Portals;
  Eigen::RowVector2d FromPosition, ToPosition;
  std::vector<Turn> Turns;
  double PathLength = 0.0;
};

} // namespace shape
