#pragma once

#include "Base/Progress.h"

#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/**
 * Cholesky factorisation of sparse symmetric positive definite matrices with the same pattern. If
 * ShapeMap was built with CHOLMOD, the factorisation is supernodal, with CHOLMOD's elimination
 * order. It can be interrupted, also while the order is computed. Otherwise Eigen's method is used:
 * one library call that cannot be interrupted.
 */
class SparseCholesky
{
public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Factorises `a` (n x n, both triangular parts stored). The first call also computes the
  /// elimination order. Later calls reuse it, so their matrices must have the same pattern. Throws
  /// SolveFailure if `a` is not positive definite or its factor has 2^31 values or more,
  /// std::bad_alloc, and Aborted.
  void Factorize(const Eigen::SparseMatrix<double>& a, const Progress& progress = {});

  /// Returns the solution x (n x k) of a x = b. b: n x k. Throws Aborted.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& b, const Progress& progress = {}) const;

private:
  struct Factor;
  std::unique_ptr<Factor> Impl;
};

} // namespace shape
