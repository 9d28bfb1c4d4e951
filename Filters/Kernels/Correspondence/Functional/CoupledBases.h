#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalMatrix.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <Eigen/Core>

namespace shape
{

struct CoupledBasesOptions
{
  int Size = 20;       ///< k: functions of each basis; >= 1
  double Weight = 1.0; ///< mu: how strongly corresponding functions get equal coefficients; >= 0
  int MaximumIterations = 1000; ///< >= 0
};

/// Two bases in which corresponding functions have nearly equal coefficients.
struct CoupledBases
{
  ///@{
  /// k x k, orthogonal: the basis functions in the first k eigenfunctions.
  Eigen::MatrixXd RotationOfA, RotationOfB;
  ///@}
};

/**
 * The energy of two bases Phi_A X and Phi_B Y, where Phi are eigenfunctions (Kovnatsky, Bronstein,
 * Bronstein, Glashoff and Kimmel, "Coupled quasi-harmonic bases", 2013, section 4):
 *
 *   E(X, Y) = off(X' L_A X) + off(Y' L_B Y) + mu |F' X - G' Y|^2
 *
 * off is the sum of the squared entries off the diagonal. L are diagonal matrices of the first k
 * eigenvalues, times the surface's area, and divided by the larger one of both k-th values, so that
 * they are dimensionless. F and G (k x q) are the coefficients of corresponding functions, each of
 * norm 1, divided by the root of q. The paper lets the bases leave the first k eigenfunctions. Few
 * corresponding functions do not determine such bases, so X and Y are square here.
 */
class CoupledBasesEnergy
{
public:
  /// functionsOfA, functionsOfB: n_A x q, n_B x q; their columns correspond. Throws InvalidInput if
  /// Size exceeds the number of eigenpairs, if there are no functions, or if an option is out of
  /// its range.
  CoupledBasesEnergy(const LaplaceEigenpairs& a, const Eigen::MatrixXd& functionsOfA,
    const LaplaceEigenpairs& b, const Eigen::MatrixXd& functionsOfB,
    const CoupledBasesOptions& options);

  double Value(const CoupledBases& bases) const;
  /// The derivatives by all entries, without the condition of orthonormal columns.
  CoupledBases Gradient(const CoupledBases& bases) const;
  /// The first k eigenfunctions of A, and the rotation of those of B that brings the corresponding
  /// functions nearest to each other.
  CoupledBases Start() const;

private:
  Eigen::VectorXd ValuesOfA, ValuesOfB;
  Eigen::MatrixXd OfA, OfB; ///< F and G
  double Weight;
  int Size;
};

/**
 * Computes bases in which the functional map of a correspondence is nearly diagonal, from functions
 * that are known to correspond. They minimise CoupledBasesEnergy from its Start, by conjugate
 * gradients on orthogonal matrices, whose retraction is the polar factor. The result depends
 * neither on the sizes of the surfaces nor on the signs of the eigenfunctions of B.
 *
 * Throws InvalidInput as the energy does, and Aborted.
 */
CoupledBases ComputeCoupledBases(const LaplaceEigenpairs& a, const Eigen::MatrixXd& functionsOfA,
  const LaplaceEigenpairs& b, const Eigen::MatrixXd& functionsOfB,
  const CoupledBasesOptions& options = {}, const Progress& progress = {});

/// Coupled bases on the points of both surfaces.
struct CoupledFunctions
{
  ///@{
  /// n_A x k, n_B x k, orthonormal with the masses of the surface.
  Eigen::MatrixXd OfA, OfB;
  ///@}
  double DiagonalShare = 0.0; ///< ComputeDiagonalShare
};

/// The share of the squared entries of Y' C X that is on the diagonal: 1 if the map with the matrix
/// C (of ComputeFunctionalMatrix, with k or more rows and columns) is diagonal in the bases.
double ComputeDiagonalShare(const Eigen::MatrixXd& map, const CoupledBases& bases);

/// Computes coupled bases from the eigenfunctions of a map's matrix. The corresponding functions
/// are those of ComputeLandmarkKernels and the given ones, n_A x q and n_B x q. Throws as
/// ComputeCoupledBases.
CoupledFunctions CoupleEigenfunctions(const FunctionalMatrix& map, const Landmarks& landmarks,
  const Eigen::MatrixXd& givenOfA, const Eigen::MatrixXd& givenOfB,
  const CoupledBasesOptions& options = {}, const Progress& progress = {});

} // namespace shape
