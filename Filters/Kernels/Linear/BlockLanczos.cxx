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

constexpr int Block = 16; // columns that the operator is applied to at a time
constexpr int Restarts = 100;
/// Blocks between two looks at whether all pairs are found: one costs as much as a few blocks.
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
    , Kept(wanted + Block)
    , Most(std::max(2 * this->Kept, this->Kept + 8 * Block))
    , Basis(known.rows(), this->Most + Block)
    , Projected(Eigen::MatrixXd::Zero(this->Most, this->Most))
  {
  }

  Eigenpairs Find(const Progress& progress)
  {
    this->Basis.leftCols(Block) = this->Completed(this->Apply(this->Random(Block)), 0);
    for (int restart = 0; restart < Restarts; ++restart)
    {
      for (bool isFull = false; !isFull;)
      {
        progress(0.99 * std::min(1.0, static_cast<double>(this->Size) / this->Most));
        this->Extend();
        isFull = this->Size + Block > this->Most;
        if (this->Size >= this->Kept && (isFull || this->Size / Block % Patience == 0))
        {
          this->Diagonalise();
          if (this->IsFound())
          {
            return { this->Values.head(this->Wanted),
              this->Basis.leftCols(this->Size) * this->Vectors.leftCols(this->Wanted) };
          }
        }
      }
      this->Restart();
    }
    throw SolveFailure("the eigenvalues were not found in " + std::to_string(Restarts) +
      " restarts of the Lanczos iteration; ask for fewer");
  }

private:
  Eigen::MatrixXd Random(Eigen::Index columns)
  {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    return Eigen::MatrixXd::NullaryExpr(
      this->Known.rows(), columns, [&] { return uniform(this->Generator); });
  }

  /// Applies the operator to the last block and puts what is new in the result behind it.
  void Extend()
  {
    Eigen::MatrixXd image = this->Apply(this->Basis.middleCols(this->Size, Block));
    image -= this->Known * (this->Known.transpose() * image).eval();
    const int first = this->Size;
    this->Size += Block;
    // But for the first blocks after a start, an image has hardly more of the basis than the last
    // two blocks; the second pass finds the rest and what rounding left.
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

  /// Orthonormal columns that span the same as these, which are orthogonal to the basis; where
  /// they are next to nothing beside `scale`, others in their place.
  Eigen::MatrixXd Orthonormal(Eigen::MatrixXd columns, double scale)
  {
    constexpr double minimum = 1e-5; // below it rounding grows too much
    for (int again = 0; again < 2; ++again)
    {
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

  /// The same for columns that depend on each other: random ones stand in for what is missing.
  Eigen::MatrixXd Completed(const Eigen::MatrixXd& columns, int size)
  {
    constexpr double minimum = 1e-13; // of the whole
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

  /// The Ritz values and vectors that would stay, the largest first.
  void Diagonalise()
  {
    Eigenpairs ritz =
      FindLargestEigenpairs(this->Projected.topLeftCorner(this->Size, this->Size), this->Kept);
    this->Values = std::move(ritz.Values);
    this->Vectors = std::move(ritz.Vectors);
  }

  bool IsFound() const
  {
    const Eigen::VectorXd residuals =
      (this->Last * this->Vectors.bottomRows(Block)).colwise().norm().transpose();
    return (residuals.head(this->Wanted).array() <=
      this->Tolerance * this->Values.head(this->Wanted).array())
      .all();
  }

  /// Only the best Ritz vectors stay, and the block that would have been next.
  void Restart()
  {
    const Eigen::MatrixXd best =
      this->Basis.leftCols(this->Size) * this->Vectors.leftCols(this->Kept);
    const Eigen::MatrixXd next = this->Basis.middleCols(this->Size, Block);
    this->Basis.leftCols(this->Kept) = best;
    this->Basis.middleCols(this->Kept, Block) = next;
    this->Projected.setZero();
    this->Projected.diagonal().head(this->Kept) = this->Values.head(this->Kept);
    this->Size = this->Kept;
    this->Recurrent = this->Kept + Block;
  }

  const SymmetricOperator& Apply;
  const Eigen::MatrixXd& Known;
  const double Tolerance;
  const int Wanted, Kept, Most; // pairs; that stay at a restart; in the basis
  Eigen::MatrixXd Basis;        ///< orthonormal; its last block has not been applied to yet
  Eigen::MatrixXd Projected;    ///< the operator on the basis
  Eigen::MatrixXd Last;         ///< how much of the last image is in the block after the basis
  Eigen::VectorXd Values;
  Eigen::MatrixXd Vectors;
  int Size = 0;          ///< columns of the basis that the operator was applied to
  int Recurrent = Block; ///< the first from which images have three terms
  std::mt19937 Generator;
};

} // namespace

Eigenpairs FindExtremeEigenpairs(const SymmetricOperator& apply, const Eigen::MatrixXd& known,
  int wanted, const Progress& progress, double tolerance)
{
  constexpr Eigen::Index many = 4096; // rows from which threads gain more than they wait
  const BlasThreads threads(known.rows() >= many);
  return Iteration(apply, known, wanted, tolerance).Find(progress);
}

} // namespace shape
