#pragma once

#include "Base/Progress.h"
#include "Harmonic/Private/HatFunctions.h"
#include "Linear/DirichletProblem.h"
#include "Linear/SparseSolve.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// A solid filled with tetrahedra.
struct FilledSolid
{
  Eigen::MatrixXd Points;     ///< n x 3
  Eigen::MatrixXi Tetrahedra; ///< m x 4, of positive volume
  std::vector<int> Boundary;  ///< the points on the boundary, k
};

/// The energy of a Jacobian, and its derivative.
struct JacobianEnergy
{
  double Value;
  Eigen::Matrix3d Gradient;
};

/// Returns the symmetric Dirichlet energy |J|^2 + |J^-1|^2; infinite if det J <= 0.
JacobianEnergy SymmetricDirichlet(const Eigen::Matrix3d& jacobian);

/**
 * The mean distortion of the harmonic map of a solid, as a function of the images of its boundary's
 * points. The map is linear in them, by linear finite elements.
 *
 * With K the stiffness matrix, B the boundary's points and I the others, the map is
 * x_I = -K_II^-1 K_IB x_B. The gradient by the images is g_B - K_BI K_II^-1 g_I, with the gradient
 * g of the energy by all points: one more solve with the same factorised matrix, which is its own
 * transpose. This is the adjoint method (Giles and Pierce, "An introduction to the adjoint approach
 * to design", Flow, Turbulence and Combustion 65, 2000).
 */
class HarmonicDistortion
{
public:
  using EnergyFunction = JacobianEnergy (*)(const Eigen::Matrix3d& jacobian);

  /// Throws SolveFailure if tetrahedra are so flat that K_II cannot be factorised; Aborted.
  explicit HarmonicDistortion(FilledSolid solid, const Progress& progress = {});
  HarmonicDistortion(const HarmonicDistortion&) = delete;
  HarmonicDistortion& operator=(const HarmonicDistortion&) = delete;

  /// Returns the images of all points (n x 3). images: k x 3, those of the boundary's points.
  Eigen::MatrixXd Map(const Eigen::MatrixXd& images) const;

  /// Returns how many tetrahedra a map (n x 3) inverts: det J <= 0.
  int CountInverted(const Eigen::MatrixXd& map) const;

  /// Returns the mean energy of the map over the solid, and sets its gradient by the images (each k
  /// x 3). The gradient has no meaning if the energy is infinite.
  double Evaluate(
    const Eigen::MatrixXd& images, EnergyFunction function, Eigen::MatrixXd& gradient) const;

  const FilledSolid& Solid() const { return this->Filled; }
  const Eigen::SparseMatrix<double>& Stiffness() const { return this->Matrix; } ///< K
  Eigen::VectorXd PointVolumes() const; ///< n: a quarter of the tetrahedra's volumes around a point
  double Volume() const;                ///< of the solid

  /// Returns values at the boundary points (k x d), and 0 at the others (n x d).
  Eigen::MatrixXd Spread(const Eigen::MatrixXd& values) const;

private:
  Eigen::Matrix3d Jacobian(Eigen::Index t, const Eigen::MatrixXd& map) const;

  FilledSolid Filled;
  std::vector<HatFunctions> Hats; ///< of each tetrahedron
  Eigen::SparseMatrix<double> Matrix;
  DirichletProblem Inner;
};

/// The Schur complement of a K + D on the boundary's points: an approximate Hessian of a function
/// of their images.
class BoundaryHessian
{
public:
  /// factor: a > 0. diagonal: n, D >= 0 and not 0 everywhere. distortion must outlive this object.
  /// Throws SolveFailure if the matrix cannot be factorised; Aborted.
  BoundaryHessian(const HarmonicDistortion& distortion, double factor,
    const Eigen::VectorXd& diagonal, const Progress& progress = {});

  /// Returns the product of the inverse and a gradient (k x 3).
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& gradient) const;

private:
  const HarmonicDistortion& Distortion;
  SparseCholesky Factor;
};

} // namespace shape
