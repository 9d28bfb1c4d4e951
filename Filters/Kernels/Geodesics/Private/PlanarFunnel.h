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
  int Portal; ///< the first portal with this end
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
  /// Adds the left or right end of a portal, unless it is also that of the previous portal.
  void AddLeft(const Eigen::RowVector2d& position, int portal);
  void AddRight(const Eigen::RowVector2d& position, int portal);
  ///@}

  /// Returns the points where the shortest path to the last added point turns.
  std::vector<FunnelPoint> PathToLast() const;

private:
  const Eigen::RowVector2d& At(int i) const { return this->Points[this->Chains[i]].Position; }

  std::vector<FunnelPoint> Points; ///< the start first
  std::deque<int> Chains;          ///< indices of Points: left end first, right end last
  int Lefts = 0;                   ///< number of entries of Chains before the apex
};

} // namespace shape
