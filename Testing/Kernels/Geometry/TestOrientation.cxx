#include "Geometry/Orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
    const int sign = shape::EvaluateOrientation(points[0], points[1], points[2], points[3]);
    ASSERT_EQ(sign, Truth(u, v, w));
    ASSERT_EQ(shape::EvaluateOrientation(points[1], points[0], points[2], points[3]), -sign);
    zeros += sign == 0;
  }
  EXPECT_GE(zeros, 10000);
}

TEST(Orientation, SeesTheLastBitOfACoordinate)
{
  // Differences that no double holds: 1 + 2^-52 against 2^-60.
  const double tiny = std::ldexp(1.0, -60), one = 1.0 + std::ldexp(1.0, -52);
  const Eigen::RowVector3d a(tiny, tiny, tiny), b(one, 0, 0), c(0, one, 0), d(0, 0, one);
  EXPECT_EQ(shape::EvaluateOrientation(a, b, c, d), 1);
  const Eigen::RowVector3d middle(0.5 * one, 0.5 * one, 0), above(0.5 * one, 0.5 * one, 1e-300);
  EXPECT_EQ(shape::EvaluateOrientation(b, c, d, middle), 0);
  EXPECT_EQ(shape::EvaluateOrientation(b, c, d, above), -shape::EvaluateOrientation(b, c, d, a));
  const Eigen::RowVector2d o(0.1, 0.1), p(0.2, 0.2), q(0.3, 0.3), r(0.3, std::nextafter(0.3, 1.0));
  EXPECT_EQ(shape::EvaluateOrientation(o, p, q), 0);
  EXPECT_EQ(shape::EvaluateOrientation(o, p, r), 1);
}

TEST(Orientation, InCircleAgreesWithIntegersOnAndBesideACircle)
{
  // Of (3, 4, 5): the circle of radius 25 s through these places, all whole numbers.
  const std::int64_t positions[12][2] = { { 25, 0 }, { 24, 7 }, { 20, 15 }, { 15, 20 }, { 7, 24 },
    { 0, 25 }, { -7, 24 }, { -24, 7 }, { -25, 0 }, { -15, -20 }, { 0, -25 }, { 20, -15 } };
  std::mt19937_64 generator(6);
  for (int round = 0; round < 20000; ++round)
  {
    const std::int64_t scale = static_cast<std::int64_t>(generator() % 1000) + 1;
    const std::int64_t x = generator() % 100000, y = generator() % 100000;
    int picked[4];
    for (int& position : picked)
    {
      position = static_cast<int>(generator() % 12);
    }
    std::sort(picked, picked + 3);
    Eigen::RowVector2d points[4];
    for (int i = 0; i < 4; ++i)
    {
      points[i] << static_cast<double>(x + scale * positions[picked[i]][0]),
        static_cast<double>(y + scale * positions[picked[i]][1]);
    }
    const bool isTriangle = picked[0] < picked[1] && picked[1] < picked[2];
    ASSERT_EQ(shape::EvaluateInCircle(points[0], points[1], points[2], points[3]), 0);
    // The least step that such a number can take, inwards and outwards.
    const Eigen::RowVector2d outwards =
      points[3] - Eigen::RowVector2d(static_cast<double>(x), static_cast<double>(y));
    const int axis = std::abs(outwards(0)) > std::abs(outwards(1)) ? 0 : 1;
    for (const double side : { 1.0, -1.0 })
    {
      Eigen::RowVector2d moved = points[3];
      moved(axis) = std::nextafter(moved(axis), moved(axis) + side * outwards(axis));
      ASSERT_EQ(shape::EvaluateInCircle(points[0], points[1], points[2], moved),
        isTriangle ? -static_cast<int>(side) : 0);
    }
  }
}

TEST(Orientation, ASegmentMeetsATriangleWhereSomePlaceOfItIsInside)
{
  // Of small whole numbers, so that touching is as common as meeting. Inside, the three areas with
  // the triangle's sides are positive; the least of three such linear functions along the segment
  // is largest at one of its ends or where two of them are equal.
  std::mt19937 generator(8);
  const auto position = [&]
  {
    return std::array<std::int64_t, 2>{ static_cast<std::int64_t>(generator() % 7),
      static_cast<std::int64_t>(generator() % 7) };
  };
  const auto area = [](const auto& p, const auto& q, const auto& r)
  { return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); };
  int met = 0, apart = 0;
  while (met + apart < 20000)
  {
    const auto a = position(), b = position();
    const std::array<std::array<std::int64_t, 2>, 3> corners = { position(), position(),
      position() };
    if (a == b || area(corners[0], corners[1], corners[2]) <= 0)
    {
      continue;
    }
    std::array<std::int64_t, 3> first, slope;
    for (int k = 0; k < 3; ++k)
    {
      first[k] = area(corners[k], corners[(k + 1) % 3], a);
      slope[k] = area(corners[k], corners[(k + 1) % 3], b) - first[k];
    }
    const auto isInsideAt = [&](std::int64_t share, std::int64_t whole)
    {
      bool isInside = whole > 0 && share >= 0 && share <= whole;
      for (int k = 0; k < 3; ++k)
      {
        isInside = isInside && first[k] * whole + slope[k] * share > 0;
      }
      return isInside;
    };
    bool expected = isInsideAt(0, 1) || isInsideAt(1, 1);
    for (int k = 0; k < 3; ++k)
    {
      const int other = (k + 1) % 3;
      const std::int64_t share = first[other] - first[k], whole = slope[k] - slope[other];
      expected = expected || isInsideAt(share, whole) || isInsideAt(-share, -whole);
    }
    Eigen::Matrix<double, 3, 2> triangle;
    for (int k = 0; k < 3; ++k)
    {
      triangle.row(k) << static_cast<double>(corners[k][0]), static_cast<double>(corners[k][1]);
    }
    const Eigen::RowVector2d from(static_cast<double>(a[0]), static_cast<double>(a[1]));
    const Eigen::RowVector2d to(static_cast<double>(b[0]), static_cast<double>(b[1]));
    ASSERT_EQ(shape::SegmentMeetsTriangle(from, to, triangle), expected);
    ++(expected ? met : apart);
  }
  EXPECT_GT(met, 5000);
  EXPECT_GT(apart, 5000);
}
