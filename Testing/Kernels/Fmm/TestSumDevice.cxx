// The OpenCL device of these tests is pocl's processor.
#include "Base/Errors.h"
#include "Fmm/DirectSummation.h"
#include "Fmm/FmmSummation.h"
#include "Support/RandomPoints.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{

using shapetest::RandomMatrix;

using Kind = shape::SumDevice::KindType;
constexpr shape::RootError Rounding = shape::RootError::Rounding;
const shape::SumDevice Processor;
const shape::SumDevice OpenCL{ Kind::OpenCL,
  [](const std::string& warning) { ADD_FAILURE() << warning; } };
const shape::SumDevice Automatic{ Kind::Automatic, OpenCL.Warn };

#ifdef SHAPEMAP_OPENCL

/// The sums at each point over the absolute values of the terms, of potentials or of gradients.
Eigen::ArrayXXd Sizes(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges,
  const Eigen::MatrixXd& points, bool gradients)
{
  Eigen::MatrixXd sizes(points.rows(), charges.cols());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::ArrayXd squared = (sources.rowwise() - points.row(i)).rowwise().squaredNorm();
    const Eigen::RowVectorXd inverse = squared.pow(gradients ? -1.0 : -0.5);
    sizes.row(i) = 0.25 / M_PI * inverse * charges.cwiseAbs();
  }
  return gradients ? sizes(Eigen::all,
                       Eigen::VectorXi::NullaryExpr(
                         3 * sizes.cols(), [](Eigen::Index c) { return static_cast<int>(c / 3); }))
                   : sizes;
}

shape::FmmSummationOptions Multipole(double tolerance, const shape::SumDevice& device)
{
  shape::FmmSummationOptions options;
  options.Method = shape::FmmSummationOptions::MethodType::Multipole;
  options.Tolerance = tolerance;
  options.Device = device;
  return options;
}

#endif

} // namespace

#ifdef SHAPEMAP_OPENCL

TEST(SumDevice, DirectSumsAgreeWithTheProcessorForEveryNumberOfColumns)
{
  // Several passes of sources, and a last block that is not full.
  const Eigen::MatrixXd sources = RandomMatrix(40000, 3, 1), points = 1.1 * RandomMatrix(333, 3, 2);
  for (int columns = 1; columns <= 4; ++columns)
  {
    const Eigen::MatrixXd charges = RandomMatrix(40000, columns, 3);
    const Eigen::MatrixXd potentials =
      shape::SumPotentialsDirectly(sources, charges, points, Rounding, {}, OpenCL);
    const Eigen::MatrixXd gradients =
      shape::SumGradientsDirectly(sources, charges, points, {}, OpenCL);
    const Eigen::MatrixXd error =
      potentials - shape::SumPotentialsDirectly(sources, charges, points);
    const Eigen::MatrixXd gradientError =
      gradients - shape::SumGradientsDirectly(sources, charges, points);
    EXPECT_LT((error.array() / Sizes(sources, charges, points, false)).abs().maxCoeff(), 1e-12);
    EXPECT_LT(
      (gradientError.array() / Sizes(sources, charges, points, true)).abs().maxCoeff(), 1e-12);
  }
}

TEST(SumDevice, SumsAgreeWhateverTheUnitOfLength)
{
  const Eigen::MatrixXd sources = RandomMatrix(300, 3, 4),
                        charges = RandomMatrix(300, 3, 5).cwiseAbs();
  const Eigen::MatrixXd points = RandomMatrix(70, 3, 6);
  for (const double unit : { 1e-30, 1e-3, 3e40 })
  {
    const Eigen::MatrixXd device =
      shape::SumPotentialsDirectly(unit * sources, charges, unit * points, Rounding, {}, OpenCL);
    const Eigen::MatrixXd processor =
      shape::SumPotentialsDirectly(unit * sources, charges, unit * points);
    EXPECT_LT(((device - processor).array() / processor.array()).abs().maxCoeff(), 1e-12) << unit;
  }
}

TEST(SumDevice, APointsSumDependsOnItAloneAndIsTheSameInEveryRun)
{
  const Eigen::MatrixXd sources = RandomMatrix(20000, 3, 7), charges = RandomMatrix(20000, 3, 8);
  const Eigen::MatrixXd points = RandomMatrix(3001, 3, 9);
  const auto sum = [&](const Eigen::MatrixXd& at)
  { return shape::SumGradientsDirectly(sources, charges, at, {}, OpenCL); };
  const Eigen::MatrixXd whole = sum(points);
  EXPECT_EQ(sum(points), whole);
  EXPECT_EQ(sum(points.middleRows(77, 5)), whole.middleRows(77, 5));
}

TEST(SumDevice, TheMultipoleMethodAgreesWithTheProcessor)
{
  // Points outside the sources' box, too, which have no near sources.
  const Eigen::MatrixXd sources = RandomMatrix(12000, 3, 11), charges = RandomMatrix(12000, 4, 12);
  Eigen::MatrixXd points = RandomMatrix(5000, 3, 13);
  points.bottomRows(500) *= 100.0;
  // In this grade the processor's near sums, too, are accurate to rounding.
  const shape::FmmSummation device(sources, points, Multipole(1e-8, OpenCL));
  const shape::FmmSummation processor(sources, points, Multipole(1e-8, Processor));
  const Eigen::MatrixXd error = device.Potentials(charges) - processor.Potentials(charges);
  EXPECT_LT((error.array() / Sizes(sources, charges, points, false)).abs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd gradientError = device.Gradients(charges) - processor.Gradients(charges);
  EXPECT_LT(
    (gradientError.array() / Sizes(sources, charges, points, true)).abs().maxCoeff(), 1e-12);
}

TEST(SumDevice, TheMultipoleMethodKeepsItsToleranceAndItsBits)
{
  const Eigen::MatrixXd sources = RandomMatrix(12000, 3, 14), charges = RandomMatrix(12000, 3, 15);
  const Eigen::MatrixXd points = RandomMatrix(3000, 3, 16);
  const shape::FmmSummation fast(sources, points, Multipole(1e-4, OpenCL));
  const Eigen::MatrixXd potentials = fast.Potentials(charges);
  const Eigen::MatrixXd error = potentials - shape::SumPotentialsDirectly(sources, charges, points);
  EXPECT_LT(error.norm(), 1e-4 * Sizes(sources, charges, points, false).matrix().norm());
  const shape::FmmSummation some(sources, points.middleRows(1000, 77), Multipole(1e-4, OpenCL));
  EXPECT_EQ(some.Potentials(charges), potentials.middleRows(1000, 77));
}

TEST(SumDevice, SumsAreNotFiniteWhereAPointCoincidesWithASourceAndThereAlone)
{
  const Eigen::MatrixXd sources = RandomMatrix(5000, 3, 17), charges = RandomMatrix(5000, 3, 18);
  Eigen::MatrixXd points = RandomMatrix(200, 3, 19);
  points.row(99) = sources.row(1234);
  const shape::FmmSummation fast(sources, points, Multipole(1e-6, OpenCL));
  for (const Eigen::MatrixXd& sums :
    { shape::SumPotentialsDirectly(sources, charges, points, Rounding, {}, OpenCL),
      shape::SumGradientsDirectly(sources, charges, points, {}, OpenCL), fast.Potentials(charges),
      fast.Gradients(charges) })
  {
    for (int i = 0; i < 200; ++i)
    {
      EXPECT_EQ(sums.row(i).array().isFinite().all(), i != 99);
    }
  }
}

TEST(SumDevice, EmptySumsAreZeroAndEverySumCanBeStopped)
{
  const Eigen::MatrixXd none(0, 3), points = RandomMatrix(500, 3, 20),
                                    charges = RandomMatrix(500, 2, 21);
  EXPECT_EQ(shape::SumPotentialsDirectly(none, Eigen::MatrixXd(0, 2), points, Rounding, {}, OpenCL),
    Eigen::MatrixXd(Eigen::MatrixXd::Zero(500, 2)));
  EXPECT_EQ(shape::SumGradientsDirectly(points, charges, none, {}, OpenCL), Eigen::MatrixXd(0, 6));
  EXPECT_EQ(
    shape::SumGradientsDirectly(points, Eigen::MatrixXd(500, 0), points, {}, OpenCL).cols(), 0);
  // Stopped at the first report, the second, ...
  const Eigen::MatrixXd many = RandomMatrix(40000, 3, 22);
  for (int most = 0; most < 3; ++most)
  {
    int reports = 0;
    double before = 0.0;
    const shape::Progress stop(
      [&](double fraction)
      {
        EXPECT_GE(fraction, before);
        EXPECT_LE(fraction, 1.0);
        before = fraction;
        return reports++ < most;
      });
    EXPECT_THROW(
      shape::SumPotentialsDirectly(many, many, points, Rounding, stop, OpenCL), shape::Aborted);
    EXPECT_EQ(reports, most + 1);
  }
}

// A driver reads the environment when it starts, so these checks run in processes of their own.

TEST(SumDeviceDeathTest, ADeviceThatFailsIsReplacedByTheProcessorWithAWarning)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto failAndReplace = []
  {
    // The sources take more than the largest buffer of a device of 1 GB, 256 MiB.
    setenv("POCL_MEMORY_LIMIT", "1", 1);
    const Eigen::MatrixXd sources = RandomMatrix(9000000, 3, 23), points = RandomMatrix(2, 3, 24);
    const Eigen::MatrixXd charges = Eigen::MatrixXd::Ones(9000000, 1);
    std::vector<std::string> warnings;
    const shape::SumDevice failing{ Kind::OpenCL,
      [&](const std::string& warning) { warnings.push_back(warning); } };
    const Eigen::MatrixXd sums =
      shape::SumPotentialsDirectly(sources, charges, points, Rounding, {}, failing);
    bool refused = false;
    try
    {
      shape::SumPotentialsDirectly(sources, charges, points, Rounding, {}, { Kind::OpenCL });
    }
    catch (const shape::SolveFailure&)
    {
      refused = true; // nobody would receive the warning
    }
    return sums == shape::SumPotentialsDirectly(sources, charges, points) && warnings.size() == 1 &&
      warnings[0].find("OpenCL device failed") != std::string::npos &&
      warnings[0].find("set Device to Processor") != std::string::npos && refused;
  };
  EXPECT_EXIT(std::exit(failAndReplace() ? 0 : 1), testing::ExitedWithCode(0), "");
}

TEST(SumDeviceDeathTest, WithoutADeviceOpenCLIsRefusedAndAutomaticIsTheProcessor)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refuse = []
  {
    setenv("OCL_ICD_VENDORS", "/no/such/folder", 1);
    try
    {
      shape::ChooseOpenCL(OpenCL, 1.0);
    }
    catch (const shape::InvalidInput& error)
    {
      return std::string(error.what()).find("no OpenCL device") != std::string::npos &&
        !shape::ChooseOpenCL(Automatic, 1e12);
    }
    return false;
  };
  EXPECT_EXIT(std::exit(refuse() ? 0 : 1), testing::ExitedWithCode(0), "");
}

#else

TEST(SumDevice, WithoutOpenCLItIsRefused)
{
  EXPECT_THROW(shape::ChooseOpenCL(OpenCL, 1.0), shape::InvalidInput);
  EXPECT_THROW(shape::SumPotentialsDirectly(RandomMatrix(5, 3, 1), RandomMatrix(5, 1, 2),
                 RandomMatrix(4, 3, 3), Rounding, {}, OpenCL),
    shape::InvalidInput);
}

#endif

TEST(SumDevice, AutomaticLeavesSmallSumsToTheProcessor)
{
  EXPECT_FALSE(shape::ChooseOpenCL(Automatic, 0.99 * shape::SumDevice::MinimumPairs));
  EXPECT_FALSE(shape::ChooseOpenCL(Processor, 1e15));
  const Eigen::MatrixXd sources = RandomMatrix(100, 3, 31), charges = RandomMatrix(100, 2, 32);
  const Eigen::MatrixXd points = RandomMatrix(20, 3, 33);
  EXPECT_EQ(shape::SumPotentialsDirectly(sources, charges, points, Rounding, {}, Automatic),
    shape::SumPotentialsDirectly(sources, charges, points));
}
