#pragma once

#include <Eigen/Core>

#include <array>

namespace shape
{

/**
 * A tetrahedron beside the one that it should look like: the affine map between them has the
 * Jacobian J = sum over corners of x_v Gradients_v^T.
 */
struct ReferenceSimplex
{
  std::array<int, 4> Corners;
  Eigen::Matrix<double, 4, 3> Gradients; ///< of the corners' hat functions on the reference
};

/// The four gradients for a reference with the edges `edges` (columns) from its first corner.
Eigen::Matrix<double, 4, 3> ComputeHatGradients(const Eigen::Matrix3d& edges);

/**
 * The regularised elliptic energy of a Jacobian J with determinant D (Garanzha, Kaporin,
 * Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps in 50 lines of code", 2021, eqs. 1
 * to 3):
 *
 *   (1 - t) |J|^2 / (3 chi^(2/3)) + t (D^2 + 1) / (2 chi),  chi = (D + sqrt(D^2 + epsilon^2)) / 2
 *
 * with t = VolumeShare: 1, the minimum, for a rotation. Finite for every J while epsilon > 0; as
 * epsilon falls it becomes a barrier at D = 0.
 */
class EllipticEnergy
{
public:
  static constexpr double VolumeShare = 0.1;

  /// The stand-in for the determinant; positive where epsilon is.
  static double Chi(double determinant, double epsilon);

  /// The epsilon at which Chi(determinant, epsilon) = chi; `minimum` where none is greater.
  static double EpsilonFor(double determinant, double chi, double minimum);

  EllipticEnergy(const Eigen::Matrix3d& jacobian, double epsilon);

  double Value() const;
  double Determinant() const { return this->D; }

  /// The derivative by J.
  Eigen::Matrix3d Gradient() const;

  /**
   * A positive semi-definite part of the second derivative, in which D as a function of J and chi
   * as a function of D are taken as linear: the energy is convex in J, D and chi together. It is
   * Identity * I + Mixed (j c^T + c j^T) + Rank * c c^T with j and c the entries of J and of its
   * cofactors.
   */
  struct Curvature
  {
    double Identity, Mixed, Rank;
  };
  Curvature SecondDerivative() const;

  const Eigen::Matrix3d& Jacobian() const { return this->J; }
  const Eigen::Matrix3d& Cofactors() const { return this->C; }

private:
  Eigen::Matrix3d J, C;
  double D, X, Slope, Power; ///< determinant, chi, its derivative, chi^(-2/3)
};

} // namespace shape
