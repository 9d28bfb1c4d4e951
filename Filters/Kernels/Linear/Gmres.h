#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

struct GmresOptions
{
  int MaximumIterations = 40; ///< >= 1
  /// Stops when the weighted root mean square residual of every column is at most this; >= 0.
  double Tolerance = 1e-8;
  /// Stops after three iterations in a row that each reduce every column's residual by less than
  /// this share; >= 0, < 1. Two such iterations suffice if all residuals are at most 4 times
  /// Tolerance.
  double LeastGain = 0.0;
  /// Returns the inner product of each two columns, for rows that are distributed over processes.
  /// Empty: the mean of the products, by the weights of the rows.
  std::function<Eigen::RowVectorXd(const Eigen::MatrixXd& u, const Eigen::MatrixXd& v)> Inner;
  /// Called before each iteration, if given, with the share of the residual that is left. In this
  /// iteration an error of A counts by this share, so A may have more of it (Simoncini and Szyld,
  /// "Theory of inexact Krylov subspace methods", 2003).
  std::function<void(double left)> Relax;
};

struct GmresResult
{
  Eigen::MatrixXd Solution;
  Eigen::MatrixXd Left;         ///< residual b - A x
  Eigen::RowVectorXd Residuals; ///< weighted root mean square residual of each column
  int Iterations = 0;
};

/// A linear map applied to each column of a matrix. It may report its progress.
using LinearMap = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&, const Progress&)>;

/**
 * Solves A x = b by GMRES with right preconditioning (Saad and Schultz 1986): each iteration
 * minimises |b - A x| over a larger space. A need not be square. For least squares, the
 * preconditioner B has the shape of A's transpose (Hayami, Yin and Ito, "GMRES methods for least
 * squares problems", 2010, AB-GMRES). A and B are applied to all columns of b together, but each
 * column has its own Krylov space. No residual ever increases.
 *
 * a: applies A to n x k values, giving m x k. b: applies the preconditioner B to m x k values,
 * giving n x k. rightSide: the right side b of the equation, m x k. weights: the weights of the
 * rows in all norms, m values, each >= 0; not used if options.Inner is given. Throws Aborted.
 */
GmresResult SolveGmres(const LinearMap& a, const LinearMap& b, const Eigen::MatrixXd& rightSide,
  const Eigen::VectorXd& weights, const GmresOptions& options = {}, const Progress& progress = {});

} // namespace shape
