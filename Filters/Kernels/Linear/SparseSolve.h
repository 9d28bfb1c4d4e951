#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/**
 * Cholesky factorisation of sparse symmetric positive definite matrices with the same pattern. It
 * uses CHOLMOD's supernodal method if ShapeMap was built with CHOLMOD, else Eigen's method.
 *
 * Each call is one library call that cannot be interrupted.
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
  /// SolveFailure if `a` is not positive definite.
  void Factorize(const Eigen::SparseMatrix<double>& a);

  /// Returns the solution x (n x k) of a x = b. b: n x k.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& b) const;

private:
  struct Factor;
  std::unique_ptr<Factor> Impl;
};

} // namespace shape
