// Facts checked: the band between a loop and a ring has its area, its points and its sides, each
// once; what they have in common is not in it.

#include "Base/Errors.h"
#include "CutPaste/Seam.h"
#include "Support/CurveShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace
{

Eigen::MatrixXd Circle(double radius, int corners, bool clockwise = false)
{
  Eigen::MatrixXd circle(corners, 2);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = (clockwise ? -2.0 : 2.0) * M_PI * i / corners;
    circle.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return circle;
}

double Area(const shape::SeamBand& band, const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring)
{
  Eigen::MatrixXd points(loop.rows() + ring.rows(), 2);
  points << loop, ring;
  double sum = 0.0;
  for (Eigen::Index t = 0; t < band.Triangles.rows(); ++t)
  {
    Eigen::MatrixXd corners(3, 2);
    for (int k = 0; k < 3; ++k)
    {
      corners.row(k) = points.row(band.Triangles(t, k));
    }
    EXPECT_GT(shapetest::PolygonArea(corners), 0.0);
    sum += shapetest::PolygonArea(corners);
  }
  return sum;
}

/// How many triangles have each edge.
std::map<std::pair<int, int>, int> EdgesOf(const shape::SeamBand& band)
{
  std::map<std::pair<int, int>, int> edges;
  for (Eigen::Index t = 0; t < band.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = band.Triangles(t, k), b = band.Triangles(t, (k + 1) % 3);
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  return edges;
}

TEST(Stitch, ABandFillsWhatIsBetween)
{
  for (const bool clockwise : { false, true })
  {
    const Eigen::MatrixXd loop = Circle(1.0, 37, clockwise), ring = Circle(1.4, 23);
    const shape::SeamBand band = shape::TriangulateSeamBand(loop, ring);
    EXPECT_EQ(band.Triangles.rows(), 37 + 23); // an annulus without points inside
    EXPECT_NEAR(Area(band, loop, ring),
      shapetest::PolygonArea(ring) - std::abs(shapetest::PolygonArea(loop)), 1e-12);
    const auto edges = EdgesOf(band);
    for (int i = 0; i < 37; ++i)
    {
      const int j = (i + 1) % 37;
      EXPECT_EQ(edges.at({ std::min(i, j), std::max(i, j) }), 1);
    }
    for (int i = 0; i < 23; ++i)
    {
      EXPECT_EQ(band.RingPoints(i), 37 + i);
      const int a = 37 + i, b = 37 + (i + 1) % 23;
      EXPECT_EQ(edges.at({ std::min(a, b), std::max(a, b) }), 1);
    }
  }
}

TEST(Stitch, TheSameLoopTwiceHasNothingBetween)
{
  const Eigen::MatrixXd loop = Circle(1.0, 12);
  Eigen::MatrixXd ring(12, 2);
  ring << loop.bottomRows(5), loop.topRows(7);
  const shape::SeamBand band = shape::TriangulateSeamBand(loop, ring);
  EXPECT_EQ(band.Triangles.rows(), 0);
  for (int i = 0; i < 12; ++i)
  {
    EXPECT_EQ(band.RingPoints(i), (7 + i) % 12);
  }
}

TEST(Stitch, CommonSidesAreNotInTheBand)
{
  // A square in a larger one, two of its sides on that one's.
  Eigen::MatrixXd loop(4, 2), ring(6, 2);
  loop << 0, 0, 1, 0, 1, 1, 0, 1;
  ring << 0, 0, 1, 0, 2, 0, 2, 2, 0, 2, 0, 1;
  const shape::SeamBand band = shape::TriangulateSeamBand(loop, ring);
  EXPECT_NEAR(Area(band, loop, ring), 3.0, 1e-15);
  EXPECT_EQ(band.RingPoints(0), 0);
  EXPECT_EQ(band.RingPoints(1), 1);
  EXPECT_EQ(band.RingPoints(5), 3);
  const auto edges = EdgesOf(band);
  EXPECT_EQ(edges.count({ 0, 1 }), 0U);
  EXPECT_EQ(edges.count({ 0, 3 }), 0U);
  EXPECT_EQ(edges.at({ 1, 2 }), 1);
  EXPECT_EQ(edges.at({ 2, 3 }), 1);
}

TEST(Stitch, CrossingLoopsAreRefused)
{
  EXPECT_THROW(shape::TriangulateSeamBand(
                 Circle(1.0, 12), Circle(1.0, 12) + Eigen::MatrixXd::Constant(12, 2, 0.3)),
    shape::InvalidInput);
}

} // namespace
