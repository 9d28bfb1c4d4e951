#pragma once

#include "Deform/Private/NodeDeformation.h"
#include "Linear/SparseSolve.h"

#include <utility>
#include <vector>

namespace shape
{

/**
 * Spreads the distortion of a deformation evenly (Fig. 16): the places that solve equation 3 with
 * the Laplacian vectors of the shape at rest, each turned as the deformation turns there, and the
 * sources where they are. A rigid motion stays as it is.
 *
 * Links weigh 1 / length. Each way between neighbours is turned by the mean of both rotations,
 * which differs from the turned Laplacian vector where they differ, and makes the matrix symmetric.
 */
class LaplacianSmoothing
{
public:
  /// Factorises the matrix: one library call that cannot be interrupted.
  explicit LaplacianSmoothing(const NodeProblem& problem);

  /// Moves the nodes that are no sources.
  void Apply(NodeTransforms& motions) const;

private:
  Eigen::MatrixXd Positions;
  Eigen::VectorXd Scales;
  std::vector<std::pair<int, int>> Links;
  std::vector<int> Unknown; ///< row of each node, or -1 at sources
  int Count = 0;
  SparseCholesky Factor;
};

} // namespace shape
