#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The smallest eigenvalues of the Laplacian of a surface, and their eigenfunctions.
struct LaplaceEigenpairs
{
  Eigen::VectorXd Eigenvalues;    ///< k values, each >= 0, ascending, in 1 / length^2
  Eigen::MatrixXd Eigenfunctions; ///< n x k, orthonormal with weights Masses; 0 at unused points
  Eigen::VectorXd Masses;         ///< n values: a third of the triangle area around each point
};

/**
 * Solves L f = lambda M f for the smallest eigenvalues lambda, with the stiffness L and the lumped
 * masses M of GetIntrinsicLaplacian, whose edge weights are not negative. On a boundary the normal
 * derivative is 0.
 *
 * Each component is solved separately. So each eigenfunction is nonzero on one component only, and
 * the first eigenfunction of each component is constant there. FindExtremeEigenpairs is applied to
 * (L + s M)^-1, by one sparse factorisation, where s is 1 / the component's area. If there are few
 * points, a dense decomposition is used instead. An eigenfunction's value of largest magnitude is
 * positive. With another number of threads, the result differs only by rounding.
 *
 * surface: triangles (RequireTriangles). pairs: number of eigenpairs, from 1
 * to the number of points that triangles use. tolerance: maximum residual of a pair, divided by its
 * eigenvalue of (L + s M)^-1. Throws InvalidInput if `pairs` is out of range, SolveFailure if an
 * iteration does not converge, and Aborted.
 */
LaplaceEigenpairs SolveLaplaceEigenproblem(
  const Surface& surface, int pairs, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
