#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A path over a surface that is straight in each triangle.
struct SurfacePath
{
  std::vector<SurfacePoint> Positions; ///< its ends, and where it passes a point or crosses an edge
  std::vector<int> Triangles; ///< of each segment between two positions: one that it lies in
  double Length = 0.0;
};

/// The points of a surface that a point on it lies between, with their weights: one, two or three.
struct PointSupport
{
  PointSupport(const Mesh& surface, const SurfacePoint& position);

  /// Whether all of them are corners of a triangle.
  bool IsIn(const Eigen::RowVector3i& triangle) const;
  /// Whether all of them are one of two points.
  bool IsOn(int a, int b) const;
  /// The same point in a triangle that has all of them.
  SurfacePoint In(const Mesh& surface, int triangle) const;

  int Count = 0;
  std::array<int, 3> Points = { -1, -1, -1 };
  std::array<double, 3> Weights = { 0.0, 0.0, 0.0 };
};

/// A strip of triangles between two points on a surface, and the shortest path within it, laid out
/// in the plane (Lee and Preparata, "Euclidean shortest paths in the presence of rectilinear
/// barriers", 1984).
class TriangleStrip
{
public:
  /// twins: of the half-edges, -1 on the boundary. sides: the half-edges that the strip crosses, in
  /// order, of the triangles that it leaves; first: its first triangle, which `from` lies in.
  TriangleStrip(const Mesh& surface, const std::vector<int>& twins, const SurfacePoint& from,
    const SurfacePoint& to, int first, std::vector<int> sides);

  /// Finds the shortest path within the strip.
  void FindPath();
  /// Leads the strip past each point, at which the path turns, that it could be shortened around.
  /// Whether there were any; then FindPath finds a shorter path.
  bool LeadAround();

  double Length() const { return this->PathLength; }
  /// The path that was found last; the strip has not been changed since.
  SurfacePath Path() const;

private:
  /// A half-edge that is crossed, laid out in the plane: its end and its begin, seen on the way.
  struct Portal
  {
    Eigen::RowVector2d Left, Right;
  };
  /// A point that the path turns at: the first and the last half-edge of the strip that it is on.
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
