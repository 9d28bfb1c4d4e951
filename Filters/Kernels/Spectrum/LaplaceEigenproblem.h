#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The smallest eigenvalues of the Laplacian of a surface, and its eigenfunctions.
struct LaplaceEigenpairs
{
  Eigen::VectorXd Eigenvalues;    ///< k: >= 0, ascending, in 1 / length^2
  Eigen::MatrixXd Eigenfunctions; ///< n x k: orthonormal in the masses; 0 at unused points
  Eigen::VectorXd Masses;         ///< n: a third of the area of the triangles around each point
};

/**
 * The solutions of L f = lambda M f with the smallest lambda, for the stiffness L and the lumped
 * masses M of GetIntrinsicLaplacian, so that no weight is negative. On a boundary the derivative
 * across it is 0.
 *
 * Each component is solved alone, so that each eigenfunction lives on one, the first of each a
 * constant: FindExtremeEigenpairs on (L + s M)^-1, which one sparse factorisation applies to many
 * columns at a time; if there are few points, all eigenpairs by a dense decomposition. An
 * eigenfunction's value of largest magnitude is positive. The number of threads changes it by
 * rounding only.
 *
 * surface: a consistently oriented 2-manifold, open or closed. pairs: in [1, the number of points
 * that triangles use]. tolerance: of the residuals, over the eigenvalues of (L + s M)^-1. Throws
 * InvalidInput if not, SolveFailure if an iteration does not converge, Aborted.
 */
LaplaceEigenpairs SolveLaplaceEigenproblem(
  const Surface& surface, int pairs, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
