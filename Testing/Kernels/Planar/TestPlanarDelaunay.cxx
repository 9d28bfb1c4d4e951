#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"
#include "Planar/PlanarDelaunay.h"
#include "Support/RandomPoints.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Keep = shape::PlanarDelaunayOptions::KeepType;
using Edge = std::pair<int, int>;

shape::PlanarDelaunayOptions Kept(Keep keep, bool addCrossings = false)
{
  shape::PlanarDelaunayOptions options;
  options.Keep = keep;
  options.AddCrossings = addCrossings;
  return options;
}

/// Whole numbers up to side - 1.
Eigen::MatrixXd Grid(int side)
{
  Eigen::MatrixXd points(side * side, 2);
  for (int i = 0; i < side * side; ++i)
  {
    points.row(i) << i % side, i / side;
  }
  return points;
}

Eigen::MatrixXi ClosedOutline(int begin, int count)
{
  Eigen::MatrixXi segments(count, 2);
  for (int i = 0; i < count; ++i)
  {
    segments.row(i) << begin + i, begin + (i + 1) % count;
  }
  return segments;
}

double Area(const shape::PlanarTriangulation& plane)
{
  double area = 0.0;
  for (const auto& t : plane.Triangles.rowwise())
  {
    const Eigen::RowVector2d u = plane.Points.row(t(1)) - plane.Points.row(t(0));
    const Eigen::RowVector2d v = plane.Points.row(t(2)) - plane.Points.row(t(0));
    area += 0.5 * (u(0) * v(1) - u(1) * v(0));
  }
  return area;
}

double OutlineArea(const Eigen::MatrixXd& points, const Eigen::MatrixXi& segments)
{
  double area = 0.0;
  for (const auto& s : segments.rowwise())
  {
    area += 0.5 * (points(s(0), 0) * points(s(1), 1) - points(s(0), 1) * points(s(1), 0));
  }
  return area;
}

/// What a triangulation has besides its triangles.
struct Facts
{
  int Misturned = 0;   ///< triangles that do not run counter-clockwise
  int NotDelaunay = 0; ///< free edges with a point inside the circle of a triangle beside them
  int Manifold = 0;    ///< edges that two triangles run along in the same sense
  int Euler = 0;       ///< of the points that are used
  std::set<Edge> Edges;
};

Facts ComputeExponentialFacts(const shape::PlanarTriangulation& plane)
{
  Facts facts;
  std::set<Edge> sides;
  std::set<int> used;
  for (const auto& t : plane.Triangles.rowwise())
  {
    facts.Misturned += static_cast<int>(shape::EvaluateOrientation(plane.Points.row(t(0)),
                                          plane.Points.row(t(1)), plane.Points.row(t(2))) <= 0);
    for (int k = 0; k < 3; ++k)
    {
      facts.Manifold += static_cast<int>(!sides.insert({ t(k), t((k + 1) % 3) }).second);
      facts.Edges.insert(std::minmax(t(k), t((k + 1) % 3)));
      used.insert(t(k));
    }
  }
  std::set<Edge> fixed;
  for (const auto& edge : plane.Edges.rowwise())
  {
    fixed.insert(std::minmax(edge(0), edge(1)));
  }
  if (plane.Triangles.rows() > 0)
  {
    const std::vector<int> twins = shape::FindTwins(plane.Triangles, plane.Points.rows());
    for (int side = 0; side < static_cast<int>(twins.size()); ++side)
    {
      const auto corner = [&](int at) { return plane.Triangles(at / 3, at % 3); };
      const auto position = [&](int at) -> Eigen::RowVector2d
      { return plane.Points.row(corner(at)); };
      const int begin = corner(side), end = corner(shape::NextHalfEdge(side));
      if (twins[side] >= 0 && fixed.count(std::minmax(begin, end)) == 0)
      {
        facts.NotDelaunay += static_cast<int>(
          shape::EvaluateInCircle(position(side), position(shape::NextHalfEdge(side)),
            position(shape::PreviousHalfEdge(side)),
            position(shape::PreviousHalfEdge(twins[side]))) > 0);
      }
    }
  }
  facts.Euler = static_cast<int>(used.size()) - static_cast<int>(facts.Edges.size()) +
    static_cast<int>(plane.Triangles.rows());
  return facts;
}

/// That it is a constrained Delaunay triangulation which has every segment as edges.
Facts ExpectDelaunay(const shape::PlanarTriangulation& plane)
{
  Facts facts = ComputeExponentialFacts(plane);
  EXPECT_EQ(facts.Misturned, 0);
  EXPECT_EQ(facts.NotDelaunay, 0);
  EXPECT_EQ(facts.Manifold, 0);
  return facts;
}

/// The share of each segment that its edges, all of them in the triangulation, make up.
Eigen::VectorXd SharesOfSegments(const shape::PlanarTriangulation& plane,
  const Eigen::MatrixXi& segments, const std::set<Edge>& edges)
{
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(segments.rows());
  for (Eigen::Index i = 0; i < plane.Edges.rows(); ++i)
  {
    const int segment = plane.EdgeSegments(i);
    EXPECT_EQ(edges.count(std::minmax(plane.Edges(i, 0), plane.Edges(i, 1))), 1U);
    shares(segment) +=
      (plane.Points.row(plane.Edges(i, 1)) - plane.Points.row(plane.Edges(i, 0))).norm() /
      (plane.Points.row(segments(segment, 1)) - plane.Points.row(segments(segment, 0))).norm();
  }
  return shares;
}

/// Random segments that share no point and do not cross.
Eigen::MatrixXi RandomSegments(const Eigen::MatrixXd& points, int tries, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<Edge> kept;
  std::set<int> used;
  for (int i = 0; i < tries; ++i)
  {
    const int a = static_cast<int>(random() % points.rows());
    const int b = static_cast<int>(random() % points.rows());
    const auto side = [&](int p, int q, int r)
    {
      return shape::EvaluateOrientation(Eigen::RowVector2d(points.row(p)),
        Eigen::RowVector2d(points.row(q)), Eigen::RowVector2d(points.row(r)));
    };
    const bool crosses = std::any_of(kept.begin(), kept.end(),
      [&](const Edge& other)
      {
        const auto [c, d] = other;
        return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
      });
    if (points.row(a) != points.row(b) && !crosses && used.count(a) + used.count(b) == 0)
    {
      kept.emplace_back(a, b);
      used.insert({ a, b });
    }
  }
  Eigen::MatrixXi segments(kept.size(), 2);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    segments.row(i) << kept[i].first, kept[i].second;
  }
  return segments;
}

} // namespace

TEST(PlanarDelaunay, CirclesAreEmpty)
{
  const Eigen::MatrixXd points = shapetest::RandomPointsInSquare(300, 1);
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points);
  EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
  for (const auto& t : plane.Triangles.rowwise())
  {
    for (int i = 0; i < 300; ++i)
    {
      ASSERT_LE(shape::EvaluateInCircle(Eigen::RowVector2d(points.row(t(0))),
                  Eigen::RowVector2d(points.row(t(1))), Eigen::RowVector2d(points.row(t(2))),
                  Eigen::RowVector2d(points.row(i))),
        0);
    }
  }
  const shape::PlanarTriangulation again = shape::TriangulateInPlane(points);
  EXPECT_EQ(plane.Triangles, again.Triangles);
}

TEST(PlanarDelaunay, AGridIsAllOnCircles)
{
  const int side = 40;
  for (const double scale : { 1.0, 0.1, 1e-30 })
  {
    const shape::PlanarTriangulation plane = shape::TriangulateInPlane(scale * Grid(side));
    EXPECT_EQ(plane.Triangles.rows(), 2 * (side - 1) * (side - 1));
    EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
    EXPECT_NEAR(Area(plane), scale * scale * (side - 1) * (side - 1), 1e-9 * scale * scale);
  }
}

TEST(PlanarDelaunay, PointsOfACircleAndItsMiddle)
{
  const int count = 1000;
  Eigen::MatrixXd points(count + 1, 2);
  for (int i = 0; i < count; ++i)
  {
    points.row(i) << std::cos(2.0 * M_PI * i / count), std::sin(2.0 * M_PI * i / count);
  }
  points.row(count) << 0.0, 0.0;
  const Eigen::MatrixXi outline = ClosedOutline(0, count);
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points, outline);
  EXPECT_EQ(plane.Triangles.rows(), count);
  EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
  EXPECT_NEAR(Area(plane), OutlineArea(points, outline), 1e-12);
}

TEST(PlanarDelaunay, PointsOnOneLineHaveNoTriangle)
{
  Eigen::MatrixXd points(5, 2);
  points << 0, 0, 1, 1, 0.25, 0.25, 3, 3, 2, 2;
  EXPECT_EQ(shape::TriangulateInPlane(points, ClosedOutline(0, 2)).Triangles.rows(), 0);
  EXPECT_EQ(shape::TriangulateInPlane(points.topRows(0)).Triangles.rows(), 0);
  // One beside it makes a fan.
  points.conservativeResize(6, 2);
  points.row(5) << 1, 0;
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points);
  EXPECT_EQ(plane.Triangles.rows(), 4);
  EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
}

TEST(PlanarDelaunay, DuplicatesAreMergedIntoTheFirst)
{
  const Eigen::MatrixXd once = shapetest::RandomPointsInSquare(200, 2);
  Eigen::MatrixXd points(600, 2);
  points << once, once.colwise().reverse(), once;
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points);
  EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
  EXPECT_EQ(plane.Triangles.rows(), shape::TriangulateInPlane(once).Triangles.rows());
  for (int i = 0; i < 200; ++i)
  {
    EXPECT_EQ(plane.SamePoint(i), i);
    EXPECT_EQ(plane.SamePoint(200 + i), 199 - i);
    EXPECT_EQ(plane.SamePoint(400 + i), i);
  }
  EXPECT_LT(plane.Triangles.maxCoeff(), 200);
}

TEST(PlanarDelaunay, SegmentsBecomeEdges)
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    Eigen::MatrixXd points = shapetest::RandomPointsInSquare(400, 10 + seed);
    if (seed % 3 == 1)
    {
      points = (20.0 * points).array().round(); // many on one line, on one circle, or the same
    }
    else if (seed % 3 == 2)
    {
      points.col(1) *= 1e-9;
    }
    const Eigen::MatrixXi segments = RandomSegments(points, 400, seed);
    const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points, segments);
    const Facts facts = ExpectDelaunay(plane);
    EXPECT_EQ(facts.Euler, 1);
    const Eigen::VectorXd shares = SharesOfSegments(plane, segments, facts.Edges);
    EXPECT_LT((shares.array() - 1.0).abs().maxCoeff(), 1e-6) << seed;
  }
}

TEST(PlanarDelaunay, ALongSegmentCrossesEverything)
{
  // Two rows of points, each near the segment, and a cloud.
  Eigen::MatrixXd points(4002, 2);
  points.topRows(3000) = shapetest::RandomPointsInSquare(3000, 3);
  for (int i = 0; i < 1000; ++i)
  {
    points.row(3000 + i) << 0.001 * i, 0.5 + (i % 2 == 0 ? 1e-9 : -1e-9) * (i + 1);
  }
  points.row(4000) << -1.0, 0.5;
  points.row(4001) << 2.0, 0.5;
  Eigen::MatrixXi segments(1, 2);
  segments << 4000, 4001;
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points, segments);
  const Facts facts = ExpectDelaunay(plane);
  EXPECT_EQ(facts.Euler, 1);
  EXPECT_EQ(plane.Edges.rows(), 1);
  EXPECT_EQ(facts.Edges.count({ 4000, 4001 }), 1U);
}

TEST(PlanarDelaunay, AnOutlineWithAHole)
{
  // A star around a star turned the same way: even-odd leaves a hole, winding does not.
  const int count = 50;
  Eigen::MatrixXd points(2 * count + 500, 2);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count, radius = i % 2 == 0 ? 1.0 : 0.6;
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
    points.row(count + i) = 0.5 * points.row(i);
  }
  points.bottomRows(500) = 2.4 * (shapetest::RandomPointsInSquare(500, 4).array() - 0.5);
  Eigen::MatrixXi segments(2 * count, 2);
  segments << ClosedOutline(0, count), ClosedOutline(count, count);
  const double outer = OutlineArea(points, segments.topRows(count));
  const double inner = OutlineArea(points, segments.bottomRows(count));

  const shape::PlanarTriangulation ring =
    shape::TriangulateInPlane(points, segments, Kept(Keep::Oddly));
  EXPECT_EQ(ExpectDelaunay(ring).Euler, 0);
  EXPECT_NEAR(Area(ring), outer - inner, 1e-12);
  const shape::PlanarTriangulation whole =
    shape::TriangulateInPlane(points, segments, Kept(Keep::Wound));
  EXPECT_EQ(ExpectDelaunay(whole).Euler, 1);
  EXPECT_NEAR(Area(whole), outer, 1e-12);
  segments.bottomRows(count) = segments.bottomRows(count).rowwise().reverse().eval();
  const shape::PlanarTriangulation turned =
    shape::TriangulateInPlane(points, segments, Kept(Keep::Wound));
  EXPECT_NEAR(Area(turned), outer - inner, 1e-12);
}

TEST(PlanarDelaunay, SegmentsInsideAnOutlineBoundNothing)
{
  // A square and its diagonals, the first two points of which are not corners.
  Eigen::MatrixXd points(6, 2);
  points << 0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 2, 2;
  Eigen::MatrixXi segments(7, 2);
  segments << ClosedOutline(0, 4), 0, 2, 1, 3, 4, 5;
  shape::PlanarDelaunayOptions options = Kept(Keep::Oddly, true);
  options.Outlines = 4;
  const shape::PlanarTriangulation plane = shape::TriangulateInPlane(points, segments, options);
  EXPECT_EQ(ExpectDelaunay(plane).Euler, 1);
  EXPECT_EQ(Area(plane), 9.0);
  EXPECT_EQ(plane.Points.rows(), 7);
  // 1, 1, 1, 1; 0-4-6-5-2; 1-6-3; 4-6-5.
  EXPECT_EQ(plane.Edges.rows(), 4 + 4 + 2 + 2);
}

TEST(PlanarDelaunay, AnOutlineThatTouchesItself)
{
  // Two squares with a common corner, and two with a common side, which is run through twice.
  Eigen::MatrixXd points(8, 2);
  points << 0, 0, 1, 0, 1, 1, 0, 1, 1, 1, 2, 1, 2, 2, 1, 2;
  Eigen::MatrixXi segments(8, 2);
  segments << ClosedOutline(0, 4), ClosedOutline(4, 4);
  EXPECT_EQ(Area(shape::TriangulateInPlane(points, segments, Kept(Keep::Oddly))), 2.0);
  points.bottomRows(4) << 1, 0, 2, 0, 2, 1, 1, 1;
  EXPECT_EQ(Area(shape::TriangulateInPlane(points, segments, Kept(Keep::Oddly))), 2.0);
  const shape::PlanarTriangulation beside =
    shape::TriangulateInPlane(points, segments, Kept(Keep::Wound));
  EXPECT_EQ(Area(beside), 2.0);
  EXPECT_EQ(beside.EdgeSegments, Eigen::VectorXi::LinSpaced(8, 0, 7));
}

TEST(PlanarDelaunay, CrossingsAreNamedOrAdded)
{
  Eigen::MatrixXd points(4, 2);
  points << 0, 0, 4, 4, 0, 4, 4, 0;
  Eigen::MatrixXi segments(3, 2);
  segments << 0, 2, 0, 1, 2, 3;
  EXPECT_REFUSED(shape::TriangulateInPlane(points, segments), "segments 1 and 2 cross at (2, 2)");
  const shape::PlanarTriangulation plane =
    shape::TriangulateInPlane(points, segments, Kept(Keep::All, true));
  EXPECT_EQ(plane.Points.row(4), Eigen::RowVector2d(2, 2));
  EXPECT_EQ(plane.Triangles.rows(), 4);
  EXPECT_EQ(plane.Edges.rows(), 5);

  // Many of them, also where three meet.
  for (unsigned int seed = 0; seed < 10; ++seed)
  {
    const Eigen::MatrixXd positions = seed % 2 == 0
      ? shapetest::RandomPointsInSquare(60, seed)
      : (8.0 * shapetest::RandomPointsInSquare(60, seed)).array().round();
    const shape::PlanarTriangulation star =
      shape::TriangulateInPlane(positions, ClosedOutline(0, 60), Kept(Keep::Oddly, true));
    ExpectDelaunay(star);
    EXPECT_GT(Area(star), 0.0);
  }
}

TEST(PlanarDelaunay, APentagramIsWoundTwiceInside)
{
  Eigen::MatrixXd points(5, 2);
  for (int i = 0; i < 5; ++i)
  {
    points.row(i) << std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i);
  }
  const Eigen::MatrixXi star = ClosedOutline(0, 5);
  const double signedArea = OutlineArea(points, star); // counts the pentagon inside twice
  const double pentagon =
    2.5 * std::sin(0.4 * M_PI) * std::pow(std::sin(0.1 * M_PI) / std::cos(0.2 * M_PI), 2);
  EXPECT_NEAR(Area(shape::TriangulateInPlane(points, star, Kept(Keep::Wound, true))),
    signedArea - pentagon, 1e-14);
  EXPECT_NEAR(Area(shape::TriangulateInPlane(points, star, Kept(Keep::Oddly, true))),
    signedArea - 2.0 * pentagon, 1e-14);
}

TEST(PlanarDelaunay, CirclesOfAnotherMetric)
{
  // Whatever the coordinates, the triangles are those of the places that they stand for.
  const Eigen::MatrixXd points = shapetest::RandomPointsInSquare(300, 6);
  shape::PlanarDelaunayOptions options;
  options.Metric << 5.0, 2.0, -1.0, 0.25;
  const shape::PlanarTriangulation sheared = shape::TriangulateInPlane(points, {}, options);
  shape::PlanarTriangulation images = sheared;
  images.Points *= options.Metric;
  EXPECT_EQ(ExpectDelaunay(images).Euler, 1);
  EXPECT_GT(ComputeExponentialFacts(sheared).NotDelaunay, 0);
  // Without area there is no circle, but triangles all the same.
  options.Metric.col(1).setZero();
  const shape::PlanarTriangulation flat = shape::TriangulateInPlane(Grid(5), {}, options);
  EXPECT_EQ(flat.Triangles.rows(), 32);
  EXPECT_EQ(ComputeExponentialFacts(flat).Misturned, 0);
}

TEST(PlanarDelaunay, NamesWhatIsWrong)
{
  Eigen::MatrixXd points = shapetest::RandomPointsInSquare(10, 5);
  EXPECT_THROW(shape::TriangulateInPlane(points, ClosedOutline(0, 11)), shape::InvalidInput);
  EXPECT_THROW(shape::TriangulateInPlane(points, ClosedOutline(0, 3).topRows(2), Kept(Keep::Oddly)),
    shape::InvalidInput);
  EXPECT_THROW(shape::TriangulateInPlane(1e60 * points), shape::InvalidInput);
  points(3, 1) = NAN;
  EXPECT_THROW(shape::TriangulateInPlane(points), shape::InvalidInput);
}
