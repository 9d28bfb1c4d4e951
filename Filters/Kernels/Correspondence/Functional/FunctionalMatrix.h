#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

/// A functional map as a matrix, with the bases of its coefficients.
struct FunctionalMatrix
{
  LaplaceEigenpairs OfA, OfB; ///< k eigenpairs of each surface, in its units
  /// k x k: coefficients of a function on A to those of its image on B. A row for each
  /// eigenfunction of B, a column for each one of A.
  Eigen::MatrixXd Matrix;
};

/**
 * Expresses a map in the bases of the first eigenfunctions of both surfaces (Ovsjanikov, Ben-Chen,
 * Solomon, Butscher and Guibas, "Functional maps: a flexible representation of maps between
 * shapes", 2012, section 4). A function f on A has the image f(map(x)) at the points x of B, which
 * is P f. The matrix is
 *
 *   C = Phi_B' M_B P Phi_A
 *
 * where P is the PullBack by the map, Phi_A and Phi_B are the Eigenfunctions, and M_B is the
 * diagonal matrix of the Masses of B. If the surfaces are isometric, C is orthogonal. If B is an
 * isometric copy with lengths multiplied by s, C is s times an orthogonal matrix, because
 * eigenfunctions are orthonormal in the units of their own surface.
 *
 * a, b: triangles (RequireTriangles). bToA: the image on A of each point of B. pairs: the number k,
 * from 1 to the number of points that triangles use, on both surfaces. Throws InvalidInput,
 * SolveFailure, Aborted.
 */
FunctionalMatrix ComputeFunctionalMatrix(const Surface& a, const Surface& b,
  const SurfacePoints& bToA, int pairs, const Progress& progress = {});

/// Returns the images on B of functions on A: Phi_B C Phi_A' M_A f. Of each function, only its
/// projection onto the eigenfunctions of A is transferred. functions: n_A x d. Returns n_B x d.
Eigen::MatrixXd TransferFunctions(const FunctionalMatrix& map, const Eigen::MatrixXd& functions);

} // namespace shape
