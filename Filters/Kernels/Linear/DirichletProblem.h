#pragma once

#include "Linear/SparseSolve.h"

#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// A Dirichlet problem for a stiffness matrix, factorised once.
class DirichletProblem
{
public:
  /// stiffness: n x n, symmetric positive semi-definite, kept by reference. fixed: points with
  /// given values. Throws SolveFailure if the matrix of the other points is not positive definite.
  DirichletProblem(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& fixed);

  /// Completes `values` (n x d), given at the fixed points and 0 elsewhere, so that stiffness *
  /// values = right holds at the other points.
  void Solve(Eigen::MatrixXd& values, const Eigen::MatrixXd& right) const;

private:
  const Eigen::SparseMatrix<double>& Stiffness;
  std::vector<int> Inner; ///< points that are not fixed
  SparseCholesky Solver;
};

} // namespace shape
