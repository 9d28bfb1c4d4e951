#pragma once

#include <Eigen/Core>

#include <array>

namespace shape
{

/**
 * A tetrahedron and the gradients on its reference shape. The affine map from the reference shape
 * has the Jacobian J = sum over corners v of x_v Gradients_v^T, where x_v is the position of corner
 * v.
 */
struct ReferenceSimplex
{
  std::array<int, 4> Corners;
  Eigen::Matrix<double, 4, 3> Gradients; ///< of each corner's hat function on the reference shape
};

/// Returns the gradients of the hat functions on a reference shape (ReferenceSimplex). edges
/// (columns): the edges from its first corner to the other three.
Eigen::Matrix<double, 4, 3> ComputeHatGradients(const Eigen::Matrix3d& edges);

/**
 * The regularised elliptic energy of a Jacobian J with determinant D (Garanzha, Kaporin,
 * Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps in 50 lines of code", 2021, eqs. 1
 * to 3):
 *
 *   (1 - t) |J|^2 / (3 chi^(2/3)) + t (D^2 + 1) / (2 chi),  chi = (D + sqrt(D^2 + epsilon^2)) / 2
 *
 * with t = VolumeShare. Its minimum for epsilon = 0 is 1, which rotations attain. If epsilon > 0,
 * it is finite for every J. As epsilon tends to 0, it tends to a barrier at D = 0.
 */
class EllipticEnergy
{
public:
  static constexpr double VolumeShare = 0.1;

  /// Returns chi, the regularised determinant. It is positive if epsilon is positive.
  static double Chi(double determinant, double epsilon);

  /// Returns the epsilon for which Chi(determinant, epsilon) = chi, or `minimum` if that is
  /// greater.
  static double EpsilonFor(double determinant, double chi, double minimum);

  EllipticEnergy(const Eigen::Matrix3d& jacobian, double epsilon);

  double Value() const;
  double Determinant() const { return this->D; }

  /// Returns the derivative of the energy with respect to J.
  Eigen::Matrix3d Gradient() const;

  /**
   * A positive semi-definite part of the second derivative. It treats D as a linear function of J,
   * and chi as a linear function of D. This part is positive semi-definite because the energy is
   * convex in J, D and chi jointly. It equals Identity * I + Mixed (j c^T + c j^T) + Rank * c c^T.
   * The vectors j and c hold the entries of J and of its cofactor matrix.
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
