#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace shape
{

/// Finds the nearest of n fixed points (n x 3); its answers do not change with their order.
class PointTree
{
public:
  explicit PointTree(const Eigen::MatrixXd& points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  /// The `count` nearest points (fewer where there are fewer), the nearest first; equally near ones
  /// by number.
  std::vector<int> Nearest(const Eigen::RowVector3d& position, int count) const;

  /// The nearest of the points that `accepts` takes, nearer than `within`, or -1.
  int NearestOf(const Eigen::RowVector3d& position, const std::function<bool(int)>& accepts,
    double within) const;

  /// The points no farther than `radius`, by number.
  std::vector<int> Within(const Eigen::RowVector3d& position, double radius) const;

private:
  struct Index;
  std::unique_ptr<Index> Impl;
};

} // namespace shape
