#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/ClusterSplits.h"
#include "Untangle/Private/ConeExpansionOptions.h"
#include "Untangle/Private/PointCluster.h"

#include <Eigen/Core>

#include <random>
#include <vector>

namespace shape
{

/**
 * Expands a cluster: its points leave it one by one, each into its kernel (ExpandInverted). If none
 * can leave, or only with little space, these are tried in turn:
 * - Points around the cluster, and the cluster itself, move to the centres of their kernels.
 * - A part of the cluster moves as one, and is expanded later (FindDivision).
 * - Edges are split (ClusterSplits).
 */
class ClusterExpansion
{
public:
  /// cluster: is at one position that sees all its faces (GrowCluster), and outlives the expansion.
  /// seed: of the order in which points leave, for another attempt.
  ClusterExpansion(PointCluster& cluster, unsigned int seed);

  /// Divides the cluster until each point is by itself, and adds what was done to the result.
  /// Returns false if that takes too many splits; the solid then has to be restored, as after
  /// WorkSpent. Throws Aborted.
  bool Expand(
    const ConeExpansionOptions& options, ConeExpansionResult& result, const Progress& progress);

private:
  bool SelectNext();
  bool ReleaseClearest();
  bool Divide();
  bool ReleaseAfterSplits();

  int FindClearest();
  StarPlacement FindMove(int point);
  void Release(const std::vector<int>& part, const Eigen::RowVector3d& position, int id);
  bool Relax(int point);
  void RelaxAll();

  PointCluster& Cluster;
  ClusterSplits Splits;
  std::mt19937 Random;
  std::vector<std::vector<int>> Waiting; ///< parts that are expanded later
  int LastId = 1;                        ///< of all clusters so far
  bool IsRelaxed = false;                ///< since a point has left
};

} // namespace shape
