#include "Harmonic/Private/DeterminantSign.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Terms of the Jacobian of this degree and less are bounded by their control matrices.
constexpr int ControlDegree = 3;
constexpr int ControlCount = ControlDegree + 1; ///< along each axis
constexpr int ControlTerms = TaylorExpansion::SizeOf(ControlDegree);
/// Relative to the magnitude of all terms: rounding errors of some 100 operations.
constexpr double Rounding = 3e-14;

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
using Symmetric = Eigen::Array<double, 6, 1>;

/// A monomial of the Jacobian, and of the map's monomials whose derivatives along the axes it is.
struct JacobianTerm
{
  std::array<int, 3> Powers;
  std::array<int, 3> Sources; ///< monomials of the map
};

struct DeterminantTables
{
  std::vector<JacobianTerm> Terms; ///< up to the degree TaylorExpansion::Degree - 1
  /// Entry (p, k): control value k of the power p on [-1, 1], in Bernstein's basis of
  /// ControlDegree.
  Eigen::Matrix<double, ControlCount, ControlCount> Controls;

  DeterminantTables()
  {
    const auto& monomials = TaylorExpansion::GetMonomials();
    for (int i = 0; i < TaylorExpansion::SizeOf(TaylorExpansion::Degree - 1); ++i)
    {
      JacobianTerm term;
      std::copy_n(monomials[i].Powers, 3, term.Powers.begin());
      for (int axis = 0; axis < 3; ++axis)
      {
        std::array<int, 3> raised = term.Powers;
        ++raised[axis];
        term.Sources[axis] = static_cast<int>(
          std::find_if(monomials.begin(), monomials.end(),
            [&](const auto& m) { return std::equal(raised.begin(), raised.end(), m.Powers); }) -
          monomials.begin());
      }
      this->Terms.push_back(term);
    }
    // The polar form of the power p at the arguments 1 (k times) and -1 (all others): the mean of
    // the products of p of them.
    for (int k = 0; k < ControlCount; ++k)
    {
      Eigen::Matrix<double, ControlCount, 1> products =
        Eigen::Matrix<double, ControlCount, 1>::Unit(0);
      for (int argument = 0; argument < ControlDegree; ++argument)
      {
        for (int p = argument + 1; p > 0; --p)
        {
          products(p) += (argument < k ? 1.0 : -1.0) * products(p - 1);
        }
      }
      double choices = 1.0;
      for (int p = 0; p < ControlCount; ++p)
      {
        this->Controls(p, k) = products(p) / choices;
        choices *= static_cast<double>(ControlDegree - p) / (p + 1.0);
      }
    }
  }
};

const DeterminantTables& GetDeterminantTables()
{
  static const DeterminantTables tables;
  return tables;
}

/// The coefficients of a monomial in the Jacobian: rows are components of the map.
Matrix3d CoefficientOf(const TaylorExpansion& expansion, const JacobianTerm& term)
{
  Matrix3d coefficient;
  for (int axis = 0; axis < 3; ++axis)
  {
    coefficient.col(axis) =
      (term.Powers[axis] + 1.0) * expansion.Coefficients.row(term.Sources[axis]).transpose();
  }
  return coefficient;
}

/// Whether a symmetric matrix is positive definite; if so, its determinant, else 0.
double DeterminantIfPositive(const Symmetric& m)
{
  const double minor = m(0) * m(1) - m(3) * m(3);
  const double determinant =
    m(2) * minor + m(4) * (m(3) * m(5) - m(4) * m(1)) - m(5) * (m(0) * m(5) - m(3) * m(4));
  return m(0) > 0.0 && minor > 0.0 && determinant > 0.0 ? determinant : 0.0;
}

/// Returns the lowest determinant of the control matrices minus `less` on the diagonal, or 0 if one
/// of them is not positive definite. terms: the coefficients on [-1, 1]^3.
double LowestControlDeterminant(
  const std::array<Symmetric, ControlTerms>& terms, const Vector3d& less)
{
  const auto& tables = GetDeterminantTables();
  constexpr int n = ControlCount;
  // Bernstein's basis for x, then for y, then for z.
  std::array<Symmetric, n * n * n> alongX, alongY;
  const auto at = [](int a, int b, int c) { return (a * n + b) * n + c; };
  alongX.fill(Symmetric::Zero());
  for (int i = 0; i < ControlTerms; ++i)
  {
    const auto& powers = tables.Terms[i].Powers;
    for (int x = 0; x < n; ++x)
    {
      alongX[at(x, powers[1], powers[2])] += tables.Controls(powers[0], x) * terms[i];
    }
  }
  alongY.fill(Symmetric::Zero());
  for (int x = 0; x < n; ++x)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int c = 0; c < n; ++c)
      {
        for (int b = 0; b + c < n; ++b)
        {
          alongY[at(x, y, c)] += tables.Controls(b, y) * alongX[at(x, b, c)];
        }
      }
    }
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (int xy = 0; xy < n * n && lowest > 0.0; ++xy)
  {
    for (int z = 0; z < n && lowest > 0.0; ++z)
    {
      Symmetric control = alongY[xy * n];
      for (int c = 1; c < n; ++c)
      {
        control += tables.Controls(c, z) * alongY[xy * n + c];
      }
      control.head<3>() -= less.array();
      lowest = std::min(lowest, DeterminantIfPositive(control));
    }
  }
  return lowest;
}

/// Sets the corner with the lowest determinant of the linear terms.
void FindLowestCorner(
  const TaylorExpansion& expansion, const Vector3d& half, DeterminantSign& verdict)
{
  const auto& tables = GetDeterminantTables();
  const Matrix3d middle = CoefficientOf(expansion, tables.Terms[0]);
  std::array<Matrix3d, 3> slopes;
  for (int axis = 0; axis < 3; ++axis)
  {
    slopes[axis] = half(axis) * CoefficientOf(expansion, tables.Terms[1 + axis]);
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3d sign;
    for (int axis = 0; axis < 3; ++axis)
    {
      sign(axis) = (corner >> axis & 1) != 0 ? 1.0 : -1.0;
    }
    const double determinant =
      (middle + sign(0) * slopes[0] + sign(1) * slopes[1] + sign(2) * slopes[2]).determinant();
    if (determinant < verdict.Estimate)
    {
      verdict.Estimate = determinant;
      verdict.Lowest = sign.cwiseProduct(half);
    }
  }
}

/// Whether the sign of a computed determinant is that of the matrix.
bool IsCertain(const Matrix3d& matrix, double determinant)
{
  return std::abs(determinant) > Rounding * matrix.rowwise().norm().prod();
}

} // namespace

DeterminantSign BoundDeterminant(
  const TaylorExpansion& expansion, const Vector3d& half, int degree, const Matrix3d& leftOut)
{
  DeterminantSign verdict;
  const auto& tables = GetDeterminantTables();
  const Matrix3d jacobian = CoefficientOf(expansion, tables.Terms[0]);
  // With the singular values S of J = U S V', the factors S^-1/2 U' and V S^-1/2. They need not be
  // accurate: all bounds are for the factors as they are.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> squares(jacobian.transpose() * jacobian);
  const Matrix3d right = squares.eigenvectors() *
    squares.eigenvalues().cwiseMax(0.0).array().pow(-0.25).matrix().asDiagonal();
  const Matrix3d left = (jacobian * right).inverse();
  const double leftDeterminant = left.determinant(), rightDeterminant = right.determinant();
  if (left.allFinite() && right.allFinite() && IsCertain(left, leftDeterminant) &&
    IsCertain(right, rightDeterminant))
  {
    const Matrix3d absoluteLeft = left.cwiseAbs(), absoluteRight = right.cwiseAbs();
    std::array<Symmetric, ControlTerms> terms;
    terms.fill(Symmetric::Zero());
    Matrix3d magnitude = Matrix3d::Zero(), rest = leftOut;
    // The largest magnitudes of powers in the box.
    Eigen::Matrix<double, 3, TaylorExpansion::Degree> powers;
    powers.col(0).setOnes();
    for (int p = 1; p < TaylorExpansion::Degree; ++p)
    {
      powers.col(p) = powers.col(p - 1).cwiseProduct(half);
    }
    for (int i = 0; i < TaylorExpansion::SizeOf(degree - 1); ++i)
    {
      const auto& term = tables.Terms[i];
      const Matrix3d coefficient = powers(0, term.Powers[0]) * powers(1, term.Powers[1]) *
        powers(2, term.Powers[2]) * CoefficientOf(expansion, term);
      if (i >= ControlTerms)
      {
        rest += coefficient.cwiseAbs();
        continue;
      }
      magnitude += coefficient.cwiseAbs();
      const Matrix3d product = left * coefficient * right;
      terms[i] << product(0, 0), product(1, 1), product(2, 2),
        0.5 * (product(0, 1) + product(1, 0)), 0.5 * (product(0, 2) + product(2, 0)),
        0.5 * (product(1, 2) + product(2, 1));
    }
    // A symmetric matrix with entries of at most e is at least minus the diagonal of the sums of
    // the rows of e.
    const Vector3d remainder =
      expansion.Remainder + TaylorExpansion::Rounding * expansion.Magnitude;
    const Matrix3d error = absoluteLeft * (rest + Rounding * magnitude) * absoluteRight +
      absoluteLeft * remainder * right.colwise().norm();
    const Vector3d less = (1.0 + Rounding) * 0.5 * (error + error.transpose()).rowwise().sum();
    const double lowest = LowestControlDeterminant(terms, less);
    if (lowest > 0.0 && std::isfinite(lowest))
    {
      verdict.Sign = (leftDeterminant > 0.0) == (rightDeterminant > 0.0) ? 1 : -1;
      verdict.Bound = (1.0 - 1e-12) * lowest / std::abs(leftDeterminant * rightDeterminant);
      return verdict;
    }
  }
  FindLowestCorner(expansion, half, verdict);
  return verdict;
}

} // namespace shape
