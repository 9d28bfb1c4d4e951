#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace shape
{

/// Finds the nearest of n fixed points (n x 3). The results do not depend on the points' order.
class PointTree
{
public:
  explicit PointTree(const Eigen::MatrixXd& points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  /// Returns the `count` nearest points, or all if there are fewer. The nearest comes first; points
  /// at equal distance are ordered by index.
  std::vector<int> Nearest(const Eigen::RowVector3d& position, int count) const;

  /// Returns the nearest point for which `accepts` returns true, or -1 if no such point is closer
  /// than `within`.
  int NearestOf(const Eigen::RowVector3d& position, const std::function<bool(int)>& accepts,
    double within) const;

  /// Returns the points at a distance of at most `radius`, in ascending order of index.
  std::vector<int> Within(const Eigen::RowVector3d& position, double radius) const;

private:
  struct Index;
  std::unique_ptr<Index> Impl;
};

} // namespace shape
