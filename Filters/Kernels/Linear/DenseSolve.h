#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * The singular value decomposition A = U diag(S) V^T of a dense matrix, and the least-squares,
 * least-norm solution that leaves out the smallest singular values.
 *
 * A QR factorisation along the longer side, then LAPACK's gesdd of the triangle: the vectors along
 * the longer side are never formed, which for a matrix twice as long as wide saves two fifths of
 * gesdd's own work and two thirds of its memory. Two library calls that cannot be interrupted.
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

  const Eigen::VectorXd& Values() const { return this->S; } ///< min(m, n), falling

  /// The right singular vectors from the `first` on, one a column: n x (min(m, n) - first).
  Eigen::MatrixXd RightVectors(int first) const;

private:
  /// Q b, or Q^T b, in place; b has as many rows as the longer side.
  void ApplyQ(Eigen::MatrixXd& b, bool transposed) const;

  bool Wide = false;          ///< A^T was factorised
  Eigen::MatrixXd Reflectors; ///< of Q, longer x shorter side
  Eigen::VectorXd Factors;    ///< of the reflectors
  Eigen::MatrixXd U, Vt;      ///< of the triangle
  Eigen::VectorXd S;
};

} // namespace shape
