#pragma once

#include <Eigen/Core>

#include <array>
#include <atomic>

namespace shape
{

/**
 * Counts how often the topology and the search tree of one surface are computed during the lifetime
 * of this object. Tests use it: the counts exceed one if a kernel copies its surface instead of
 * passing it on. Only one object may exist at a time.
 */
class SurfaceWork
{
public:
  enum class Kind
  {
    Topology,
    SearchTree
  };

  /// points: n x 3, the points of the surface. Every surface with the same points is counted,
  /// whatever its triangles.
  explicit SurfaceWork(Eigen::MatrixXd points);
  ~SurfaceWork();
  SurfaceWork(const SurfaceWork&) = delete;
  SurfaceWork& operator=(const SurfaceWork&) = delete;

  int Count(Kind kind) const { return this->Counts[static_cast<std::size_t>(kind)]; }

  /// Must be called by every function that computes a topology or a search tree. points: the points
  /// of the surface. May be called from any thread.
  static void Note(Kind kind, const Eigen::MatrixXd& points);

private:
  const Eigen::MatrixXd Points;
  std::array<std::atomic<int>, 2> Counts{};
};

} // namespace shape
