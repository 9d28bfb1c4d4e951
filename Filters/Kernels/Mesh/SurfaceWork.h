#pragma once

#include <Eigen/Core>

#include <array>
#include <atomic>

namespace shape
{

/**
 * Counts, while it exists, how often the topology and the search tree of one surface are computed.
 * Tests use it: a kernel that copies its surface instead of passing it on makes the counts greater
 * than one. There may be one counter at a time.
 */
class SurfaceWork
{
public:
  enum class Kind
  {
    Topology,
    SearchTree
  };

  /// points (n x 3): the surface's; any surface of the same points counts, whatever its triangles.
  explicit SurfaceWork(Eigen::MatrixXd points);
  ~SurfaceWork();
  SurfaceWork(const SurfaceWork&) = delete;
  SurfaceWork& operator=(const SurfaceWork&) = delete;

  int Count(Kind kind) const { return this->Counts[static_cast<std::size_t>(kind)]; }

  /// What computes something of a surface calls this first, from any thread.
  static void Note(Kind kind, const Eigen::MatrixXd& points);

private:
  const Eigen::MatrixXd Points;
  std::array<std::atomic<int>, 2> Counts{};
};

} // namespace shape
