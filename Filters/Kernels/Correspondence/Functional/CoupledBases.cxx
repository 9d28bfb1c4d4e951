#include "Correspondence/Functional/CoupledBases.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Functional/Private/LandmarkKernels.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

Eigen::MatrixXd OffDiagonal(Eigen::MatrixXd matrix)
{
  matrix.diagonal().setZero();
  return matrix;
}

/// The nearest matrix with orthonormal columns.
Eigen::MatrixXd PolarFactor(const Eigen::MatrixXd& matrix)
{
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return parts.matrixU() * parts.matrixV().transpose();
}

/// The projection onto the directions in which the columns of `at` stay orthonormal.
Eigen::MatrixXd Tangent(const Eigen::MatrixXd& at, const Eigen::MatrixXd& direction)
{
  const Eigen::MatrixXd products = at.transpose() * direction;
  return direction - at * (0.5 * (products + products.transpose()));
}

CoupledBases Tangents(const CoupledBases& at, const CoupledBases& direction)
{
  return { Tangent(at.RotationOfA, direction.RotationOfA),
    Tangent(at.RotationOfB, direction.RotationOfB) };
}

CoupledBases Added(const CoupledBases& x, double factor, const CoupledBases& y)
{
  return { x.RotationOfA + factor * y.RotationOfA, x.RotationOfB + factor * y.RotationOfB };
}

CoupledBases Retracted(const CoupledBases& at, double step, const CoupledBases& direction)
{
  const CoupledBases moved = Added(at, step, direction);
  // Near orthonormal columns, the polar factor is M (M' M)^-1/2.
  const auto factor = [](const Eigen::MatrixXd& m)
  {
    return Eigen::MatrixXd(
      m * Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m.transpose() * m).operatorInverseSqrt());
  };
  return { factor(moved.RotationOfA), factor(moved.RotationOfB) };
}

double InnerProduct(const CoupledBases& x, const CoupledBases& y)
{
  return x.RotationOfA.cwiseProduct(y.RotationOfA).sum() +
    x.RotationOfB.cwiseProduct(y.RotationOfB).sum();
}

/// k x q: the coefficients of functions of norm 1, divided by the root of their number.
Eigen::MatrixXd UnitCoefficients(
  const LaplaceEigenpairs& spectrum, const Eigen::MatrixXd& functions, Eigen::Index size)
{
  const Eigen::MatrixXd weighted = spectrum.Masses.asDiagonal() * functions;
  Eigen::MatrixXd result = spectrum.Eigenfunctions.leftCols(size).transpose() * weighted;
  for (Eigen::Index i = 0; i < functions.cols(); ++i)
  {
    const double norm = std::sqrt(functions.col(i).dot(weighted.col(i)));
    result.col(i) /= norm > 0.0 ? norm : 1.0;
  }
  return result / std::sqrt(static_cast<double>(functions.cols()));
}

} // namespace

CoupledBasesEnergy::CoupledBasesEnergy(const LaplaceEigenpairs& a,
  const Eigen::MatrixXd& functionsOfA, const LaplaceEigenpairs& b,
  const Eigen::MatrixXd& functionsOfB, const CoupledBasesOptions& options)
  : Weight(options.Weight)
  , Size(options.Size)
{
  const Eigen::Index pairs = std::min(a.Eigenvalues.size(), b.Eigenvalues.size());
  RequireOption(options.Size >= 1 && options.Size <= pairs, "CoupledBasisSize", options.Size,
    "from 1 to NumberOfEigenpairs (" + std::to_string(pairs) + ")");
  RequireOption(options.Weight >= 0.0 && std::isfinite(options.Weight), "CoupledBasisWeight",
    options.Weight, "at least 0 and finite");
  if (functionsOfA.cols() == 0 || functionsOfA.cols() != functionsOfB.cols())
  {
    throw InvalidInput("no functions of the surfaces are known to correspond, from which bases "
                       "could be coupled; give Landmarks, DescriptorArrays or RegionArray");
  }
  this->ValuesOfA = a.Eigenvalues.head(this->Size) * a.Masses.sum();
  this->ValuesOfB = b.Eigenvalues.head(this->Size) * b.Masses.sum();
  const double largest = std::max(this->ValuesOfA(this->Size - 1), this->ValuesOfB(this->Size - 1));
  this->ValuesOfA /= largest > 0.0 ? largest : 1.0;
  this->ValuesOfB /= largest > 0.0 ? largest : 1.0;
  this->OfA = UnitCoefficients(a, functionsOfA, this->Size);
  this->OfB = UnitCoefficients(b, functionsOfB, this->Size);
}

double CoupledBasesEnergy::Value(const CoupledBases& bases) const
{
  const Eigen::MatrixXd &x = bases.RotationOfA, &y = bases.RotationOfB;
  return OffDiagonal(x.transpose() * this->ValuesOfA.asDiagonal() * x).squaredNorm() +
    OffDiagonal(y.transpose() * this->ValuesOfB.asDiagonal() * y).squaredNorm() +
    this->Weight * (this->OfA.transpose() * x - this->OfB.transpose() * y).squaredNorm();
}

// off(X' L X) has the gradient 4 L X off-diagonal(X' L X).
CoupledBases CoupledBasesEnergy::Gradient(const CoupledBases& bases) const
{
  const Eigen::MatrixXd &x = bases.RotationOfA, &y = bases.RotationOfB;
  const Eigen::MatrixXd scaledX = this->ValuesOfA.asDiagonal() * x,
                        scaledY = this->ValuesOfB.asDiagonal() * y,
                        apart = this->OfA.transpose() * x - this->OfB.transpose() * y;
  return { 4.0 * scaledX * OffDiagonal(x.transpose() * scaledX) +
      2.0 * this->Weight * this->OfA * apart,
    4.0 * scaledY * OffDiagonal(y.transpose() * scaledY) - 2.0 * this->Weight * this->OfB * apart };
}

CoupledBases CoupledBasesEnergy::Start() const
{
  const Eigen::MatrixXd first = Eigen::MatrixXd::Identity(this->ValuesOfA.size(), this->Size);
  // |F' X - G' Y| is smallest at the polar factor of G F' X. Functions that say nothing about an
  // eigenfunction leave it where it is, up to its sign.
  constexpr double share = 1e-3; // of the norm
  Eigen::MatrixXd products = this->OfB * (this->OfA.transpose() * first);
  const Eigen::VectorXd signs =
    products.diagonal().unaryExpr([](double x) { return x < 0.0 ? -1.0 : 1.0; });
  products.diagonal() += share * products.norm() * signs;
  return { first, PolarFactor(products) };
}

CoupledBases ComputeCoupledBases(const LaplaceEigenpairs& a, const Eigen::MatrixXd& functionsOfA,
  const LaplaceEigenpairs& b, const Eigen::MatrixXd& functionsOfB,
  const CoupledBasesOptions& options, const Progress& progress)
{
  const BlasThreads one(false); // the matrices are small
  const CoupledBasesEnergy energy(a, functionsOfA, b, functionsOfB, options);
  CoupledBases bases = energy.Start();
  double value = energy.Value(bases);
  CoupledBases gradient = Tangents(bases, energy.Gradient(bases));
  CoupledBases direction = Added(gradient, -2.0, gradient);
  double squared = InnerProduct(gradient, gradient), step = 1.0;
  constexpr double minimum = 1e-5; // of the gradient at the start
  const double enough = minimum * minimum * squared;
  for (int k = 0; k < options.MaximumIterations && squared > enough; ++k)
  {
    progress(static_cast<double>(k) / options.MaximumIterations);
    // The minimum of the parabola through the value, its slope, and the value at the last step;
    // then halved until Armijo's condition holds.
    constexpr double decrease = 1e-4, smallest = 1e-12, most = 10.0;
    const double slope = InnerProduct(gradient, direction);
    const double curved = energy.Value(Retracted(bases, step, direction)) - value - step * slope;
    step *= curved > 0.0 ? std::clamp(-0.5 * slope * step / curved, 1.0 / most, most) : most;
    CoupledBases next;
    double nextValue = value;
    bool falls = false;
    for (; step > smallest && !falls; step *= falls ? 1.0 : 0.5)
    {
      next = Retracted(bases, step, direction);
      nextValue = energy.Value(next);
      falls = nextValue <= value + decrease * step * slope;
    }
    if (!falls) // the values differ by rounding only
    {
      break;
    }
    bases = next;
    value = nextValue;
    const CoupledBases now = Tangents(bases, energy.Gradient(bases));
    const double nowSquared = InnerProduct(now, now);
    // Polak and Ribiere; the old directions are projected onto the new tangents.
    const double beta =
      std::max(0.0, (nowSquared - InnerProduct(now, Tangents(bases, gradient))) / squared);
    direction = Added(Added(now, -2.0, now), beta, Tangents(bases, direction));
    if (InnerProduct(direction, now) >= 0.0) // not downwards any more
    {
      direction = Added(now, -2.0, now);
    }
    gradient = now;
    squared = nowSquared;
  }
  progress(1.0);
  return bases;
}

double ComputeDiagonalShare(const Eigen::MatrixXd& map, const CoupledBases& bases)
{
  const Eigen::MatrixXd &x = bases.RotationOfA, &y = bases.RotationOfB;
  const Eigen::MatrixXd inBases = y.transpose() * map.topLeftCorner(y.rows(), x.rows()) * x;
  const double all = inBases.squaredNorm();
  return all > 0.0 ? inBases.diagonal().squaredNorm() / all : 0.0;
}

CoupledFunctions CoupleEigenfunctions(const FunctionalMatrix& map, const Landmarks& landmarks,
  const Eigen::MatrixXd& givenOfA, const Eigen::MatrixXd& givenOfB,
  const CoupledBasesOptions& options, const Progress& progress)
{
  const auto functions =
    [&](const LaplaceEigenpairs& spectrum, const Eigen::MatrixXd& given, int which)
  {
    constexpr int energies = 25; // of each landmark, as FunctionalMapOptions has by default
    const Eigen::MatrixXd kernels = ComputeLandmarkKernels(spectrum, landmarks, which, energies);
    Eigen::MatrixXd all(spectrum.Masses.size(), kernels.cols() + given.cols());
    all << kernels, given;
    return all;
  };
  const CoupledBases bases = ComputeCoupledBases(map.OfA, functions(map.OfA, givenOfA, 0), map.OfB,
    functions(map.OfB, givenOfB, 1), options, progress);
  return { map.OfA.Eigenfunctions.leftCols(bases.RotationOfA.rows()) * bases.RotationOfA,
    map.OfB.Eigenfunctions.leftCols(bases.RotationOfB.rows()) * bases.RotationOfB,
    ComputeDiagonalShare(map.Matrix, bases) };
}

} // namespace shape
