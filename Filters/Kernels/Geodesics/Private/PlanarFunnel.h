#pragma once

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace shape
{

/// A point on the boundary of a planar strip, and the previous point on the shortest path from the
/// start to it.
struct FunnelPoint
{
  Eigen::RowVector2d Position;
  int Portal; ///< the first portal that has this point as an end
  bool IsLeft;
  int Before;
};

/// The shortest paths within a strip from its start to the two ends of its last portal. They
/// separate at an apex and form two chains that bend away from each other (Lee and Preparata 1984).
class PlanarFunnel
{
public:
  explicit PlanarFunnel(const Eigen::RowVector2d& start);

  ///@{
  /// Adds the left or right end of a portal. An end that is also an end of the previous portal must
  /// not be added again.
  void AddLeft(const Eigen::RowVector2d& position, int portal);
  void AddRight(const Eigen::RowVector2d& position, int portal);
  ///@}

  /// Returns the points where the shortest path to the last added point turns.
  std::vector<FunnelPoint> PathToLast() const;

private:
  const Eigen::RowVector2d& At(int i) const { return this->Points[this->Chains[i]].Position; }

  std::vector<FunnelPoint> Points; ///< the start is the first
  /// indices of Points, from the left end of the last portal, through the apex, to its right end
  std::deque<int> Chains;
  int Lefts = 0; ///< number of entries of Chains before the apex
};

} // namespace shape
