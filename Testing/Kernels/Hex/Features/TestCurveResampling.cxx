#include "Hex/Features/Private/CurveResampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

/// A regular polygon of radius 1; begin: the angle of its first corner, in radians.
Eigen::MatrixXd Polygon(int corners, double begin = 0.0)
{
  Eigen::MatrixXd points(corners, 3);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = begin + 2.0 * M_PI * i / corners;
    points.row(i) << std::cos(angle), std::sin(angle), 0.0;
  }
  return points;
}

/// A polygon as a closed curve, and its points.
struct ClosedCurve
{
  explicit ClosedCurve(int corners)
  {
    this->Points.Points = Polygon(corners);
    this->Curve.Closed = true;
    this->Curve.Points.resize(corners);
    std::iota(this->Curve.Points.begin(), this->Curve.Points.end(), 0);
  }

  Mesh Points;
  FeatureCurve Curve;
};

double DistanceToSegment(
  const Eigen::RowVector3d& point, const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + share * (b - a) - point).norm();
}

/// The largest distance of a curve's points from a closed polyline.
double FindLargestDistance(const Eigen::MatrixXd& curve, const Eigen::MatrixXd& line)
{
  double largest = 0.0;
  for (Eigen::Index i = 0; i < curve.rows(); ++i)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < line.rows(); ++k)
    {
      nearest = std::min(
        nearest, DistanceToSegment(curve.row(i), line.row(k), line.row((k + 1) % line.rows())));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

} // namespace

// Evenly spaced, the third of 30 points is at every second corner of 20, and edges cut off the
// others by a third of an edge times sin(9 degrees).
TEST(CurveResampling, EnoughPointsCutOffNoBend)
{
  const ClosedCurve circle(20);
  const Eigen::MatrixXd chain = Polygon(30, 0.05);
  const CurvePositions found = DistributeAlongCurve(chain, circle.Points, circle.Curve, 1e-3);
  EXPECT_GT(FindLargestDistance(circle.Points.Points, Polygon(30)), 4e-3);
  EXPECT_LT(FindLargestDistance(circle.Points.Points, found.Positions), 1e-12);
}

// A long edge has its bends in reach, although they are more than a mean edge from its ends.
TEST(CurveResampling, PointsReachTheBendsOfLongEdges)
{
  const ClosedCurve circle(20);
  const Eigen::MatrixXd even = Polygon(72, 0.05);
  Eigen::MatrixXd chain(60, 3);
  for (int i = 0, row = 0; i < 72; ++i)
  {
    // Every third corner is left out along half of the circle and two more.
    if (i % 3 != 0 || i >= 36)
    {
      chain.row(row++) = even.row(i);
    }
  }
  const CurvePositions found = DistributeAlongCurve(chain, circle.Points, circle.Curve, 1e-3);
  EXPECT_LT(FindLargestDistance(circle.Points.Points, found.Positions), 1e-12);
}

// The points of a layer lie at those that they copy: none of the edges of a chain stays without a
// length, and the points still move to the bends.
TEST(CurveResampling, EdgesWithoutLengthGetOne)
{
  const ClosedCurve circle(20);
  const Eigen::MatrixXd even = Polygon(30, 0.05);
  Eigen::MatrixXd chain(32, 3);
  chain << even.row(0), even, even.row(29);
  const CurvePositions found = DistributeAlongCurve(chain, circle.Points, circle.Curve, 1e-3);
  EXPECT_LT(FindLargestDistance(circle.Points.Points, found.Positions), 1e-12);
  for (Eigen::Index i = 0; i < chain.rows(); ++i)
  {
    const double step =
      (found.Positions.row((i + 1) % chain.rows()) - found.Positions.row(i)).norm();
    EXPECT_GT(step, 0.1 * 2.0 * M_PI / 32);
  }
}

// A square whose corner is a quarter of a circle of 10 edges, which are shorter than those of the
// chain: evenly spaced points would cut off its bends.
TEST(CurveResampling, PointsGatherWhereTheCurveBends)
{
  constexpr int arc = 10;
  constexpr double radius = 0.3;
  ClosedCurve square(arc + 4);
  Eigen::MatrixXd& corners = square.Points.Points;
  for (int i = 0; i <= arc; ++i)
  {
    const double angle = 0.5 * M_PI * i / arc;
    corners.row(i) << 1.0 - radius + radius * std::cos(angle),
      1.0 - radius + radius * std::sin(angle), 0.0;
  }
  corners.bottomRows<3>() << -1.0, 1.0, 0.0, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0;
  constexpr int edges = 100; // of a length of 0.08: they cut off up to 0.08^2 / (8 radius)
  constexpr double tolerance = 1e-3;
  Eigen::MatrixXd chain(edges, 3);
  const double length = 8.0 - 2.0 * radius + 0.5 * M_PI * radius;
  for (int i = 0; i < edges; ++i)
  {
    // The chain is not rounded: a point after (1, 1 - radius) at a fraction of the curve's length.
    const double along = std::fmod((i + 0.4) * length / edges + 2.0 - radius, 8.0);
    const int side = static_cast<int>(along / 2.0);
    const double on = along - 2.0 * side - 1.0;
    chain.row(i) << (side == 0 ? 1.0
        : side == 1            ? -on
        : side == 2            ? -1.0
                               : on),
      (side == 0      ? on
          : side == 1 ? 1.0
          : side == 2 ? -on
                      : -1.0),
      0.0;
  }
  const CurvePositions found = DistributeAlongCurve(chain, square.Points, square.Curve, tolerance);
  EXPECT_LT(FindLargestDistance(corners, found.Positions), tolerance);
}

// Points stay evenly spaced where no edge deviates by more than a small part of the tolerance.
TEST(CurveResampling, NearChainsStayEven)
{
  const ClosedCurve circle(200);
  const CurvePositions found =
    DistributeAlongCurve(Polygon(150, 0.01), circle.Points, circle.Curve, 0.05);
  for (Eigen::Index i = 0; i < found.Positions.rows(); ++i)
  {
    const double step =
      (found.Positions.row((i + 1) % found.Positions.rows()) - found.Positions.row(i)).norm();
    EXPECT_NEAR(step, 2.0 * std::sin(M_PI / 150), 1e-3);
  }
}

// 1 - cos(pi / 30) is 0.0055, and edges twice as long as even ones deviate four times as much.
TEST(CurveResampling, PointsMoveOnlyAsFarAsEdgesStayNear)
{
  const ClosedCurve circle(300);
  constexpr double tolerance = 0.009;
  CurvePositions found =
    DistributeAlongCurve(Polygon(30, 0.01), circle.Points, circle.Curve, tolerance);
  // Every second edge becomes as long as its ends can make it.
  bool hasMoved = false;
  for (Eigen::Index i = 0; i < found.Positions.rows(); ++i)
  {
    const Eigen::MatrixXd& span = found.Spans[i];
    ASSERT_GT(span.rows(), 1);
    const Eigen::Index next = (i + 1) % found.Positions.rows(),
                       before = (i + found.Positions.rows() - 1) % found.Positions.rows();
    const Eigen::RowVector3d from = found.Positions.row(i % 2 == 0 ? next : before);
    const auto distance = [&](Eigen::Index row) { return (span.row(row) - from).norm(); };
    const Eigen::Index last = span.rows() - 1;
    hasMoved = hasMoved || (span.row(0) - span.row(last)).norm() > 0.01;
    found.Positions.row(i) = span.row(distance(0) > distance(last) ? 0 : last);
  }
  EXPECT_TRUE(hasMoved);
  EXPECT_LT(FindLargestDistance(circle.Points.Points, found.Positions), tolerance);
}

} // namespace shape
