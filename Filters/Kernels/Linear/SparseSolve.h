#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/**
 * Cholesky factorisation of sparse symmetric positive definite matrices that share one pattern:
 * CHOLMOD's supernodal one where ShapeMap was built with it, else Eigen's.
 *
 * Each call is one library call: it cannot be interrupted.
 */
class SparseCholesky
{
public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Factorises `a` (n x n, both triangles stored). The first call also finds the elimination
  /// order, which later calls keep: they must have the same pattern. Throws SolveFailure where `a`
  /// is not positive definite.
  void Factorize(const Eigen::SparseMatrix<double>& a);

  /// x with a x = b; b: n x k.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& b) const;

private:
  struct Factor;
  std::unique_ptr<Factor> Impl;
};

} // namespace shape
