#pragma once

#include "Base/Progress.h"
#include "Linear/SparseSolve.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// A Dirichlet problem for a stiffness matrix. The matrix is factorised once and used for any
/// number of right sides.
class DirichletProblem
{
public:
  /// stiffness: n x n, symmetric positive semi-definite; it must outlive this object. fixed: the
  /// points with given values. Throws SolveFailure if the part of the matrix for the other points
  /// is not positive definite, and Aborted.
  DirichletProblem(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& fixed,
    const Progress& progress = {});

  /// values: n x d, given at the fixed points and 0 at the others. Sets the values at the other
  /// points so that stiffness * values = right holds at these points. Throws Aborted.
  void Solve(
    Eigen::MatrixXd& values, const Eigen::MatrixXd& right, const Progress& progress = {}) const;

private:
  const Eigen::SparseMatrix<double>& Stiffness;
  std::vector<int> Inner; ///< points that are not fixed
  SparseCholesky Solver;
};

} // namespace shape
