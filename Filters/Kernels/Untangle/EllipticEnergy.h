#pragma once

#include <Eigen/Core>

#include <array>

namespace shape
{

/**
 * A tetrahedron together with its reference shape. The affine map from the reference has the
 * Jacobian J = sum over corners of x_v Gradients_v^T.
 */
struct ReferenceSimplex
{
  std::array<int, 4> Corners;
  Eigen::Matrix<double, 4, 3> Gradients; ///< of the corners' hat functions on the reference
};

/// Returns the four gradients for the reference with the given edges (columns) at its first corner.
Eigen::Matrix<double, 4, 3> ComputeHatGradients(const Eigen::Matrix3d& edges);

/**
 * The regularised elliptic energy of a Jacobian J with determinant D (Garanzha, Kaporin,
 * Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps in 50 lines of code", 2021, eqs. 1
 * to 3):
 *
 *   (1 - t) |J|^2 / (3 chi^(2/3)) + t (D^2 + 1) / (2 chi),  chi = (D + sqrt(D^2 + epsilon^2)) / 2
 *
 * with t = VolumeShare. Its minimum is 1, for a rotation. It is finite for every J if epsilon > 0,
 * and tends to a barrier at D = 0 as epsilon tends to 0.
 */
class EllipticEnergy
{
public:
  static constexpr double VolumeShare = 0.1;

  /// Returns chi, the regularised determinant; positive if epsilon is.
  static double Chi(double determinant, double epsilon);

  /// Returns the epsilon for which Chi(determinant, epsilon) = chi, or `minimum` if that is
  /// greater.
  static double EpsilonFor(double determinant, double chi, double minimum);

  EllipticEnergy(const Eigen::Matrix3d& jacobian, double epsilon);

  double Value() const;
  double Determinant() const { return this->D; }

  /// Returns the derivative with respect to J.
  Eigen::Matrix3d Gradient() const;

  /**
   * A positive semi-definite part of the second derivative. It treats D as a linear function of J
   * and chi as a linear function of D, because the energy is convex in J, D and chi jointly. It is
   * Identity * I + Mixed (j c^T + c j^T) + Rank * c c^T, where j and c are the entries of J and of
   * its cofactor matrix.
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
  double D, X, Slope, Power; ///< determinant, chi, the derivative of chi, chi^(-2/3)
};

} // namespace shape
