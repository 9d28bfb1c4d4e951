#pragma once

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace shape
{

/// A point on the boundary of a strip in the plane, and the one that the shortest path from the
/// start comes from.
struct FunnelPoint
{
  Eigen::RowVector2d Position;
  int Portal; ///< the first one that it is an end of
  bool IsLeft;
  int Before;
};

/// The shortest paths within a strip from its start to the ends of the last of its portals: two
/// chains that part at an apex and bend away from each other (Lee and Preparata 1984).
class PlanarFunnel
{
public:
  explicit PlanarFunnel(const Eigen::RowVector2d& start);

  ///@{
  /// The end of a portal on the left or the right, unless it is the previous one's.
  void AddLeft(const Eigen::RowVector2d& position, int portal);
  void AddRight(const Eigen::RowVector2d& position, int portal);
  ///@}

  /// The points that the shortest path to the point added last turns at.
  std::vector<FunnelPoint> PathToLast() const;

private:
  const Eigen::RowVector2d& At(int i) const { return this->Points[this->Chains[i]].Position; }

  std::vector<FunnelPoint> Points; ///< the start first
  std::deque<int> Chains;          ///< the left end first, the right end last
  int Lefts = 0;                   ///< of them before the apex
};

} // namespace shape
