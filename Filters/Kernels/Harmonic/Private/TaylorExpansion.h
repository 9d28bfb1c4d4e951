#pragma once

#include "Harmonic/Private/TaylorSums.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The Taylor polynomials of the three potentials of point charges around a centre, in Cartesian
 * coordinates, and bounds of what they leave out.
 *
 * The nth directional derivative of 1/r along a unit vector is n! P_n(cos) / r^(n+1), with
 * Legendre's polynomial |P_n| <= 1. A symmetric form takes its norm on equal arguments (Banach), so
 * the norm of the nth derivative is n! / r^(n+1). For a charge q at distance r from the centre, the
 * gradient of the polynomial of degree p therefore differs from that of the potential by at most
 *
 *   |q| / (4 pi r^2) sum_{n >= p} (n + 1) t^n = |q| / (4 pi r^2) t^p (p + 1 - p t) / (1 - t)^2
 *
 * at all positions nearer to the centre than t r, t < 1.
 */
struct TaylorExpansion
{
  static constexpr int Degree = 8;
  static constexpr int Size = (Degree + 1) * (Degree + 2) * (Degree + 3) / 6;
  static_assert((Degree + 1) * (Degree + 1) == TaylorSums::MaximumSize);

  static constexpr int LowDegree = 4;

  /// Row i: the coefficients of monomial i (GetMonomials) for the three components of the map.
  Eigen::Matrix<double, Size, 3> Coefficients = Eigen::Matrix<double, Size, 3>::Zero();
  /// For each component, a bound of the error of its gradient (Euclidean norm).
  Eigen::Vector3d Remainder = Eigen::Vector3d::Zero();
  /// For each component, the sum of |q| / (4 pi r^2 (1 - t)^2), which bounds the gradient and the
  /// sum of the magnitudes of its terms.
  Eigen::Vector3d Magnitude = Eigen::Vector3d::Zero();
  /// Rounding errors of the gradient are at most this times the Magnitude. The recurrence amplifies
  /// errors by at most (1 + sqrt(2))^Degree = 1200, and Laplace's equation by 2^(Degree / 2) = 16.
  /// With 500 operations for a coefficient, and a million charges in a sum, the errors stay below
  /// 4e-9.
  static constexpr double Rounding = 1e-8;

  /// Monomial i is x^X y^Y z^Z; monomials are sorted by degree. The first four are 1, x, y, z.
  struct Monomial
  {
    int Powers[3];
    int Degree;
  };
  static const std::vector<Monomial>& GetMonomials();
  static constexpr int SizeOf(int degree) { return (degree + 1) * (degree + 2) * (degree + 3) / 6; }

  /**
   * Adds the polynomials of some charges, up to the given degree <= Degree. The recurrence for the
   * coefficients is that of Duan and Krasny, "An adaptive treecode for computing nonbonded
   * potential energy in classical molecular systems" (2001). It computes those with a power of z
   * below 2; the sums are harmonic, which determines the others.
   *
   * ids: the charges that are added. radius: where the bound of the error holds; each of these
   * charges is farther than this from the centre.
   */
  void Add(const ChargeColumns& charges, const std::vector<int>& ids, const Eigen::Vector3d& centre,
    double radius, int degree);

  /// Moves the centre by `step`. The polynomials stay the same functions.
  void Shift(const Eigen::Vector3d& step);

  /// Returns the terms of LowDegree and less around a centre that is `step` away, and the bounds.
  TaylorExpansion GetLowTerms(const Eigen::Vector3d& step) const;

  /// For each entry of the Jacobian (rows are components), bounds the sum of its absolute
  /// derivatives of order LowDegree, divided by LowDegree!, in the cube around the centre, of edge
  /// 2 half. The product with the power LowDegree of half the edge of a smaller cube bounds what
  /// its low terms leave out there.
  Eigen::Matrix3d BoundHighTerms(double half) const;
};

} // namespace shape
