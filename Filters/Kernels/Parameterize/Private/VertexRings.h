#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A triangulated sphere as the ring of neighbours around each point, counter-clockwise, from which
 * points are removed and to which they come back: half-edge collapses and their inverse.
 */
class VertexRings
{
public:
  /// triangles: m x 3, a closed oriented 2-manifold that uses all of `points` points.
  VertexRings(const Eigen::MatrixXi& triangles, int points);

  int Size() const { return static_cast<int>(this->Rings.size()); } ///< points, removed or not
  int Remaining() const { return this->Count; }
  bool Contains(int point) const { return !this->Rings[point].empty(); }
  const std::vector<int>& Around(int point) const { return this->Rings[point]; }

  /// The ring of `point` from `first` on.
  std::vector<int> RingFrom(int point, int first) const;

  /// Whether `point` may be merged into its neighbour `into`: no other points than the two beside
  /// their edge are next to both (the link condition), and more than a tetrahedron is there.
  bool CanMerge(int point, int into) const;

  /// Merges `point` into `into`; returns its ring, which starts with `into`, for Restore.
  std::vector<int> Merge(int point, int into);

  /// Undoes Merge(point, ring[0]). Merges are undone in the opposite order.
  void Restore(int point, const std::vector<int>& ring);

private:
  std::vector<std::vector<int>> Rings;
  int Count;
};

/// Whether every triangle from `position` to an edge of the ring, a closed polygon of `points` on
/// the unit sphere that runs counter-clockwise, faces outwards for certain.
bool IsInStarKernel(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& position, const std::vector<int>& ring);

/**
 * Moves points.row(point) to a position on the unit sphere that sees the whole ring: the centre of
 * the ring's kernel, found by clipping the lune at ring[0] with the planes of the other edges.
 * ring[0] must see all edges but its own two, as after a half-edge collapse; then the kernel is not
 * empty. Returns false, and moves nothing, if rounding leaves no such position.
 */
bool MovePointIntoKernel(Eigen::MatrixXd& points, int point, const std::vector<int>& ring);

} // namespace shape
