#pragma once

#include "Correspondence/CommonBase/BaseDomain.h"
#include "Correspondence/CommonBase/Private/BaseEmbedding.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

/// A rotation of the plane by a multiple of 60 degrees and a translation, in the coordinates in
/// which (1, 0) and (0, 1) are two sides of an equilateral triangle. It maps lattice points to
/// lattice points. Of coordinates that are multiples of 2^-44 below 2^8, the images are exact.
struct LatticeMotion
{
  int Turns = 0; ///< by 60 degrees, in 0 to 5
  Eigen::RowVector2d Shift = Eigen::RowVector2d::Zero();

  Eigen::RowVector2d Rotate(Eigen::RowVector2d position) const;
  Eigen::RowVector2d operator()(const Eigen::RowVector2d& position) const
  {
    return this->Rotate(position) + this->Shift;
  }
  LatticeMotion Inverse() const;
};

/// Returns the motion that does first `inner`, then `outer`.
LatticeMotion Compose(const LatticeMotion& outer, const LatticeMotion& inner);

/// A position on a triangle of a ConeSurface, and the motion from the coordinates in which it was
/// given to those of the triangle.
struct ConePlace
{
  int Triangle = -1;
  LatticeMotion Motion;
};

/**
 * A surface divided into patches, on the flat surface with cones that equilateral triangles make,
 * one for each patch, glued along their sides. The landmarks are at the cones. Triangles are
 * straight: a triangle may lie on several patches, and is unfolded into the plane, since it has no
 * cone inside. If all triangles are counter-clockwise, the surface covers each point of the flat
 * surface once.
 *
 * Each point has coordinates of its own, and each triangle has coordinates of its own.
 */
class ConeSurface
{
public:
  ConeSurface(
    const BaseDomain& domain, const PatchedSurface& surface, const BaseEmbedding& embedding);

  int TriangleCount() const { return static_cast<int>(this->Corners.size()) / 3; }
  int PointCount() const { return static_cast<int>(this->Out.size()); }
  /// Returns the point at a corner; -1 if the triangle has been removed.
  int PointAt(int side) const { return this->Corners[side]; }
  bool IsCone(int point) const { return this->Cones[point]; }
  bool IsUsed(int point) const { return this->Out[point] >= 0; }
  /// Returns the corners at a point, as half-edges that leave it, counter-clockwise.
  std::vector<int> CornersAt(int point) const;
  /// Returns the position of a corner in the coordinates of its triangle.
  Eigen::RowVector2d PositionAt(int side) const
  {
    return this->Charts[side](this->Positions[this->Corners[side]]);
  }
  /// Returns the motion from the coordinates of the corner's point to those of its triangle.
  const LatticeMotion& ChartAt(int side) const { return this->Charts[side]; }
  const Eigen::RowVector2d& PositionOf(int point) const { return this->Positions[point]; }
  void MoveTo(int point, const Eigen::RowVector2d& position) { this->Positions[point] = position; }
  /// Whether the triangle is counter-clockwise, exactly.
  bool IsCounterClockwise(int triangle) const;
  Eigen::RowVector3d BarycentricOf(int triangle, const Eigen::RowVector2d& position) const;

  /// Walks along a straight line to a position. place: where the line starts, in given coordinates.
  /// Returns the triangle of its end; nothing if the line meets a cone.
  std::optional<ConePlace> Walk(
    const ConePlace& place, const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) const;
  /// The same, from a point that is no cone, in its own coordinates.
  std::optional<ConePlace> WalkFrom(int point, const Eigen::RowVector2d& to) const;

  /// Returns a position on a triangle as one on the given surface.
  SurfacePoint OnGiven(int triangle, const Eigen::RowVector3d& barycentric) const
  {
    return { this->Givens(triangle), barycentric * this->Barycentrics[triangle] };
  }

  /// Returns the given triangle that contains a triangle, and the barycentric coordinates of its
  /// corners there, one per row.
  std::pair<int, const Eigen::Matrix3d&> Given(int triangle) const
  {
    return { this->Givens(triangle), this->Barycentrics[triangle] };
  }

  /// Undoes the split of an edge, if both triangles are counter-clockwise then. ends: of the edge.
  bool Remove(int point, const std::array<int, 2>& ends);

private:
  LatticeMotion Across(int side) const { return this->Gluings[side]; }

  std::vector<int> Corners, Twins, Out;
  std::vector<bool> Cones;
  std::vector<Eigen::RowVector2d> Positions; ///< of each point, in its own coordinates
  /// For each corner, the motion from the coordinates of its point to those of its triangle. For a
  /// cone, only its image of the origin counts.
  std::vector<LatticeMotion> Charts;
  /// For each half-edge, the motion from the coordinates of its triangle to those of its twin's.
  std::vector<LatticeMotion> Gluings;
  Eigen::VectorXi Givens; ///< as in PatchedSurface
  std::vector<Eigen::Matrix3d> Barycentrics;
};

} // namespace shape
