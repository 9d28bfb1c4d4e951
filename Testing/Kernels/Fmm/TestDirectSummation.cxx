#include "Base/Errors.h"
#include "Fmm/DirectSummation.h"
#include "Support/RandomPoints.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace
{

using shapetest::RandomMatrix;

/// The largest error of the potentials and of the gradients, in units of the same sums of the
/// terms' absolute values, against sums in long double.
Eigen::Vector2d Errors(
  const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, const Eigen::MatrixXd& points)
{
  const Eigen::MatrixXd potentials = shape::SumPotentialsDirectly(sources, charges, points);
  const Eigen::MatrixXd gradients = shape::SumGradientsDirectly(sources, charges, points);
  EXPECT_EQ(gradients.cols(), 3 * charges.cols());
  long double worst = 0.0, worstGradient = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    for (Eigen::Index c = 0; c < charges.cols(); ++c)
    {
      long double sum = 0.0, size = 0.0, slope[3] = { 0.0, 0.0, 0.0 }, steepness = 0.0;
      for (Eigen::Index j = 0; j < sources.rows(); ++j)
      {
        long double away[3], squared = 0.0;
        for (int d = 0; d < 3; ++d)
        {
          away[d] = static_cast<long double>(points(i, d)) - sources(j, d);
          squared += away[d] * away[d];
        }
        const long double term = charges(j, c) / (4.0L * M_PIl * std::sqrt(squared));
        sum += term;
        size += std::abs(term);
        steepness += std::abs(term) / std::sqrt(squared);
        for (int d = 0; d < 3; ++d)
        {
          slope[d] -= term * away[d] / squared;
        }
      }
      worst = std::max(worst, std::abs(sum - potentials(i, c)) / size);
      for (int d = 0; d < 3; ++d)
      {
        worstGradient =
          std::max(worstGradient, std::abs(slope[d] - gradients(i, 3 * c + d)) / steepness);
      }
    }
  }
  return { static_cast<double>(worst), static_cast<double>(worstGradient) };
}

} // namespace

TEST(DirectSummation, IsRightToRoundingForEveryProcessorAndNumberOfColumns)
{
  const Eigen::MatrixXd sources = RandomMatrix(501, 3, 1), points = RandomMatrix(61, 3, 2);
  const std::int64_t supported = hwy::SupportedTargets();
  int tested = 0;
  for (std::int64_t left = supported; left != 0; left &= left - 1, ++tested)
  {
    hwy::SetSupportedTargetsForTest(left & -left);
    for (int columns = 1; columns <= 7; ++columns)
    {
      const Eigen::Vector2d errors = Errors(sources, RandomMatrix(501, columns, 3), points);
      EXPECT_LT(errors[0], 2e-15) << hwy::TargetName(left & -left) << ", " << columns;
      EXPECT_LT(errors[1], 4e-15) << hwy::TargetName(left & -left) << ", " << columns;
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GE(tested, 1);
}

TEST(DirectSummation, ASmallErrorOfTheRootsIsAsSmallAsPromised)
{
  const Eigen::MatrixXd sources = RandomMatrix(501, 3, 1), points = RandomMatrix(61, 3, 2);
  const Eigen::MatrixXd charges = RandomMatrix(501, 3, 3).cwiseAbs();
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t left = supported; left != 0; left &= left - 1)
  {
    hwy::SetSupportedTargetsForTest(left & -left);
    const Eigen::MatrixXd right = shape::SumPotentialsDirectly(sources, charges, points);
    const Eigen::MatrixXd small =
      shape::SumPotentialsDirectly(sources, charges, points, shape::RootError::Small);
    EXPECT_LE((small - right).cwiseQuotient(right).cwiseAbs().maxCoeff(), 1e-8)
      << hwy::TargetName(left & -left);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(DirectSummation, IsRightWhateverTheUnitOfLength)
{
  const Eigen::MatrixXd sources = RandomMatrix(100, 3, 4), charges = RandomMatrix(100, 3, 5);
  const Eigen::MatrixXd points = RandomMatrix(9, 3, 6);
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t left = supported; left != 0; left &= left - 1)
  {
    hwy::SetSupportedTargetsForTest(left & -left);
    for (const double unit : { 1e-30, 1e-3, 3e40 })
    {
      const Eigen::Vector2d errors = Errors(unit * sources, charges, unit * points);
      EXPECT_LT(errors.maxCoeff(), 4e-15) << unit << ' ' << hwy::TargetName(left & -left);
    }
    // Points that nearly touch a source, and points far away.
    Eigen::MatrixXd extreme = sources.topRows(9);
    for (int i = 0; i < 9; ++i)
    {
      extreme(i, 0) += i < 5 ? std::pow(10.0, -3 * i) : std::pow(10.0, 2 * i);
    }
    EXPECT_LT(Errors(sources, charges, extreme).maxCoeff(), 4e-15);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(DirectSummation, APointsSumDependsOnItAlone)
{
  const Eigen::MatrixXd sources = RandomMatrix(5000, 3, 7), charges = RandomMatrix(5000, 3, 8);
  const Eigen::MatrixXd points = RandomMatrix(1001, 3, 9);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const Eigen::MatrixXd one = shape::SumPotentialsDirectly(sources, charges, points);
  const Eigen::MatrixXd oneGradient = shape::SumGradientsDirectly(sources, charges, points);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  EXPECT_EQ(shape::SumPotentialsDirectly(sources, charges, points), one);
  EXPECT_EQ(shape::SumGradientsDirectly(sources, charges, points), oneGradient);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(shape::SumPotentialsDirectly(sources, charges, points.middleRows(77, 5)),
    one.middleRows(77, 5));
  EXPECT_EQ(shape::SumGradientsDirectly(sources, charges, points.middleRows(77, 5)),
    oneGradient.middleRows(77, 5));
}

TEST(DirectSummation, IsNotFiniteWhereAPointCoincidesWithASource)
{
  const Eigen::MatrixXd sources = RandomMatrix(100, 3, 10), charges = RandomMatrix(100, 3, 11);
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t left = supported; left != 0; left &= left - 1)
  {
    hwy::SetSupportedTargetsForTest(left & -left);
    Eigen::MatrixXd points = RandomMatrix(20, 3, 12);
    points.row(7) = sources.row(30);
    const Eigen::MatrixXd potentials = shape::SumPotentialsDirectly(sources, charges, points);
    const Eigen::MatrixXd gradients = shape::SumGradientsDirectly(sources, charges, points);
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_EQ(potentials.row(i).array().isFinite().all(), i != 7)
        << hwy::TargetName(left & -left);
      EXPECT_EQ(gradients.row(i).array().isFinite().all(), i != 7);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(DirectSummation, EmptySumsAreZeroAndWrongSizesAreRefused)
{
  const Eigen::MatrixXd none(0, 3), points = RandomMatrix(5, 3, 13);
  EXPECT_EQ(shape::SumPotentialsDirectly(none, Eigen::MatrixXd(0, 2), points),
    Eigen::MatrixXd(Eigen::MatrixXd::Zero(5, 2)));
  EXPECT_EQ(shape::SumPotentialsDirectly(points, RandomMatrix(5, 2, 1), none).rows(), 0);
  EXPECT_EQ(shape::SumGradientsDirectly(points, Eigen::MatrixXd(5, 0), points).cols(), 0);
  EXPECT_THROW(
    shape::SumPotentialsDirectly(points, RandomMatrix(4, 3, 1), points), shape::InvalidInput);
  EXPECT_THROW(shape::SumPotentialsDirectly(points, RandomMatrix(5, 3, 1), RandomMatrix(5, 2, 1)),
    shape::InvalidInput);
  EXPECT_THROW(shape::SumPotentialsDirectly(points, RandomMatrix(5, 3, 1), points,
                 shape::RootError::Rounding, shape::Progress([](double) { return false; })),
    shape::Aborted);
}
