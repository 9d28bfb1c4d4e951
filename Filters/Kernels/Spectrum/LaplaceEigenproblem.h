#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The smallest eigenvalues of the Laplacian of a surface, and their eigenfunctions.
struct LaplaceEigenpairs
{
  Eigen::VectorXd Eigenvalues;    ///< k: >= 0, ascending, in 1 / length^2
  Eigen::MatrixXd Eigenfunctions; ///< n x k: orthonormal with respect to Masses; 0 at unused points
  Eigen::VectorXd Masses;         ///< n: a third of the area of the triangles around each point
};

/**
 * Solves L f = lambda M f for the smallest eigenvalues lambda, with the stiffness L and the lumped
 * masses M of GetIntrinsicLaplacian, whose edge weights are not negative. On a boundary the normal
 * derivative is 0.
 *
 * Each component is solved separately, so each eigenfunction is nonzero on one component only, and
 * the first of each is constant. FindExtremeEigenpairs is applied to (L + s M)^-1; one sparse
 * factorisation solves for many columns at a time. If there are few points, a dense decomposition
 * computes all eigenpairs. An eigenfunction's value of largest magnitude is positive. The number of
 * threads changes the result by rounding only.
 *
 * surface: a consistently oriented 2-manifold, open or closed. pairs: in [1, number of points that
 * triangles use]. tolerance: of the residuals, relative to the eigenvalues of (L + s M)^-1. Throws
 * InvalidInput if `pairs` is out of range, SolveFailure if an iteration does not converge, and
 * Aborted.
 */
LaplaceEigenpairs SolveLaplaceEigenproblem(
  const Surface& surface, int pairs, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
