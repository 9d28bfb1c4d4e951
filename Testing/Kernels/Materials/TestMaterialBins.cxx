#include "Materials/MaterialBins.h"

#include "Base/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

struct Values
{
  Eigen::VectorXd Modulus, Density, Volumes;

  explicit Values(int count)
    : Modulus(count)
    , Density(count)
    , Volumes(count)
  {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> range(0.0, 1.0);
    for (int i = 0; i < count; ++i)
    {
      this->Modulus(i) = 50.0 * std::pow(400.0, range(random));
      this->Density(i) = range(random);
      this->Volumes(i) = 0.1 + range(random);
    }
  }
};

} // namespace

TEST(MaterialBins, KeepTheIntegralsOfModulusAndDensity)
{
  const Values values(3000);
  for (const int count : { 1, 7, 50 })
  {
    shape::MaterialBins bins(values.Modulus.minCoeff(), values.Modulus.maxCoeff(), count);
    bins.Add(values.Modulus, values.Density, values.Volumes);
    const shape::Materials found = shape::FindMaterials(bins);
    EXPECT_EQ(found.Modulus.size(), count);
    EXPECT_NEAR(found.Modulus.dot(found.Volume) / values.Modulus.dot(values.Volumes), 1.0, 1e-13);
    EXPECT_NEAR(found.Density.dot(found.Volume) / values.Density.dot(values.Volumes), 1.0, 1e-13);
    EXPECT_EQ(found.Cells.sum(), 3000.0);
  }
}

TEST(MaterialBins, HaveEqualRelativeWidths)
{
  const Values values(3000);
  const double minimum = values.Modulus.minCoeff(), maximum = values.Modulus.maxCoeff();
  shape::MaterialBins bins(minimum, maximum, 20);
  bins.Add(values.Modulus, values.Density, values.Volumes);
  const shape::Materials found = shape::FindMaterials(bins);
  const double ratio = std::pow(maximum / minimum, 1.0 / 20.0);
  for (Eigen::Index i = 0; i < values.Modulus.size(); ++i)
  {
    const int bin = bins.FindBin(values.Modulus(i));
    const double low = minimum * std::pow(ratio, bin);
    EXPECT_GE(values.Modulus(i), low * (1.0 - 1e-12));
    EXPECT_LE(values.Modulus(i), low * ratio * (1.0 + 1e-12));
    EXPECT_LT(std::abs(std::log(found.Modulus(found.OfBin(bin)) / values.Modulus(i))),
      std::log(ratio) * (1.0 + 1e-12));
  }
}

TEST(MaterialBins, OnlyBinsWithCellsAreMaterials)
{
  const Eigen::Vector4d modulus(10.0, 1000.0, 11.0, 500.0), one = Eigen::Vector4d::Ones();
  shape::MaterialBins bins(10.0, 1000.0, 10);
  bins.Add(modulus, one, one, Eigen::Vector4i(1, 1, 1, 0));
  const shape::Materials found = shape::FindMaterials(bins);
  ASSERT_EQ(found.Modulus.size(), 2);
  EXPECT_DOUBLE_EQ(found.Modulus(0), 10.5);
  EXPECT_DOUBLE_EQ(found.Modulus(1), 1000.0);
  EXPECT_EQ(found.OfBin(0), 0);
  EXPECT_EQ(found.OfBin(9), 1);
  EXPECT_EQ(found.OfBin(8), -1);

  shape::MaterialBins single(3.0, 3.0, 10);
  single.Add(Eigen::Vector2d(3.0, 3.0), Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(1.0, 1.0));
  EXPECT_EQ(shape::FindMaterials(single).Modulus.size(), 1);
  EXPECT_THROW(shape::MaterialBins(1.0, 2.0, 0), shape::InvalidInput);
}
