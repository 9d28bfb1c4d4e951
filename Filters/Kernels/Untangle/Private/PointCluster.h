#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/ConeExpansionOptions.h"
#include "Untangle/Private/SolidCells.h"
#include "Untangle/Private/StarKernel.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace shape
{

/// Thrown by a cluster when its work exceeds the limit.
struct WorkSpent
{
};

/**
 * A cluster: inner points of a solid that are, or will be, at one position c, and leave it one by
 * one or in parts. A part that has left is a cluster of its own, with another id. Points with id 0
 * are by themselves. Tetrahedra with several points in a cluster have no volume.
 *
 * All cells around the points are tetrahedra. The class knows which faces a point, a part or the
 * cluster has to see, and the topology of the cluster. It does not decide which points leave.
 *
 * Its methods count the work, and report progress. Those that look at cells throw Aborted, and
 * WorkSpent if all work together, since the construction, exceeds the limit.
 */
class PointCluster
{
public:
  /// Without points. solid: outlives the cluster. progress: is called with 0.
  PointCluster(SolidCells& solid, const ConeExpansionOptions& options, const Progress& progress);

  /// Begins anew with inner points (IsMovable) as the cluster with id 1. All others are by
  /// themselves.
  void Begin(const std::vector<int>& members);

  /// Adds cells or faces that are looked at to the work. Who looks at them more often than the
  /// methods here do, has to call it.
  void Count(std::size_t cells) const;

  SolidCells& Solid;

  /// For each point: where it can move, if that is known; reset when the faces around it change.
  std::vector<std::optional<StarPlacement>> Moves;

  const std::vector<int>& Points() const { return this->Members; }

  bool IsIn(int point) const { return this->Ids[point] == this->Id; }
  bool IsAlone(int point) const { return this->Ids[point] == 0; }
  /// Whether a point is not on the boundary and has only tetrahedra around it.
  static bool IsMovable(const SolidCells& solid, int point);
  bool IsMovable(int point) const { return IsMovable(this->Solid, point); }
  /// Whether a simplex (two or three points) may be split (SolidCells::CanSplit).
  bool CanSplit(const std::vector<int>& simplex) const;

  /// Returns the position c of the points.
  Eigen::RowVector3d GetPosition() const { return this->Solid.Points.row(this->Members.front()); }
  Eigen::RowVector3d ComputeCentroid() const;
  void MoveTo(const Eigen::RowVector3d& position);

  /// Adds a point that is not in the cluster, which may be new in the solid. Its position stays.
  void Add(int point);
  /// Lets points leave, to another cluster or (id 0) by themselves. Their positions stay.
  void Release(const std::vector<int>& part, int id);
  /// Goes on with another cluster, given by all its points.
  void Select(std::vector<int> part);
  /// Lets faces be found as if a point were in the cluster, or by itself. Points() stay.
  void Pretend(int point, bool isIn) { this->Ids[point] = isIn ? this->Id : 0; }
  /// Resets where the points around a point can move.
  void ForgetMoves(int point);

  /// Returns the points that share a cell with a point, ascending.
  std::vector<int> FindNeighbours(int point) const;
  /// Whether all of them are in the cluster.
  bool IsSurrounded(int point) const;
  /// Returns the points of the cluster and those around it.
  std::vector<int> FindPointsAround() const;
  /// Returns the faces opposite to a point that it sees if it moves alone.
  std::vector<StarFace> FindFacesAround(int point) const;
  /// Returns those of them without a point of the cluster.
  std::vector<StarFace> FindOuterFacesAround(int point) const;
  /// Returns the faces that the cluster has to see.
  std::vector<StarFace> FindOuterFaces() const { return this->FindOuterFaces(this->Members); }
  /// Returns those of them that are opposite to some points of the cluster.
  std::vector<StarFace> FindOuterFaces(const std::vector<int>& points) const;
  /// Returns the faces that a part of the cluster has to see if it moves as one.
  std::vector<StarFace> FindFacesAroundPart(const std::vector<int>& part);
  /// Whether no corner of a face is in the cluster.
  bool IsOutside(const StarFace& face) const;

  /// Returns a position that sees the faces (FindKernelCentre).
  StarPlacement FindPlacement(
    const std::vector<StarFace>& faces, const Eigen::RowVector3d& origin) const;
  /// Returns where a point can move alone.
  StarPlacement FindPlacement(int point) const;
  /// Returns where a point could move alone if other points were in the cluster.
  StarPlacement FindPlacementIfJoined(int point, const std::vector<int>& joined);

  /// Whether the points around a point that are in the cluster are connected, and the others, too.
  /// The cluster then keeps its topology without the point.
  bool IsPeelable(int point) const;
  /// Whether all points can leave the cluster one by one, wherever they are. It then is a ball.
  bool IsCollapsible();
  /// Whether a part of the cluster and the rest of it are connected, without holes.
  bool IsDivision(const std::vector<int>& part) const;

private:
  /// Whether the corners of a face are at different positions.
  bool IsWide(const StarFace& face) const;
  bool IsConnected(const std::set<int>& points) const;
  bool IsContractible(const std::vector<int>& part) const;
  std::vector<StarFace> FindAllFacesAround(int point) const;

  const bool MaySplit;
  const double MaximumWork;
  const Progress Report;
  mutable double Work = 0.0, NextReport = 0.0;
  std::vector<int> Joined; ///< all points that have been in the cluster since its beginning
  std::vector<int> Ids;    ///< for each point: the cluster that contains it, or 0
  int Id = 1;              ///< of the present cluster
  std::vector<int> Members;
};

} // namespace shape
