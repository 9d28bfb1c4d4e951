#pragma once

#include "Base/Progress.h"
#include "Deform/Private/NodeDeformation.h"
#include "Linear/DirichletProblem.h"

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace shape
{

/// Builds the Laplacian of a graph (n x n) whose links have the weight 1 / length. positions: n x
/// 3. links: pairs of distinct nodes at different positions, each listed once.
Eigen::SparseMatrix<double> BuildGraphLaplacian(
  const Eigen::MatrixXd& positions, const std::vector<std::pair<int, int>>& links);

/**
 * Spreads the distortion of a deformation evenly (Fig. 16). The result solves equation 3 with fixed
 * sources. Its Laplacian vectors are those of the shape at rest, each rotated like its node. A
 * rigid motion is not changed.
 *
 * Links have the weight 1 / length. Each edge vector is rotated by the mean of the rotations at
 * both ends. This makes the system symmetric. The sum of these edge vectors differs from the
 * rotated Laplacian vector only if the rotations of a node and its neighbours differ.
 */
class LaplacianSmoothing
{
public:
  /// Factorises the matrix. Throws Aborted.
  LaplacianSmoothing(const NodeProblem& problem, const Progress& progress);
  LaplacianSmoothing(const LaplacianSmoothing&) = delete;
  LaplacianSmoothing& operator=(const LaplacianSmoothing&) = delete;

  /// Moves the nodes that are not sources.
  void Apply(NodeTransforms& motions) const;

private:
  Eigen::MatrixXd Positions;
  Eigen::VectorXd Scales;
  std::vector<std::pair<int, int>> Links;
  Eigen::SparseMatrix<double> Laplacian;
  DirichletProblem Problem; ///< refers to the Laplacian
};

} // namespace shape
