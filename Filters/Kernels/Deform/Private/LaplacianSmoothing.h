#pragma once

#include "Deform/Private/NodeDeformation.h"
#include "Linear/DirichletProblem.h"

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace shape
{

/// The Laplacian of a graph (n x n) whose links weigh 1 / length: positions is n x 3, and a link is
/// a pair of different nodes at different positions, listed once.
Eigen::SparseMatrix<double> BuildGraphLaplacian(
  const Eigen::MatrixXd& positions, const std::vector<std::pair<int, int>>& links);

/**
 * Spreads the distortion of a deformation evenly (Fig. 16): the positions that solve equation 3
 * with the Laplacian vectors of the shape at rest, each turned as the deformation turns there, and
 * with the sources fixed. A rigid motion stays as it is.
 *
 * Links weigh 1 / length. Each edge vector is turned by the mean of the rotations at both ends.
 * This differs from the turned Laplacian vector where the rotations differ, and makes the matrix
 * symmetric.
 */
class LaplacianSmoothing
{
public:
  /// Factorises the matrix: one library call that cannot be interrupted.
  explicit LaplacianSmoothing(const NodeProblem& problem);
  LaplacianSmoothing(const LaplacianSmoothing&) = delete;
  LaplacianSmoothing& operator=(const LaplacianSmoothing&) = delete;

  /// Moves the nodes that are no sources.
  void Apply(NodeTransforms& motions) const;

private:
  Eigen::MatrixXd Positions;
  Eigen::VectorXd Scales;
  std::vector<std::pair<int, int>> Links;
  Eigen::SparseMatrix<double> Laplacian;
  DirichletProblem Problem; ///< which refers to the Laplacian
};

} // namespace shape
