#include "Base/Errors.h"
#include "Correspondence/Functional/CoupledBases.h"
#include "Correspondence/Functional/Private/LandmarkKernels.h"
#include "Support/MatchingShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

const shape::Landmarks Marks = { { 5, 5 }, { 70, 70 }, { 200, 200 }, { 411, 411 }, { 600, 600 } };

/// A bumpy sphere and a squeezed copy, twice as large, with the same numbers.
struct Pair
{
  shape::Mesh MeshA = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity()), MeshB = MeshA;
  shape::LaplaceEigenpairs A, B;
  Eigen::MatrixXd FunctionsA, FunctionsB;

  Pair()
  {
    this->MeshB.Points *= Eigen::Vector3d(2.0, 2.4, 1.8).asDiagonal();
    this->A = shape::SolveLaplaceEigenproblem(this->MeshA, 30);
    this->B = shape::SolveLaplaceEigenproblem(this->MeshB, 30);
    this->FunctionsA = shape::ComputeLandmarkKernels(this->A, Marks, 0, 10);
    this->FunctionsB = shape::ComputeLandmarkKernels(this->B, Marks, 1, 10);
  }
  /// The matrix of the true map.
  Eigen::MatrixXd Map() const
  {
    return this->B.Eigenfunctions.transpose() * this->B.Masses.asDiagonal() *
      this->A.Eigenfunctions;
  }
};

shape::CoupledBasesOptions SizeTwelve()
{
  shape::CoupledBasesOptions options;
  options.Size = 12;
  return options;
}

double Dot(const shape::CoupledBases& x, const shape::CoupledBases& y)
{
  return x.RotationOfA.cwiseProduct(y.RotationOfA).sum() +
    x.RotationOfB.cwiseProduct(y.RotationOfB).sum();
}

/// The part of a gradient along orthogonal matrices.
shape::CoupledBases Tangents(const shape::CoupledBases& at, const shape::CoupledBases& gradient)
{
  const auto tangent = [](const Eigen::MatrixXd& x, const Eigen::MatrixXd& g)
  { return Eigen::MatrixXd(0.5 * (g - x * g.transpose() * x)); };
  return { tangent(at.RotationOfA, gradient.RotationOfA),
    tangent(at.RotationOfB, gradient.RotationOfB) };
}

double DistanceFromIdentity(const Eigen::MatrixXd& products)
{
  return (products - Eigen::MatrixXd::Identity(products.rows(), products.cols())).norm();
}

TEST(CoupledBasesEnergy, HasTheGradientOfItsValue)
{
  const Pair pair;
  const shape::CoupledBasesEnergy energy(
    pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, SizeTwelve());
  std::srand(1);
  const auto random = [] {
    return shape::CoupledBases{ Eigen::MatrixXd::Random(12, 12), Eigen::MatrixXd::Random(12, 12) };
  };
  const shape::CoupledBases at = random(), gradient = energy.Gradient(at);
  for (int k = 0; k < 3; ++k)
  {
    const shape::CoupledBases along = random();
    const auto moved = [&](double step)
    {
      return energy.Value(
        { at.RotationOfA + step * along.RotationOfA, at.RotationOfB + step * along.RotationOfB });
    };
    constexpr double step = 1e-4;
    const double expected = Dot(gradient, along);
    EXPECT_NEAR((moved(step) - moved(-step)) / (2.0 * step), expected, 1e-6 * std::abs(expected));
  }
}

TEST(CoupledBases, AreOrthonormalAndMakeTheMapNearlyDiagonal)
{
  const Pair pair;
  const shape::CoupledBasesEnergy energy(
    pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, SizeTwelve());
  const shape::CoupledBases bases =
    shape::ComputeCoupledBases(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, SizeTwelve());
  EXPECT_LT(energy.Value(bases), energy.Value(energy.Start()));
  EXPECT_LT(
    Dot(Tangents(bases, energy.Gradient(bases)), Tangents(bases, energy.Gradient(bases))), 1e-9);
  EXPECT_LT(DistanceFromIdentity(bases.RotationOfA.transpose() * bases.RotationOfA), 1e-12);
  EXPECT_LT(DistanceFromIdentity(bases.RotationOfB.transpose() * bases.RotationOfB), 1e-12);
  // The eigenfunctions themselves, in their order.
  const Eigen::MatrixXd first = Eigen::MatrixXd::Identity(12, 12);
  const double before = shape::ComputeDiagonalShare(pair.Map(), { first, first }),
               after = shape::ComputeDiagonalShare(pair.Map(), bases);
  EXPECT_LT(1.0 - after, 0.5 * (1.0 - before));
  // A larger weight brings corresponding functions nearer to each other.
  double last = 0.0;
  for (const double weight : { 0.01, 0.1, 1.0, 10.0 })
  {
    shape::CoupledBasesOptions options = SizeTwelve(), without = SizeTwelve();
    options.Weight = weight;
    without.Weight = 0.0;
    const shape::CoupledBases now =
      shape::ComputeCoupledBases(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, options);
    const double term = energy.Value(now) -
      shape::CoupledBasesEnergy(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, without)
        .Value(now);
    if (weight > 0.01)
    {
      EXPECT_LT(term, last) << weight;
    }
    last = term;
  }
}

// Eigenfunctions are known up to their signs.
TEST(CoupledBases, DependNotOnTheSignsOfTheSecondEigenfunctions)
{
  Pair pair;
  const shape::CoupledBases bases =
    shape::ComputeCoupledBases(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, SizeTwelve());
  const Eigen::MatrixXd functions = pair.B.Eigenfunctions.leftCols(12) * bases.RotationOfB;
  for (const int k : { 1, 2, 5, 8 })
  {
    pair.B.Eigenfunctions.col(k) *= -1.0;
  }
  const shape::CoupledBases again =
    shape::ComputeCoupledBases(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, SizeTwelve());
  EXPECT_LT((pair.B.Eigenfunctions.leftCols(12) * again.RotationOfB - functions).norm(),
    1e-3 * functions.norm());
}

TEST(CoupledBases, RefuseWhatDoesNotDetermineThem)
{
  const Pair pair;
  const Eigen::MatrixXd none(pair.A.Masses.size(), 0);
  EXPECT_THROW(
    shape::ComputeCoupledBases(pair.A, none, pair.B, none, SizeTwelve()), shape::InvalidInput);
  shape::CoupledBasesOptions options = SizeTwelve();
  options.Size = 31;
  EXPECT_THROW(
    shape::ComputeCoupledBases(pair.A, pair.FunctionsA, pair.B, pair.FunctionsB, options),
    shape::InvalidInput);
}

} // namespace
