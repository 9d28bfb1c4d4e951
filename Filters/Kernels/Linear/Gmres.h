#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

struct GmresOptions
{
  int MaximumIterations = 40; ///< >= 1
  /// Stop when no column's weighted root mean square residual is more; >= 0.
  double Tolerance = 1e-8;
  /// Stop when three iterations in a row lower every column's residual by less than this share, or
  /// two where no residual is more than four tolerances; >= 0, < 1.
  double LeastGain = 0.0;
};

struct GmresResult
{
  Eigen::MatrixXd Solution;
  Eigen::MatrixXd Left;         ///< b - A x
  Eigen::RowVectorXd Residuals; ///< of each column: its weighted root mean square
  int Iterations = 0;
};

/// A linear map of matrices, column by column.
using LinearMap = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/**
 * Solves A x = b, or minimises |b - A x| over more and more combinations of preconditioned
 * residuals, by GMRES preconditioned from the right (Saad and Schultz 1986; for least squares with
 * a B that has the shape of A's transpose: Hayami, Yin and Ito, "GMRES methods for least squares
 * problems", 2010, AB-GMRES). All columns of b go through A and B together, each with a Krylov
 * space of its own. The residual never grows.
 *
 * a: A, n x k to m x k. b: the preconditioner B, m x k to n x k; linear. rightSide: m x k. weights:
 * m, >= 0, of the rows in every norm. Throws Aborted.
 */
GmresResult SolveGmres(const LinearMap& a, const LinearMap& b, const Eigen::MatrixXd& rightSide,
  const Eigen::VectorXd& weights, const GmresOptions& options = {}, const Progress& progress = {});

} // namespace shape
