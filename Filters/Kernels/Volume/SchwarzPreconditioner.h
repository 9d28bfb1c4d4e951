#pragma once

#include "Core/Progress.h"

#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// The system that charges near a surface solve: site j of the surface tests what is left over at
/// the rows with row j of Tests, and has the charge at row j of Sources.
struct TestedSystem
{
  Eigen::MatrixXd Rows;  ///< m x 3: where values are given
  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests; ///< n x m: weighted means
  Eigen::MatrixXd Sites;   ///< n x 3
  Eigen::MatrixXd Sources; ///< n x 3
  Eigen::VectorXd Weights; ///< m, >= 0: of the rows
};

/**
 * An approximate inverse of the potentials of charges near a surface, in two levels: coarse charges
 * farther out, one for each cluster of sites, solved densely; then, on what these leave over,
 * restricted additive Schwarz: each small cluster of sites takes its own charges from a dense local
 * system that includes the sites around it (Cai and Sarkis, "A restricted additive Schwarz
 * preconditioner for general sparse linear systems", 1999).
 */
class SchwarzPreconditioner
{
public:
  /// coarseSources: c x 3. clusters: n, the coarse source of each site. Throws Aborted.
  SchwarzPreconditioner(const TestedSystem& system, const Eigen::MatrixXd& coarseSources,
    const Eigen::VectorXi& clusters, const Progress& progress = {});

  /// residual: m x k. Charges at the sources, then at the coarse ones: (n + c) x k.
  Eigen::MatrixXd Apply(const Eigen::MatrixXd& residual) const;

private:
  struct Block
  {
    std::vector<int> Sites;  ///< those around the cluster, the cluster's own first
    std::vector<int> Rows;
    Eigen::MatrixXf Inverse; ///< own x all
  };
  Block MakeBlock(const TestedSystem& system, std::vector<int> own, std::vector<int> around) const;
  Eigen::MatrixXd ClusterMeans(const Eigen::MatrixXd& values) const;

  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests;
  Eigen::MatrixXd Sites, Rows, CoarseSources;
  Eigen::VectorXi Clusters;
  Eigen::VectorXd ClusterSizes;
  Eigen::MatrixXd CoarseInverse;
  std::vector<Block> Blocks;
};

/// Splits points at the medians of their longest extents until no part has more than `most`: the
/// rows in each part, in ascending order.
std::vector<std::vector<int>> MedianClusters(const Eigen::MatrixXd& points, int most);

} // namespace shape
