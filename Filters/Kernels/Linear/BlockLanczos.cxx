#include "Linear/BlockLanczos.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Linear/SymmetricEigen.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int Block = 16; // number of columns that the operator is applied to together
constexpr int Restarts = 100;
/// Blocks between two convergence tests; one test costs as much as a few blocks.
constexpr int Patience = 4;

/// The thick-restart iteration: Find extends the basis block by block, diagonalises the operator on
/// it, and restarts with the best Ritz vectors when it is full.
class Iteration
{
public:
  Iteration(
    const SymmetricOperator& apply, const Eigen::MatrixXd& known, int wanted, double tolerance)
    : Apply(apply)
    , Known(known)
    , Tolerance(tolerance)
    , Wanted(wanted)
    // More Ritz vectors than wanted are kept, so that the last wanted ones converge faster.
    , Kept(wanted + Block)
    , Most(std::max(2 * this->Kept, this->Kept + 8 * Block))
    , Basis(known.rows(), this->Most + Block)
    , Projected(Eigen::MatrixXd::Zero(this->Most, this->Most))
  {
  }

  Eigenpairs Find(const Progress& progress)
  {
    // Outline (thick-restart Lanczos, Wu and Simon 2000):
    // 1. A random block, improved by one application of the operator.
    // 2. The basis is extended by blocks.
    // 3. Every few blocks the Ritz pairs of the projected operator are tested for convergence.
    // 4. A full basis is replaced by its best Ritz vectors and the next block; then step 2.
    this->Basis.leftCols(Block) = this->Completed(this->Apply(this->Random(Block)), 0);
    for (int restart = 0; restart < Restarts; ++restart)
    {
      for (bool isFull = false; !isFull;)
      {
        this->Report(progress);
        // Step 2: the next block.
        this->Extend(progress);
        isFull = this->Size + Block > this->Most;
        if (this->Size >= this->Kept && (isFull || this->Size / Block % Patience == 0))
        {
          // Step 3: convergence test.
          this->Diagonalise();
          if (this->IsFound())
          {
            return { this->Values.head(this->Wanted), this->Ritz(this->Wanted, progress) };
          }
        }
      }
      // Step 4: thick restart.
      this->Restart(progress);
    }
    throw SolveFailure("the eigenvalues were not found in " + std::to_string(Restarts) +
      " restarts of the Lanczos iteration; ask for fewer eigenvalues");
  }

private:
  /// The number of restarts is unknown. The converged pairs show how far the iteration is once the
  /// basis was full.
  double Share()
  {
    constexpr double filling = 0.3; // share of the time until the first restart
    this->Filled = std::max(this->Filled, this->Size);
    return 0.99 *
      (filling * std::min(1.0, static_cast<double>(this->Filled) / this->Most) +
        (1.0 - filling) * static_cast<double>(this->Converged) / this->Wanted);
  }

  void Report(const Progress& progress) { progress(this->Share()); }

  Eigen::MatrixXd Random(Eigen::Index columns)
  {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    return Eigen::MatrixXd::NullaryExpr(
      this->Known.rows(), columns, [&] { return uniform(this->Generator); });
  }

  /// Applies the operator to the last block and appends the new directions of the result.
  void Extend(const Progress& progress)
  {
    Eigen::MatrixXd image = this->Apply(this->Basis.middleCols(this->Size, Block));
    this->Report(progress);
    image -= this->Known * (this->Known.transpose() * image).eval();
    const int first = this->Size;
    this->Size += Block;
    // Except for the first blocks after a start, an image has significant components only in the
    // last two blocks. The second pass removes the others, and rounding errors.
    const int near = first < this->Recurrent ? this->Size : 2 * Block;
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(this->Size, Block);
    const auto last = this->Basis.middleCols(this->Size - near, near);
    coefficients.bottomRows(near).noalias() = last.transpose() * image;
    image.noalias() -= last * coefficients.bottomRows(near);
    const auto before = this->Basis.leftCols(this->Size);
    const Eigen::MatrixXd again = before.transpose() * image;
    image.noalias() -= before * again;
    coefficients += again;
    this->Projected.block(0, first, this->Size, Block) = coefficients;
    this->Projected.block(first, 0, Block, this->Size) = coefficients.transpose();
    this->Basis.middleCols(this->Size, Block) =
      this->Orthonormal(image, coefficients.cwiseAbs().maxCoeff());
    this->Last = this->Basis.middleCols(this->Size, Block).transpose() * image;
  }

  /// Returns orthonormal columns with the same span as these, which are orthogonal to the basis.
  /// Columns that are tiny relative to `scale` are replaced.
  Eigen::MatrixXd Orthonormal(Eigen::MatrixXd columns, double scale)
  {
    constexpr double minimum = 1e-5; // below this, rounding errors grow too much
    for (int again = 0; again < 2; ++again)
    {
      // Cholesky QR, twice: the second pass removes the rounding error of the first.
      const Eigen::LLT<Eigen::MatrixXd> root(columns.transpose() * columns);
      if (root.info() != Eigen::Success ||
        Eigen::MatrixXd(root.matrixL()).diagonal().minCoeff() < minimum * scale)
      {
        return this->Completed(columns, this->Size);
      }
      root.matrixU().solveInPlace<Eigen::OnTheRight>(columns);
      scale = 1.0;
    }
    return columns;
  }

  /// The same for linearly dependent columns: random ones complete them.
  Eigen::MatrixXd Completed(const Eigen::MatrixXd& columns, int size)
  {
    constexpr double minimum = 1e-13; // relative to the largest pivot
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> ranked(columns);
    const Eigen::VectorXd pivots = ranked.matrixQR().diagonal().cwiseAbs();
    const Eigen::Index rank = (pivots.array() > minimum * pivots.maxCoeff()).count();
    Eigen::MatrixXd result =
      ranked.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), Block);
    result.rightCols(Block - rank) = this->Random(Block - rank);
    const auto basis = this->Basis.leftCols(size);
    for (int again = 0; again < 2; ++again)
    {
      result -= this->Known * (this->Known.transpose() * result).eval();
      result -= basis * (basis.transpose() * result).eval();
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(result);
      result = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), Block);
    }
    return result;
  }

  /// Computes the Ritz values and vectors that a restart would keep, the largest first.
  void Diagonalise()
  {
    Eigenpairs ritz =
      FindLargestEigenpairs(this->Projected.topLeftCorner(this->Size, this->Size), this->Kept);
    this->Values = std::move(ritz.Values);
    this->Vectors = std::move(ritz.Vectors);
  }

  bool IsFound()
  {
    // The residual of a Ritz pair lies in the next block alone, so its norm needs no application of
    // the operator.
    const Eigen::VectorXd residuals =
      (this->Last * this->Vectors.bottomRows(Block)).colwise().norm().transpose();
    const auto converged = (residuals.head(this->Wanted).array() <=
      this->Tolerance * this->Values.head(this->Wanted).array())
                             .count();
    this->Converged = std::max(this->Converged, static_cast<int>(converged));
    return converged == this->Wanted;
  }

  /// Returns the first Ritz vectors.
  Eigen::MatrixXd Ritz(int count, const Progress& progress)
  {
    Eigen::MatrixXd result(this->Basis.rows(), count);
    constexpr int grain = 4096;
    const double share = this->Share();
    ParallelFor(
      static_cast<int>(result.rows()), grain,
      [&](int begin, int end)
      {
        result.middleRows(begin, end - begin).noalias() =
          this->Basis.block(begin, 0, end - begin, this->Size) * this->Vectors.leftCols(count);
      },
      progress.Part(share, share));
    return result;
  }

  /// Keeps only the best Ritz vectors and the block that would have been next.
  void Restart(const Progress& progress)
  {
    const Eigen::MatrixXd best = this->Ritz(this->Kept, progress);
    const Eigen::MatrixXd next = this->Basis.middleCols(this->Size, Block);
    this->Basis.leftCols(this->Kept) = best;
    this->Basis.middleCols(this->Kept, Block) = next;
    // In the basis of Ritz vectors the projected operator is diagonal. Its coupling to the next
    // block follows when that block is applied.
    this->Projected.setZero();
    this->Projected.diagonal().head(this->Kept) = this->Values.head(this->Kept);
    this->Size = this->Kept;
    this->Recurrent = this->Kept + Block;
  }

  const SymmetricOperator& Apply;
  const Eigen::MatrixXd& Known;
  const double Tolerance;
  const int Wanted, Kept, Most; // numbers of pairs: wanted, kept at a restart, maximum in the basis
  Eigen::MatrixXd Basis;     ///< orthonormal; the operator has not been applied to its last block
  Eigen::MatrixXd Projected; ///< the operator projected onto the basis
  Eigen::MatrixXd Last;      ///< coefficients of the last image in the block after the basis
  Eigen::VectorXd Values;
  Eigen::MatrixXd Vectors;
  int Size = 0;          ///< columns of the basis to which the operator was applied
  int Recurrent = Block; ///< first column from which images have three terms
  int Filled = 0;        ///< maximum of Size so far
  int Converged = 0;     ///< wanted pairs that a convergence test has found, at most
  std::mt19937 Generator;
};

} // namespace

Eigenpairs FindExtremeEigenpairs(const SymmetricOperator& apply, const Eigen::MatrixXd& known,
  int wanted, const Progress& progress, double tolerance)
{
  // The products have few columns. Threads of BLAS would save little time, and lose much whenever
  // other programs use the cores, because they wait for each other in every product.
  const BlasThreads one(false);
  return Iteration(apply, known, wanted, tolerance).Find(progress);
}

} // namespace shape
