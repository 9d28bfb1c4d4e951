#include "Planar/PlanarDelaunay.h"

#include "Base/Errors.h"
#include "Mesh/CoincidentPoints.h"
#include "Planar/Private/PlanarTriangles.h"
#include "Planar/Private/SegmentRecovery.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using KeepType = PlanarDelaunayOptions::KeepType;

void RequireSupportedFeatures(const Eigen::MatrixXd& points, const Eigen::MatrixXi& segments)
{
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!points.row(i).allFinite())
    {
      throw InvalidInput(
        "planar point " + std::to_string(i) + " is not finite; correct its coordinates");
    }
  }
  const double side = points.rows() > 0
    ? (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff()
    : 0.0;
  RequireOption(side == 0.0 || (side >= 1e-50 && side <= 1e50),
    "the longest side of the points' box", side, "between 1e-50 and 1e50");
  for (Eigen::Index i = 0; i < segments.rows(); ++i)
  {
    if (segments.row(i).minCoeff() < 0 || segments.row(i).maxCoeff() >= points.rows())
    {
      throw InvalidInput("segment " + std::to_string(i) +
        " refers to a missing point; there are only " + std::to_string(points.rows()) +
        " points, numbered from 0");
    }
  }
}

/// Returns the index of a cell along the Hilbert curve (1891) through a grid of 2^31 x 2^31 cells.
std::uint64_t AlongCurve(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t along = 0;
  for (std::uint32_t half = 1U << 30U; half > 0; half >>= 1U)
  {
    const bool isRight = (x & half) != 0, isUpper = (y & half) != 0;
    const unsigned int quarter = isRight ? (isUpper ? 2U : 3U) : (isUpper ? 1U : 0U);
    along = 4 * along + quarter;
    // The lower quarters of the curve are mirrored at a diagonal.
    if (!isUpper)
    {
      if (isRight)
      {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return along;
}

/// Returns the distinct points in an order in which consecutive points are close.
std::vector<int> InsertionOrder(const Eigen::MatrixXd& points, const Eigen::VectorXi& first)
{
  const Eigen::RowVector2d low = points.colwise().minCoeff();
  const double side = (points.colwise().maxCoeff() - low).maxCoeff();
  const double cells = side > 0.0 ? 2147483647.0 / side : 0.0;
  std::vector<std::pair<std::uint64_t, int>> keys;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    if (first(i) == i)
    {
      const Eigen::RowVector2d cell = cells * (points.row(i) - low);
      keys.emplace_back(
        AlongCurve(static_cast<std::uint32_t>(cell(0)), static_cast<std::uint32_t>(cell(1))), i);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [key, point] : keys)
  {
    order.push_back(point);
  }
  return order;
}

/// Inserts all points; returns false if they are collinear.
bool InsertAll(PlanarTriangles& plane, const std::vector<int>& order)
{
  // The first triangle needs three points that are not collinear.
  std::size_t third = 2;
  while (third < order.size() && plane.Turn(order[0], order[1], order[third]) == 0)
  {
    ++third;
  }
  if (third >= order.size())
  {
    return false;
  }
  plane.Start(order[0], order[1], order[third]);
  for (std::size_t i = 2; i < order.size(); ++i)
  {
    if (i != third)
    {
      plane.Insert(order[i]);
    }
  }
  return true;
}

/// Throws InvalidInput if the outlines are not closed. For Wound as many segments must enter a
/// point as leave it; for Oddly the number of segments at a point must be even.
void RequireClosed(const Eigen::MatrixXi& segments, const Eigen::VectorXi& first, KeepType keep)
{
  Eigen::VectorXi ends = Eigen::VectorXi::Zero(first.size());
  for (Eigen::Index i = 0; i < segments.rows(); ++i)
  {
    ++ends(first(segments(i, 0)));
    ends(first(segments(i, 1))) += keep == KeepType::Wound ? -1 : 1;
  }
  for (Eigen::Index point = 0; point < ends.size(); ++point)
  {
    if (keep == KeepType::Wound ? ends(point) != 0 : ends(point) % 2 != 0)
    {
      throw InvalidInput("the outlines are not closed: one ends at point " + std::to_string(point) +
        "; close the outline, or keep all triangles");
    }
  }
}

/// Returns the winding number of the segments around each triangle.
std::vector<int> Windings(const PlanarTriangles& plane)
{
  // The search starts at the triangles at infinity, which no outline encloses.
  std::vector<int> windings(plane.Sides() / 3, 0);
  std::vector<char> isReached(windings.size(), 0);
  std::vector<int> reached;
  for (int t = 0; t < static_cast<int>(windings.size()); ++t)
  {
    if (plane.IsFar(t))
    {
      isReached[t] = 1;
      reached.push_back(t);
    }
  }
  while (!reached.empty())
  {
    const int triangle = reached.back();
    reached.pop_back();
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      const int beyond = plane.Twin(side) / 3;
      if (isReached[beyond] == 0)
      {
        isReached[beyond] = 1;
        // To the left of an outline the winding number is greater by one than to its right.
        windings[beyond] = windings[triangle] - plane.Mark(side).Winding;
        reached.push_back(beyond);
      }
    }
  }
  return windings;
}

Eigen::MatrixXi KeptTriangles(const PlanarTriangles& plane, KeepType keep)
{
  const std::vector<int> windings = Windings(plane);
  Eigen::MatrixXi triangles(windings.size(), 3);
  Eigen::Index kept = 0;
  for (int t = 0; t < static_cast<int>(windings.size()); ++t)
  {
    const bool isInside =
      keep == KeepType::All || (keep == KeepType::Oddly ? windings[t] % 2 : windings[t]) != 0;
    if (isInside && !plane.IsFar(t))
    {
      triangles.row(kept++) << plane.Begin(3 * t), plane.Begin(3 * t + 1), plane.Begin(3 * t + 2);
    }
  }
  return triangles.topRows(kept);
}

/// Collects the marked edges, segment by segment and in order along each.
void AddEdges(const PlanarTriangles& plane, const Eigen::MatrixXi& segments,
  const SegmentRecovery& recovery, PlanarTriangulation& result)
{
  std::vector<std::tuple<int, double, int>> sides;
  for (int side = 0; side < plane.Sides(); ++side)
  {
    if (plane.Mark(side).Group < 0)
    {
      continue;
    }
    const int begin = plane.Begin(side), end = plane.End(side);
    for (const int segment : recovery.Group(plane.Mark(side).Group))
    {
      // Sorted by the coordinate along the longer axis, which needs no rounding.
      const Eigen::RowVector2d along =
        plane.Position(segments(segment, 1)) - plane.Position(segments(segment, 0));
      const int axis = std::abs(along(0)) >= std::abs(along(1)) ? 0 : 1;
      const double sign = along(axis) < 0.0 ? -1.0 : 1.0;
      const double from = sign * plane.Position(begin)(axis), to = sign * plane.Position(end)(axis);
      if (std::make_pair(from, begin) < std::make_pair(to, end))
      {
        sides.emplace_back(segment, from, side);
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  result.Edges.resize(static_cast<Eigen::Index>(sides.size()), 2);
  result.EdgeSegments.resize(result.Edges.rows());
  for (Eigen::Index i = 0; i < result.Edges.rows(); ++i)
  {
    const auto& [segment, from, side] = sides[i];
    result.Edges.row(i) << plane.Begin(side), plane.End(side);
    result.EdgeSegments(i) = segment;
  }
}

} // namespace

PlanarTriangulation TriangulateInPlane(const Eigen::MatrixXd& points,
  const Eigen::MatrixXi& segments, const PlanarDelaunayOptions& options)
{
  // Outline:
  // 1. The input is checked; points at the same position become one.
  // 2. Points are inserted one by one and edges flipped (Lawson 1977), along a curve, so that each
  //    insertion starts near the last one.
  // 3. Segments become edges, by flips (Lee and Lin 1986: constrained Delaunay).
  // 4. Triangles are kept by their winding number.
  // 5. The edges of each segment are collected.
  RequireSupportedFeatures(points, segments);
  const std::vector<int> first = FindCoincidentPoints(points);
  PlanarTriangulation result{ points, Eigen::MatrixXi(0, 3),
    Eigen::Map<const Eigen::VectorXi>(first.data(), points.rows()), Eigen::MatrixXi(0, 2), {} };
  const Eigen::Index outlines = options.Outlines < 0
    ? segments.rows()
    : std::min<Eigen::Index>(options.Outlines, segments.rows());
  if (options.Keep != KeepType::All)
  {
    RequireClosed(segments.topRows(outlines), result.SamePoint, options.Keep);
  }
  // Step 2: points.
  PlanarTriangles plane(points, options.Metric);
  if (points.rows() < 3 || !InsertAll(plane, InsertionOrder(points, result.SamePoint)))
  {
    return result;
  }
  // Step 3: segments.
  SegmentRecovery recovery(plane, options.AddCrossings, segments.rows());
  for (int i = 0; i < static_cast<int>(segments.rows()); ++i)
  {
    recovery.Recover(
      result.SamePoint(segments(i, 0)), result.SamePoint(segments(i, 1)), i, i < outlines ? 1 : 0);
  }
  result.Points.conservativeResize(plane.Points(), 2);
  for (auto i = static_cast<int>(points.rows()); i < plane.Points(); ++i)
  {
    result.Points.row(i) = plane.Position(i);
  }
  // Step 4: triangles that are kept.
  result.Triangles = KeptTriangles(plane, options.Keep);
  // Step 5: edges of the segments.
  AddEdges(plane, segments, recovery, result);
  return result;
}

} // namespace shape
