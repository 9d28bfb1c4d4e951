#include "Core/Orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace
{

/// A determinant of integers below 2^31, in 128 bits: the truth.
int Truth(const std::int64_t (&u)[3], const std::int64_t (&v)[3], const std::int64_t (&w)[3])
{
  const auto minor = [&](int i, int j)
  { return static_cast<__int128>(u[i]) * v[j] - static_cast<__int128>(u[j]) * v[i]; };
  const __int128 value = minor(1, 2) * w[0] + minor(2, 0) * w[1] + minor(0, 1) * w[2];
  return (value > 0) - (value < 0);
}

} // namespace

TEST(Orientation, AgreesWithIntegersOnAndBesideAPlane)
{
  std::mt19937_64 generator(5);
  const auto next = [&](std::int64_t limit)
  { return static_cast<std::int64_t>(generator() % (2 * limit)) - limit; };
  int zeros = 0;
  for (int round = 0; round < 20000; ++round)
  {
    std::int64_t a[3], u[3], v[3], w[3];
    const std::int64_t p = next(1000), q = next(1000);
    for (int k = 0; k < 3; ++k)
    {
      a[k] = next(1 << 30);
      u[k] = next(1 << 30);
      v[k] = next(1 << 30);
      // On the plane through a, a + u, a + v, or one step beside it.
      w[k] = p * u[k] + q * v[k] + (k == round % 3 ? round % 2 : 0);
    }
    Eigen::RowVector3d points[4];
    for (int k = 0; k < 3; ++k)
    {
      points[0](k) = static_cast<double>(a[k]);
      points[1](k) = static_cast<double>(a[k] + u[k]);
      points[2](k) = static_cast<double>(a[k] + v[k]);
      points[3](k) = static_cast<double>(a[k] + w[k]);
    }
    const int sign = shape::Orientation(points[0], points[1], points[2], points[3]);
    ASSERT_EQ(sign, Truth(u, v, w));
    ASSERT_EQ(shape::Orientation(points[1], points[0], points[2], points[3]), -sign);
    zeros += sign == 0;
  }
  EXPECT_GE(zeros, 10000);
}

TEST(Orientation, SeesTheLastBitOfACoordinate)
{
  // Differences that no double holds: 1 + 2^-52 against 2^-60.
  const double tiny = std::ldexp(1.0, -60), one = 1.0 + std::ldexp(1.0, -52);
  const Eigen::RowVector3d a(tiny, tiny, tiny), b(one, 0, 0), c(0, one, 0), d(0, 0, one);
  EXPECT_EQ(shape::Orientation(a, b, c, d), 1);
  const Eigen::RowVector3d middle(0.5 * one, 0.5 * one, 0), above(0.5 * one, 0.5 * one, 1e-300);
  EXPECT_EQ(shape::Orientation(b, c, d, middle), 0);
  EXPECT_EQ(shape::Orientation(b, c, d, above), -shape::Orientation(b, c, d, a));
  const Eigen::RowVector2d o(0.1, 0.1), p(0.2, 0.2), q(0.3, 0.3), r(0.3, std::nextafter(0.3, 1.0));
  EXPECT_EQ(shape::Orientation(o, p, q), 0);
  EXPECT_EQ(shape::Orientation(o, p, r), 1);
}
