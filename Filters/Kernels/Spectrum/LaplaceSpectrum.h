#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// The smallest eigenvalues of the Laplacian of a surface, and its eigenfunctions.
struct LaplaceSpectrum
{
  Eigen::VectorXd Eigenvalues;    ///< k: >= 0, ascending, in 1 / length^2
  Eigen::MatrixXd Eigenfunctions; ///< n x k: orthonormal in the masses; 0 where no triangle is
  Eigen::VectorXd Masses;         ///< n: a third of the area of the triangles around each point
};

/**
 * The solutions of L f = lambda M f with the least lambda, for the cotangent weights L and the
 * lumped masses M of the intrinsic Delaunay triangulation (BuildIntrinsicDelaunay), so that no
 * weight is negative. On a border the derivative across it is 0.
 *
 * Of each component alone, so that each eigenfunction lives on one, the first of each a constant:
 * FindExtremeEigenpairs on (L + s M)^-1, which one sparse factorisation applies to many columns at
 * a time; where there are few points, all eigenpairs by a dense decomposition. An eigenfunction's
 * value of the largest size is positive. The number of threads changes it by rounding only.
 *
 * mesh: a consistently oriented 2-manifold, open or closed. pairs: in [1, the number of points that
 * triangles use]. tolerance: of the residuals, over the eigenvalues of (L + s M)^-1. Throws
 * InvalidInput where not, SolveFailure where an iteration does not end, Aborted.
 */
LaplaceSpectrum SolveLaplaceEigenproblem(
  const Mesh& mesh, int pairs, const Progress& progress = {}, double tolerance = 1e-9);

} // namespace shape
