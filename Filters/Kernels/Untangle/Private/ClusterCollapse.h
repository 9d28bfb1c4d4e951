#pragma once

#include "Base/Progress.h"
#include "Untangle/MinimizeEnergy.h"
#include "Untangle/Private/PointCluster.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Makes space for clusters. All points of a cluster are put at one position, and that position and
 * the points around it are moved by Newton's method (MinimizeEnergy), like those of a solid in
 * which the cluster is one point. Tetrahedra with several points in the cluster do not count, so
 * this succeeds where points cannot be moved one by one. Shen, Jiang, Zorin and Panozzo,
 * "Progressive embedding" (2019), collapse triangles for the same reason.
 */
class ClusterCollapse
{
public:
  /// cluster: outlives the object. Its solid keeps a state (SolidCells::KeepState).
  explicit ClusterCollapse(PointCluster& cluster)
    : Cluster(cluster)
  {
  }

  /// Moves the cluster to a position that sees all its outer faces, and the points around it so
  /// that all cells there without a point of the cluster are positive. If they cannot move so, the
  /// points of the cells that stay inverted join the cluster, a few times. Returns whether that
  /// succeeds and the cluster is a ball; otherwise, the solid has to be restored. Throws Aborted
  /// and WorkSpent.
  bool MakeSpace(const Progress& progress);

private:
  Eigen::VectorXd FindSizes(const Progress& progress);
  std::vector<int> FindMovedPoints() const;
  int MovePoints(SimplexPatch& patch, const Progress& progress);
  bool AddInverted(const SimplexPatch& patch);

  PointCluster& Cluster;
  Eigen::VectorXd GivenSizes; ///< ComputeLogarithmicSizes, when space was first made
};

} // namespace shape
