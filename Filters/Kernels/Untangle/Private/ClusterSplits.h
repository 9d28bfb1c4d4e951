#pragma once

#include "Untangle/Private/PointCluster.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace shape
{

/// A point that can leave a cluster, and where it goes.
struct PointExit
{
  int Point;
  Eigen::RowVector3d Position;
};

/**
 * Splits edges of a cluster's tetrahedra if no point of it has a kernel. A point then sees only
 * some of its faces from anywhere near c. The others have corners that are hidden. New points in
 * the edges to these are at c at first.
 *
 * Given points are tried before new ones, and those with few hidden points before others. Edges
 * stay split if a trial fails. Both methods throw what the cluster throws.
 */
class ClusterSplits
{
public:
  explicit ClusterSplits(PointCluster& cluster)
    : Cluster(cluster)
  {
  }

  /// Pulls the new points to where they are not hidden, in a few rounds. Only points are tried
  /// without which the cluster keeps its topology. Returns none if that succeeds for none of the
  /// first few.
  std::optional<PointExit> FindExitByPulling();

  /// Leaves the new points in the cluster: they take the part of the star that the point cannot
  /// see, so that it can move into the other part, which is star-shaped. Returns none if that
  /// succeeds for no point.
  std::optional<PointExit> FindExitByParts();

private:
  /// A point of the cluster and the face from whose centre the fewest points are hidden.
  struct Cut
  {
    int Generation = 0; ///< of the point
    std::size_t Hidden = 0;
    int Point = -1; ///< -1 if there is no face
    std::size_t Seed = 0;
    bool operator<(const Cut& other) const;
  };

  Cut FindCut(int point) const;
  std::vector<Cut> FindCuts(bool onlyPeelable) const;
  std::vector<int> FindOutside(int point) const;
  int SplitSpoke(int point, int end);
  void PullIntoSpokes(int point, std::size_t seed, std::vector<int>& pulled);
  void PullAway(int point, const Eigen::RowVector3d& to, const std::vector<int>& pulled);
  std::optional<PointExit> TryPulling(const Cut& cut);
  std::optional<PointExit> TryParts(const Cut& cut);

  int GetGeneration(int point) const
  {
    return point < static_cast<int>(this->Generations.size()) ? this->Generations[point] : 0;
  }

  PointCluster& Cluster;
  std::vector<int> Generations; ///< for each point: how many splits in a row made it
};

} // namespace shape
