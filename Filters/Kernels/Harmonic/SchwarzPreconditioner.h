#pragma once

#include "Base/Progress.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// The system that charges near a surface solve: site j of the surface has the charge at row j of
/// Sources, and tests what is left over at the rows with row j of Tests.
struct TestedSystem
{
  Eigen::MatrixXd Rows;                               ///< m x 3: where values are given
  Eigen::VectorXd Weights;                            ///< m, >= 0: of the rows
  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests; ///< n x m: weighted means
  Eigen::MatrixXd Sites;                              ///< n x 3
  Eigen::MatrixXd Sources;                            ///< n x 3
};

struct SchwarzOptions
{
  int Own = 64;     ///< most sites of a block; >= 1
  int Around = 100; ///< sites around them that its local system includes; >= 0
  /// A block whose tested system amplifies more is solved by least squares over the rows, with a
  /// ridge: one that is wild drowns what all others do, until iterations have singled it out.
  /// Blocks of even triangles amplify 100 to 600 times. 0: all are solved so, which takes three
  /// times the time and memory, and holds where charges are crowded.
  double MaximumAmplification = 1e3;
};

/**
 * An approximate inverse of the potentials of charges near a surface, in two levels: coarse charges
 * farther out, one for each cluster of sites; then, on what these leave over, restricted additive
 * Schwarz: each block of sites takes its own charges from a dense local system that includes the
 * sites around it (Cai and Sarkis, "A restricted additive Schwarz preconditioner for general sparse
 * linear systems", 1999). Linear.
 */
class SchwarzPreconditioner
{
public:
  /// coarseSources: c x 3. clusters: n, the coarse source of each site. Throws Aborted.
  SchwarzPreconditioner(const TestedSystem& system, const Eigen::MatrixXd& coarseSources,
    const Eigen::VectorXi& clusters, const SchwarzOptions& options = {},
    const Progress& progress = {});

  /// residual: m x k. Charges at the sources, then at the coarse ones: (n + c) x k.
  Eigen::MatrixXd Apply(const Eigen::MatrixXd& residual) const;

private:
  struct Block
  {
    std::vector<int> Own;    ///< sites
    std::vector<int> Inputs; ///< of what is left, what it takes: see Positions
    bool TakesRows = false;  ///< and not tests
    Eigen::MatrixXf Inverse; ///< own x inputs
  };
  static Block MakeBlock(const TestedSystem& system, const std::vector<int>& own,
    const std::vector<int>& around, double maximumAmplification);
  void GatherPositions(const TestedSystem& system);
  void SetUpCoarse(const Progress& progress);

  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests;
  std::vector<Block> Blocks;
  /// Where the blocks take what is left: at all sites, for the means that test there, then at Rows.
  Eigen::MatrixXd Positions;
  std::vector<int> Rows; ///< that blocks take
  Eigen::MatrixXd CoarseSources;
  Eigen::SparseMatrix<double, Eigen::RowMajor> ClusterMeans; ///< c x n
  Eigen::MatrixXd CoarseInverse; ///< c x c, from the means over clusters
};

/// Splits points at the medians of their longest extents until no part has more than `most`: the
/// rows in each part, in ascending order.
std::vector<std::vector<int>> SplitAtMedians(const Eigen::MatrixXd& points, int maximum);

} // namespace shape
