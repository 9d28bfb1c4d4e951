#pragma once

#include "Base/Processes.h"
#include "Base/Progress.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// A linear system for charges near a surface. The charge of site j lies at row j of Sources. Row j
/// of Tests averages the residual around site j.
struct TestedSystem
{
  Eigen::MatrixXd Rows;    ///< m x 3: positions where values are prescribed
  Eigen::VectorXd Weights; ///< m values, each >= 0: weights of the rows
  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests; ///< n x m: weights of the averages
  Eigen::MatrixXd Sites;                              ///< n x 3
  Eigen::MatrixXd Sources;                            ///< n x 3
};

struct SchwarzOptions
{
  int Own = 64;     ///< maximum number of sites of a block; >= 1
  int Around = 100; ///< number of surrounding sites in the local system of a block; >= 0
  /// Maximum amplification of a block's averaged system. A block with a larger amplification is
  /// ill-conditioned, and its error would dominate for many iterations. Such a block is solved by
  /// regularized least squares over the rows instead. For evenly sized triangles the amplification
  /// is 100 to 600. With 0 all blocks are solved by least squares. This takes three times the time
  /// and memory, but also works if charges are crowded.
  double MaximumAmplification = 1e3;
  /// The blocks and the rows are distributed over these processes.
  shape::Processes Processes;
};

/**
 * An approximate inverse of a TestedSystem, in two levels. The first level has coarse charges
 * farther out, one for each cluster of sites. Restricted additive Schwarz then reduces the residual
 * that they leave. The charges of each block of sites solve a dense local system that includes the
 * surrounding sites (Cai and Sarkis, "A restricted additive Schwarz preconditioner for general
 * sparse linear systems", 1999). The operator is linear.
 */
class SchwarzPreconditioner
{
public:
  /// system: the same on all processes. ownRows: the rows of this process, ascending; every row
  /// belongs to one process. coarseSources: c x 3. clusters: for each of the n sites, the index of
  /// its coarse source. Throws Aborted.
  SchwarzPreconditioner(const TestedSystem& system, const std::vector<int>& ownRows,
    const Eigen::MatrixXd& coarseSources, const Eigen::VectorXi& clusters,
    const SchwarzOptions& options = {}, const Progress& progress = {});

  /// residual: the residual at this process's rows, with k columns. Returns the charges at the
  /// sources, then the charges at the coarse sources: (n + c) x k, the same on all processes.
  Eigen::MatrixXd Apply(const Eigen::MatrixXd& residual, const Progress& progress = {}) const;

  ///@{
  /// The operator without its averages, and its transpose. ApplyToAverages computes charges
  /// ((n + c) x k) from the averages of the residual (n x k): Apply(r) is ApplyToAverages(Tests r).
  /// ApplyTransposed computes n x k values from (n + c) x k. They need one process and an infinite
  /// MaximumAmplification, because blocks of least squares read more than averages.
  Eigen::MatrixXd ApplyToAverages(
    const Eigen::MatrixXd& averages, const Progress& progress = {}) const;
  Eigen::MatrixXd ApplyTransposed(
    const Eigen::MatrixXd& charges, const Progress& progress = {}) const;
  ///@}

private:
  struct Block
  {
    std::vector<int> Own;    ///< the sites whose charges the block solves for
    std::vector<int> Inputs; ///< rows of Positions whose residuals the block reads
    bool TakesRows = false;  ///< true: the inputs are rows of the system, not averages
    Eigen::MatrixXf Inverse; ///< own sites x inputs: computes the charges from the inputs
  };
  static Block MakeBlock(const TestedSystem& system, const std::vector<int>& own,
    const std::vector<int>& around, double maximumAmplification);
  /// Returns the number of each row of the system, or -1.
  std::vector<int> NumberRows(const TestedSystem& system, const std::vector<int>& ownRows);
  void GatherPositions(
    const TestedSystem& system, const Eigen::MatrixXd& averaged, const std::vector<int>& numbers);
  void SetUpCoarse(const Eigen::MatrixXd& averaged, const Progress& progress);
  /// Computes the charges from the averages at all sites, and the rows in ReadRows.
  Eigen::MatrixXd FindCharges(
    const Eigen::MatrixXd& averages, const Eigen::MatrixXd& rows, const Progress& progress) const;

  shape::Processes Processes;
  /// Tests of the sites whose first row this process has; the others are zero. The columns are the
  /// rows of this process, then the numbered rows.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Tests;
  std::vector<Block> Blocks; ///< those of this process
  /// Positions where blocks read the residual: first the weighted mean position of the average of
  /// each site in ReadSites, then the positions of the rows in ReadRows.
  Eigen::MatrixXd Positions;
  std::vector<int> ReadSites, ReadRows; ///< what the blocks of this process read, ascending
  /// The rows are numbered that a block of any process reads, or a test of a process that does not
  /// have the row. ReadRows holds these numbers.
  int NumberedRows = 0;
  /// Those of this process: the number of each, and its index among this process's rows.
  std::vector<int> SentRows, SentIndices;
  Eigen::MatrixXd CoarseSources;
  /// c x n: mean over the sites of each cluster
  Eigen::SparseMatrix<double, Eigen::RowMajor> ClusterMeans;
  Eigen::MatrixXd CoarseInverse; ///< c x c: computes the coarse charges from the cluster means
};

/// Splits points (n x 3) recursively into parts of at most `maximum` points. Each split is at the
/// median along the longest side of the part's box. Returns the rows in each part, ascending.
std::vector<std::vector<int>> SplitAtMedians(const Eigen::MatrixXd& points, int maximum);

} // namespace shape
