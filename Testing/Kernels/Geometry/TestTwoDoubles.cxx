#include "Geometry/TwoDoubles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

// The rounding error of a product is a double, and a fused multiply-add rounds it once: not at all.
TEST(TwoDoubles, TheSecondNumberIsTheRoundingErrorOfAProduct)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 10000; ++round)
  {
    const double a = uniform(generator), b = std::ldexp(uniform(generator), round % 200 - 100);
    const shape::TwoDoubles product = shape::ExactProduct(a, b);
    ASSERT_EQ(product.High, a * b);
    ASSERT_EQ(product.Low, std::fma(a, b, -product.High));
  }
}

// The products are rounded before their sum: contracted with it, they are not.
TEST(TwoDoubles, TheSecondNumberIsTheRoundingErrorOfASumOfProducts)
{
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Eigen::ArrayXd numbers =
    Eigen::ArrayXd::NullaryExpr(10000, [&] { return uniform(generator); });
  const Eigen::ArrayXd squares = numbers * numbers;
  int inexact = 0;
  for (Eigen::Index i = 1; i < numbers.size(); ++i)
  {
    const shape::TwoDoubles sum =
      shape::ExactSum(numbers(i) * numbers(i), numbers(i - 1) * numbers(i - 1));
    const double large = std::max(squares(i), squares(i - 1)),
                 small = std::min(squares(i), squares(i - 1));
    ASSERT_EQ(sum.High, large + small);
    ASSERT_EQ(sum.Low, small - (sum.High - large)); // Dekker's sum, for the larger term first
    inexact += sum.Low != 0.0;
  }
  EXPECT_GT(inexact, 5000);
}

TEST(TwoDoubles, AQuotientAndARootHaveAHundredBits)
{
  const double limit = std::ldexp(1.0, -70); // of numbers of 2^30
  for (int k = 1; k < 1000; ++k)
  {
    const shape::TwoDoubles number(std::ldexp(1.0, 30) + k, std::ldexp(k, -60));
    const shape::TwoDoubles three(3.0), root = sqrt(number);
    EXPECT_LE(abs(number / three * three - number).High, limit);
    EXPECT_LE(abs(root * root - number).High, limit);
    EXPECT_NE((root * root.High - number).High, 0.0) << "one double is not enough";
  }
}

} // namespace
