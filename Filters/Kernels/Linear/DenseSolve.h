#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The singular value decomposition A = U diag(S) V^T of a dense matrix. Solve returns the
 * minimum-norm least-squares solution without the smallest singular values.
 *
 * A QR factorisation reduces A to a triangular factor, which LAPACK's gesdd decomposes. If A is
 * wide, A^T is used. The singular vectors along the longer side are never formed. For a matrix with
 * twice as many rows as columns, this saves two fifths of gesdd's work and two thirds of its
 * memory.
 */
class SingularValues
{
public:
  /// A: m x n, min(m, n) <= 23000. Throws SolveFailure if the decomposition does not converge,
  /// InvalidInput if A is empty or not finite, std::bad_alloc, and Aborted.
  explicit SingularValues(Eigen::MatrixXd a, const Progress& progress = {});

  /// Returns V diag(1/S) U^T b (n x k), restricted to the singular values >= threshold. b: m x k.
  Eigen::MatrixXd Solve(
    const Eigen::MatrixXd& b, double threshold, const Progress& progress = {}) const;

  /// Returns the number of singular values >= threshold.
  int Rank(double threshold) const;

  /// min(m, n) singular values, descending
  const Eigen::VectorXd& Values() const { return this->S; }

  /// Returns the right singular vectors without the first `first`, one per column: n x (min(m, n) -
  /// first).
  Eigen::MatrixXd RightVectors(int first, const Progress& progress = {}) const;

private:
  /// Computes Q b, or Q^T b, in place; b has as many rows as the longer side.
  void ApplyQ(Eigen::MatrixXd& b, bool transposed, const Progress& progress) const;

  bool Wide = false;          ///< whether A^T was factorised
  Eigen::MatrixXd Reflectors; ///< Householder reflectors of Q: longer side x shorter side
  Eigen::VectorXd Factors;    ///< factors of the reflectors
  Eigen::MatrixXd U, Vt;      ///< singular vectors of the triangular factor
  Eigen::VectorXd S;
};

} // namespace shape
