#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A triangulated sphere, stored as the counter-clockwise ring of neighbours of each point. It
 * supports half-edge collapses and their inverse.
 */
class VertexRings
{
public:
  /// triangles: m x 3, a closed oriented 2-manifold. Its points are 0 to `points` - 1, and a
  /// triangle uses each of them.
  VertexRings(const Eigen::MatrixXi& triangles, int points);

  /// number of points, including removed ones
  int Size() const { return static_cast<int>(this->Rings.size()); }
  int Remaining() const { return this->Count; }
  bool Contains(int point) const { return !this->Rings[point].empty(); }
  const std::vector<int>& Around(int point) const { return this->Rings[point]; }

  /// Returns the ring of `point`, starting with `first`.
  std::vector<int> RingFrom(int point, int first) const;

  /// Whether `point` may be merged into its neighbour `into`: their only common neighbours are the
  /// two points opposite their edge (the link condition), and more than a tetrahedron is left.
  bool CanMerge(int point, int into) const;

  /// Merges `point` into `into`. Returns the ring of `point`, starting with `into`, for Restore.
  std::vector<int> Merge(int point, int into);

  /// Undoes Merge(point, ring[0]). Merges must be undone in the reverse order.
  void Restore(int point, const std::vector<int>& ring);

private:
  std::vector<std::vector<int>> Rings;
  int Count;
};

/// Whether the whole ring is visible from `position`: each triangle of `position` and an edge of
/// the ring faces outwards (IsFacingOutwards). The ring is a closed counter-clockwise polygon of
/// `points` on the unit sphere.
bool IsInStarKernel(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& position, const std::vector<int>& ring);

/**
 * Moves points.row(point) to a position on the unit sphere from which the whole ring is visible.
 * This is the centre of the ring's kernel, found by clipping the lune at ring[0] with the planes of
 * the other edges. From ring[0], all edges of the ring except the two at ring[0] must be visible,
 * as they are after a half-edge collapse. Then the kernel is not empty. If rounding leaves no such
 * position, nothing moves and the function returns false.
 */
bool MovePointIntoKernel(Eigen::MatrixXd& points, int point, const std::vector<int>& ring);

} // namespace shape
