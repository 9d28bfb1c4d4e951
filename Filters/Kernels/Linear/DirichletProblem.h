#pragma once

#include "Linear/SparseSolve.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// The Dirichlet problem of a stiffness matrix, factorised once.
class DirichletProblem
{
public:
  /// stiffness: n x n, symmetric positive semi-definite, kept by reference. fixed: points whose
  /// values are given. Throws SolveFailure where the rest is not positive definite.
  DirichletProblem(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& fixed);

  /// Completes `values` (n x d), given at the fixed points and 0 elsewhere, so that inside
  /// stiffness values = right.
  void Solve(Eigen::MatrixXd& values, const Eigen::MatrixXd& right) const;

private:
  const Eigen::SparseMatrix<double>& Stiffness;
  std::vector<int> Inner; ///< points
  SparseCholesky Solver;
};

} // namespace shape
