#include "Base/Errors.h"
#include "Fmm/DirectSummation.h"
#include "Fmm/FmmSummation.h"
#include "Support/RandomPoints.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{

using shapetest::RandomMatrix;

using shape::FmmSummation;
using Method = shape::FmmSummationOptions::MethodType;

/// Points on a bumpy sphere, times `scale`.
Eigen::MatrixXd Surface(int count, double scale, unsigned seed)
{
  Eigen::MatrixXd points = RandomMatrix(count, 3, seed).rowwise().normalized();
  for (Eigen::Index i = 0; i < count; ++i)
  {
    points.row(i) *=
      scale * (1.0 + 0.3 * std::sin(3.0 * points(i, 0) + 1.0) * std::cos(4.0 * points(i, 1)));
  }
  return points;
}

/// Three columns: of both signs, of one sign, and alternating.
Eigen::MatrixXd Charges(int count, unsigned seed)
{
  Eigen::MatrixXd charges = RandomMatrix(count, 3, seed);
  charges.col(1) = charges.col(1).cwiseAbs();
  for (int j = 0; j < count; ++j)
  {
    charges(j, 2) = j % 2 == 0 ? 1.0 : -1.0;
  }
  return charges;
}

struct Case
{
  std::string Name;
  Eigen::MatrixXd Sources, Points, Charges;
};

std::vector<Case> Cases()
{
  std::vector<Case> cases;
  cases.push_back({ "surface", Surface(4000, 1.02, 1), Surface(400, 1.0, 2), Charges(4000, 3) });
  cases.push_back(
    { "volume", RandomMatrix(4000, 3, 4), RandomMatrix(400, 3, 5), Charges(4000, 6) });
  cases.push_back(
    { "inside a surface", cases[0].Sources, 0.7 * RandomMatrix(400, 3, 7), cases[0].Charges });
  cases.push_back(
    { "around", Surface(4000, 1.0, 8), 4.0 * RandomMatrix(400, 3, 9), Charges(4000, 10) });
  // Sources from one to a ten thousandth of the size apart.
  cases.push_back(
    { "graded", RandomMatrix(4000, 3, 11), RandomMatrix(400, 3, 12), Charges(4000, 13) });
  for (Eigen::Index j = 0; j < 4000; ++j)
  {
    cases.back().Sources.row(j) *= std::pow(10.0, -4.0 * j / 4000);
    cases.back().Points.row(j % 400) *= std::pow(10.0, -0.3 * (j / 400));
  }
  // Two layers of charges that nearly cancel.
  cases.push_back(
    { "dipoles", Eigen::MatrixXd(4000, 3), Surface(400, 1.0, 14), Charges(4000, 15) });
  cases.back().Sources << Surface(2000, 1.02, 16), Surface(2000, 1.021, 16);
  cases.back().Charges.bottomRows(2000) = -cases.back().Charges.topRows(2000);
  return cases;
}

shape::FmmSummationOptions Multipole(double tolerance)
{
  shape::FmmSummationOptions options;
  options.Method = Method::Multipole;
  options.Tolerance = tolerance;
  return options;
}

} // namespace

TEST(FmmSummation, KeepsItsToleranceForSurfacesAndVolumesAndChargesOfBothSigns)
{
  for (const Case& one : Cases())
  {
    const Eigen::MatrixXd potentials =
      shape::SumPotentialsDirectly(one.Sources, one.Charges, one.Points);
    const Eigen::MatrixXd sizes =
      shape::SumPotentialsDirectly(one.Sources, one.Charges.cwiseAbs(), one.Points);
    const Eigen::MatrixXd gradients =
      shape::SumGradientsDirectly(one.Sources, one.Charges, one.Points);
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(one.Points.rows(), 3);
    for (Eigen::Index j = 0; j < one.Sources.rows(); ++j)
    {
      const Eigen::ArrayXd squared =
        (one.Points.rowwise() - one.Sources.row(j)).rowwise().squaredNorm();
      slopes += (0.25 / M_PI * squared.inverse()).matrix() * one.Charges.row(j).cwiseAbs();
    }
    for (const double tolerance : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 2e-12 })
    {
      if (tolerance < 1e-7 && one.Name != "volume")
      {
        continue; // a second of setting up
      }
      const FmmSummation fast(one.Sources, one.Points, Multipole(tolerance));
      const Eigen::MatrixXd error = fast.Potentials(one.Charges) - potentials;
      const Eigen::MatrixXd gradientError = fast.Gradients(one.Charges) - gradients;
      for (int c = 0; c < 3; ++c)
      {
        const std::string what =
          one.Name + ", column " + std::to_string(c) + ", tolerance " + std::to_string(tolerance);
        EXPECT_LT(error.col(c).norm() / sizes.col(c).norm(), tolerance) << what;
        EXPECT_LT((error.col(c).array() / sizes.col(c).array()).abs().maxCoeff(), 100 * tolerance)
          << what;
        EXPECT_LT(gradientError.middleCols(3 * c, 3).norm() / slopes.col(c).norm(), 50 * tolerance)
          << what;
      }
    }
  }
}

TEST(FmmSummation, KeepsItsToleranceInLargerBoxes)
{
  for (const Case& one : Cases())
  {
    shape::FmmSummationOptions options = Multipole(1e-6);
    options.LargerBoxes = 10.0;
    const Eigen::MatrixXd error =
      FmmSummation(one.Sources, one.Points, options).Potentials(one.Charges) -
      shape::SumPotentialsDirectly(one.Sources, one.Charges, one.Points);
    const Eigen::MatrixXd sizes =
      shape::SumPotentialsDirectly(one.Sources, one.Charges.cwiseAbs(), one.Points);
    EXPECT_LT(error.norm() / sizes.norm(), 1e-6) << one.Name;
  }
}

TEST(FmmSummation, AUniformlyChargedSphereActsAsItsCentreOutsideAndNotAtAllInside)
{
  // Gauss points along the axis (zeros of the Legendre polynomial) times even angles around it: the
  // integral over the sphere is exact to rounding where the integrand is smooth.
  const int rings = 60, around = 120;
  Eigen::MatrixXd sources(rings * around, 3), charges(rings * around, 1);
  for (int ring = 0; ring < rings; ++ring)
  {
    double z = std::cos(M_PI * (ring + 0.75) / (rings + 0.5)), slope = 1.0;
    for (int step = 0; step < 50; ++step)
    {
      double before = 1.0, value = z;
      for (int degree = 2; degree <= rings; ++degree)
      {
        const double next = ((2 * degree - 1) * z * value - (degree - 1) * before) / degree;
        before = value;
        value = next;
      }
      slope = rings * (z * value - before) / (z * z - 1.0);
      z -= value / slope;
    }
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2.0 * M_PI * k / around;
      sources.row(ring * around + k) << std::sqrt(1.0 - z * z) * std::cos(angle),
        std::sqrt(1.0 - z * z) * std::sin(angle), z;
      charges(ring * around + k, 0) = 1.0 / ((1.0 - z * z) * slope * slope * around);
    }
  }
  ASSERT_NEAR(charges.sum(), 1.0, 1e-12);
  const Eigen::MatrixXd inside = 0.25 * RandomMatrix(500, 3, 21);
  const Eigen::MatrixXd outside = RandomMatrix(500, 3, 22).rowwise().normalized() * 3.0;
  for (const double tolerance : { 1e-5, 1e-8 })
  {
    const FmmSummation within(sources, inside, Multipole(tolerance));
    EXPECT_LT(
      (4.0 * M_PI * within.Potentials(charges).array() - 1.0).abs().maxCoeff(), 10 * tolerance);
    EXPECT_LT(4.0 * M_PI * within.Gradients(charges).cwiseAbs().maxCoeff(), 300 * tolerance);
    const FmmSummation around3(sources, outside, Multipole(tolerance));
    EXPECT_LT((4.0 * M_PI * around3.Potentials(charges).array() - 1.0 / 3.0).abs().maxCoeff(),
      10 * tolerance);
    EXPECT_LT((4.0 * M_PI * around3.Gradients(charges) + outside / 27.0).cwiseAbs().maxCoeff(),
      300 * tolerance);
  }
}

TEST(FmmSummation, APointsSumDependsOnTheSourcesAndItAlone)
{
  const Eigen::MatrixXd sources = Surface(12000, 1.02, 31), charges = Charges(12000, 32);
  const Eigen::MatrixXd points = Surface(5000, 1.0, 33);
  for (const double tolerance : { 1e-4, 1e-7 })
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    const FmmSummation one(sources, points, Multipole(tolerance));
    const Eigen::MatrixXd potentials = one.Potentials(charges);
    const Eigen::MatrixXd gradients = one.Gradients(charges);
    setenv("VTK_SMP_MAX_THREADS", "2", 1);
    const FmmSummation two(sources, points, Multipole(tolerance));
    EXPECT_EQ(two.Potentials(charges), potentials);
    EXPECT_EQ(two.Gradients(charges), gradients);
    unsetenv("VTK_SMP_MAX_THREADS");
    const FmmSummation some(sources, points.middleRows(1000, 77), Multipole(tolerance));
    EXPECT_EQ(some.Potentials(charges), potentials.middleRows(1000, 77));
    EXPECT_EQ(some.Gradients(charges), gradients.middleRows(1000, 77));
  }
}

TEST(FmmSummation, IsLinearAndSymmetric)
{
  const Eigen::MatrixXd a = Surface(5000, 1.1, 41), b = RandomMatrix(4000, 3, 42);
  const Eigen::MatrixXd q = RandomMatrix(5000, 5, 43), p = RandomMatrix(4000, 5, 44);
  const FmmSummation there(a, b, Multipole(1e-6)), back(b, a, Multipole(1e-6));
  const Eigen::MatrixXd values = there.Potentials(q);
  EXPECT_EQ(there.Potentials(4.0 * q), Eigen::MatrixXd(4.0 * values));
  EXPECT_EQ(there.Potentials(Eigen::MatrixXd::Zero(5000, 2)),
    Eigen::MatrixXd(Eigen::MatrixXd::Zero(4000, 2)));
  const Eigen::MatrixXd combined = there.Potentials(q.col(0) - 2.0 * q.col(4));
  const double size = there.Potentials(q.cwiseAbs()).maxCoeff();
  EXPECT_LT((combined - values.col(0) + 2.0 * values.col(4)).cwiseAbs().maxCoeff(), 1e-6 * size);
  // p . (Phi q) = (Phi^T p) . q: what flows there flows back.
  const Eigen::MatrixXd other = back.Potentials(p);
  EXPECT_LT((p.transpose() * values - other.transpose() * q).cwiseAbs().maxCoeff(),
    1e-6 * size * p.cwiseAbs().colwise().sum().maxCoeff());
}

TEST(FmmSummation, EveryProcessorsInstructionsAgree)
{
  const Eigen::MatrixXd sources = Surface(1500, 1.02, 51), points = Surface(300, 1.0, 52);
  // The others are not compiled: they run as SCALAR.
  const std::int64_t supported =
    hwy::SupportedTargets() & (HWY_AVX3 | HWY_AVX2 | HWY_SSE4 | HWY_SCALAR);
  for (const int columns : { 1, 5 })
  {
    const Eigen::MatrixXd charges = RandomMatrix(1500, columns, 53);
    const Eigen::MatrixXd exact = shape::SumPotentialsDirectly(sources, charges, points);
    const double size = shape::SumPotentialsDirectly(sources, charges.cwiseAbs(), points).norm();
    const Eigen::MatrixXd slopes = shape::SumGradientsDirectly(sources, charges, points);
    for (std::int64_t left = supported; left != 0; left &= left - 1)
    {
      hwy::SetSupportedTargetsForTest(left & -left);
      for (const double tolerance : { 1e-5, 1e-7 })
      {
        const FmmSummation fast(sources, points, Multipole(tolerance));
        EXPECT_LT((fast.Potentials(charges) - exact).norm(), tolerance * size)
          << hwy::TargetName(left & -left);
        EXPECT_LT((fast.Gradients(charges) - slopes).norm(), 30 * tolerance * slopes.norm())
          << hwy::TargetName(left & -left);
      }
    }
    hwy::SetSupportedTargetsForTest(0);
  }
}

TEST(FmmSummation, IsRightForSourcesAndPointsInOddPlaces)
{
  const Eigen::MatrixXd charges = Charges(3000, 61);
  Eigen::MatrixXd positions = RandomMatrix(3000, 3, 62);
  const auto check =
    [&](const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points, const char* what)
  {
    const Eigen::MatrixXd fast =
      FmmSummation(sources, points, Multipole(1e-6)).Potentials(charges.topRows(sources.rows()));
    const Eigen::MatrixXd exact =
      shape::SumPotentialsDirectly(sources, charges.topRows(sources.rows()), points);
    const Eigen::MatrixXd sizes =
      shape::SumPotentialsDirectly(sources, charges.topRows(sources.rows()).cwiseAbs(), points);
    EXPECT_LT(((fast - exact).array() / sizes.array()).abs().maxCoeff(), 1e-4) << what;
  };
  Eigen::MatrixXd far = RandomMatrix(300, 3, 63);
  for (Eigen::Index i = 0; i < 300; ++i)
  {
    far.row(i) = far.row(i).normalized() * std::pow(10.0, 0.05 * i);
  }
  check(positions, far, "from near to 1e15 sizes away");
  check(positions.array() + 1e4, RandomMatrix(300, 3, 64).array() + 1e4, "far from the origin");
  check(positions.topRows(1), far, "one source");
  check(Eigen::MatrixXd::Constant(3000, 3, 0.3), far, "all sources in one place");
  Eigen::MatrixXd line = positions;
  line.rightCols(2).setZero();
  check(line, far, "a line");
  positions.topRows(2000) = positions.topRows(2000) * 1e-7;
  check(positions, 1e-6 * RandomMatrix(300, 3, 65), "a cluster of a ten millionth of the size");
  check(1e-12 * positions, 1e-12 * RandomMatrix(300, 3, 66), "small units");
}

TEST(FmmSummation, IsNotFiniteWhereAPointCoincidesWithASourceAndThereAlone)
{
  const Eigen::MatrixXd sources = RandomMatrix(5000, 3, 71), charges = Charges(5000, 72);
  Eigen::MatrixXd points = RandomMatrix(500, 3, 73);
  points.row(99) = sources.row(1234);
  const FmmSummation fast(sources, points, Multipole(1e-6));
  const Eigen::MatrixXd potentials = fast.Potentials(charges), slopes = fast.Gradients(charges);
  for (int i = 0; i < 500; ++i)
  {
    EXPECT_EQ(potentials.row(i).array().isFinite().all(), i != 99);
    EXPECT_EQ(slopes.row(i).array().isFinite().all(), i != 99);
  }
}

TEST(FmmSummation, SmallSumsAreDirectWrongInputIsRefusedAndItCanBeStopped)
{
  const Eigen::MatrixXd sources = RandomMatrix(300, 3, 81), charges = Charges(300, 82);
  const Eigen::MatrixXd points = RandomMatrix(200, 3, 83), none(0, 3);
  EXPECT_EQ(FmmSummation(sources, points).Potentials(charges),
    shape::SumPotentialsDirectly(sources, charges, points));
  EXPECT_EQ(FmmSummation(none, points, Multipole(1e-6)).Potentials(none),
    Eigen::MatrixXd(Eigen::MatrixXd::Zero(200, 3)));
  EXPECT_EQ(FmmSummation(sources, none, Multipole(1e-6)).Gradients(charges).rows(), 0);
  EXPECT_THROW(FmmSummation(sources, points).Potentials(charges.topRows(3)), shape::InvalidInput);
  EXPECT_THROW(FmmSummation(sources, RandomMatrix(5, 2, 1)), shape::InvalidInput);
  Eigen::MatrixXd broken = sources;
  broken(17, 1) = std::nan("");
  EXPECT_THROW(FmmSummation(broken, points), shape::InvalidInput);
  EXPECT_THROW(FmmSummation(sources, points, Multipole(1e-14)), shape::InvalidInput);
  EXPECT_THROW(FmmSummation(sources, points, Multipole(0.5)), shape::InvalidInput);
  shape::FmmSummationOptions smaller = Multipole(1e-6);
  smaller.LargerBoxes = 0.5;
  EXPECT_THROW(FmmSummation(sources, points, smaller), shape::InvalidInput);
  const shape::Progress stop([](double) { return false; });
  EXPECT_THROW(FmmSummation(sources, points, Multipole(1e-6), stop), shape::Aborted);
  const FmmSummation fast(sources, points, Multipole(1e-6));
  EXPECT_THROW(fast.Potentials(charges, stop), shape::Aborted);
}
