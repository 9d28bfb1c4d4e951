#include "Harmonic/Private/DeterminantSign.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace shape
{
namespace
{

/// Whether a symmetric matrix is positive definite; if so, its determinant, else 0.
double DeterminantIfPositive(const Eigen::Matrix3d& m)
{
  const double minor = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
  const double determinant = m.determinant();
  return m(0, 0) > 0.0 && minor > 0.0 && determinant > 0.0 ? determinant : 0.0;
}

} // namespace

DeterminantSign BoundDeterminant(
  const TaylorExpansion& expansion, double half, int degree, const Eigen::Matrix3d& leftOut)
{
  const auto& monomials = TaylorExpansion::GetMonomials();
  const Eigen::Matrix3d jacobian = expansion.Coefficients.middleRows<3>(1).transpose();
  // The derivatives at four corners, of which the others are the negatives: rows are components.
  std::array<Eigen::Matrix3d, 4> slopes;
  constexpr double corners[4][3] = { { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } };
  for (int corner = 0; corner < 4; ++corner)
  {
    slopes[corner].setZero();
    for (int i = TaylorExpansion::SizeOf(1); i < TaylorExpansion::SizeOf(2); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto& powers = monomials[i].Powers;
        if (powers[axis] > 0)
        {
          // d/dx of x^2 is 2 x, of x y it is y.
          const int other = powers[axis] == 2 ? axis
            : powers[(axis + 1) % 3] == 1     ? (axis + 1) % 3
                                              : (axis + 2) % 3;
          slopes[corner].col(axis) += powers[axis] * half * corners[corner][other] *
            expansion.Coefficients.row(i).transpose();
        }
      }
    }
  }
  DeterminantSign verdict;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double sign = corner < 4 ? 1.0 : -1.0;
    const double determinant = (jacobian + sign * slopes[corner % 4]).determinant();
    if (determinant < verdict.Estimate)
    {
      verdict.Estimate = determinant;
      verdict.Lowest = sign * half * Eigen::Vector3d(corners[corner % 4]);
    }
  }
  // Bounds of what is left out, for each entry of the derivative.
  Eigen::Matrix3d rest = leftOut;
  rest += (expansion.Remainder + TaylorExpansion::Rounding * expansion.Magnitude).replicate<1, 3>();
  double scale = half;
  for (int i = TaylorExpansion::SizeOf(2), n = 2; i < TaylorExpansion::SizeOf(degree); ++i)
  {
    if (monomials[i].Degree > n + 1)
    {
      ++n;
      scale *= half;
    }
    const double power = scale * half;
    for (int axis = 0; axis < 3; ++axis)
    {
      rest.col(axis) +=
        monomials[i].Powers[axis] * power * expansion.Coefficients.row(i).cwiseAbs().transpose();
    }
  }
  const Eigen::Matrix3d inverse = jacobian.inverse();
  if (!inverse.allFinite() || !rest.allFinite())
  {
    return verdict;
  }
  // The sign of det M is certain, because its rounding error is smaller.
  constexpr double rounding = 1e-14;
  const double determinant = inverse.determinant();
  const double size = inverse.rowwise().norm().prod();
  if (!(std::abs(determinant) > rounding * size))
  {
    return verdict;
  }
  Eigen::Matrix3d largest = jacobian.cwiseAbs();
  for (const Eigen::Matrix3d& slope : slopes)
  {
    largest = largest.cwiseMax(jacobian.cwiseAbs() + slope.cwiseAbs());
  }
  const Eigen::Matrix3d error = inverse.cwiseAbs() * (rest + rounding * largest);
  const double norm = (1.0 + rounding) * 0.5 * (error + error.transpose()).norm() + rounding;
  double minimum = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner)
  {
    const double sign = corner < 4 ? 1.0 : -1.0;
    const Eigen::Matrix3d product = inverse * (jacobian + sign * slopes[corner % 4]);
    Eigen::Matrix3d symmetric = 0.5 * (product + product.transpose());
    symmetric.diagonal().array() -= norm;
    minimum = std::min(minimum, DeterminantIfPositive(symmetric));
  }
  if (minimum > 0.0)
  {
    verdict.Sign = determinant > 0.0 ? 1 : -1;
    verdict.Bound = (1.0 - 1e-12) * minimum / std::abs(determinant);
  }
  return verdict;
}

} // namespace shape
