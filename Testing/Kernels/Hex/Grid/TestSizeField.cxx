#include "Base/Errors.h"
#include "Hex/Grid/SizedHexes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

/// `factor` times as large at the top as at the bottom.
Eigen::VectorXd Sizes(const shape::Mesh& surface, double small, double factor)
{
  const Eigen::ArrayXd z = surface.Points.col(2);
  const double low = z.minCoeff(), high = z.maxCoeff();
  return small * (1.0 + (factor - 1.0) * (z - low) / (high - low));
}

double Quantile(const Eigen::VectorXd& values, double share)
{
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

} // namespace

TEST(SizeField, AGridHasTheSizesThatAreWanted)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  for (const double factor : { 1.0, 2.0, 4.0 })
  {
    const shape::SizedGrid grid = shape::BuildSizedGrid(sphere, Sizes(sphere, 0.06, factor));
    EXPECT_EQ(grid.NotTooLarge, 1.0) << factor;
    EXPECT_EQ(grid.NotTooSmall, 1.0) << factor;
    EXPECT_EQ(grid.Seeds.empty(), factor == 1.0);
  }
}

TEST(SizeField, HexahedraHaveTheSizesThatAreWanted)
{
  shape::GridHexesOptions options;
  options.Rounds = 1;
  for (const int level : { 1, 4 })
  {
    const shape::Mesh sphere = shapetest::Icosphere(level);
    const shape::SizedHexesResult result =
      shape::BuildSizedHexahedra(sphere, Sizes(sphere, 0.1, 2.0), options);
    EXPECT_NEAR(Quantile(result.Ratios, 0.5), 1.0, 0.03);
    EXPECT_LT(Quantile(result.Ratios, 0.9), 1.2);
    EXPECT_GT(Quantile(result.Ratios, 0.1), 1.0 / 1.25);
    EXPECT_GT(result.Hexes.Fit.MinimumScaledJacobian, 0.5);
    EXPECT_EQ(result.Ratios.size(), result.Hexes.Fit.Quads.rows());
  }
}

TEST(SizeField, BadSizesAreNamed)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::VectorXd good = Sizes(sphere, 0.3, 2.0);
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    Eigen::VectorXd sizes = good;
    sizes(7) = bad;
    EXPECT_THROW(shape::BuildSizedHexahedra(sphere, sizes), shape::InvalidInput) << bad;
  }
  EXPECT_THROW(shape::BuildSizedHexahedra(sphere, good.head(5)), shape::InvalidInput);
}
