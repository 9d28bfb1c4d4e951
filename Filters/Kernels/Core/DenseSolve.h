#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * The singular value decomposition A = U diag(S) V^T of a dense matrix (LAPACK's gesdd), and the
 * least-squares, least-norm solution that leaves out the smallest singular values.
 *
 * One library call: it cannot be interrupted.
 */
class SingularValues
{
public:
  /// A: m x n, min(m, n) <= 23000. Throws std::bad_alloc, SolveFailure where the decomposition does
  /// not converge, InvalidInput where A is empty or not finite.
  explicit SingularValues(Eigen::MatrixXd a);

  /// x (n x k) = V diag(1/S) U^T b over the singular values >= threshold; b: m x k.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& b, double threshold) const;

  /// How many singular values are >= threshold.
  int Rank(double threshold) const;

  const Eigen::VectorXd& Values() const { return this->S; }           ///< min(m, n), falling
  const Eigen::MatrixXd& RightTransposed() const { return this->Vt; } ///< min(m, n) x n: V^T

private:
  Eigen::MatrixXd U;
  Eigen::VectorXd S;
  Eigen::MatrixXd Vt;
};

} // namespace shape
