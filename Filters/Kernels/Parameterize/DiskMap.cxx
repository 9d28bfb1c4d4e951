#include "Parameterize/DiskMap.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

/// Minimum length of a loop edge / length of the loop; the ends of a shorter edge share one angle.
constexpr double ShortestLoopEdge = 1e-14;

/// Rotates the loop so that the point with the greatest coordinates comes first; among coincident
/// points the one with the lowest number.
void StartAtGreatest(std::vector<int>& loop, const Eigen::MatrixXd& points)
{
  const auto comesBefore = [&](int a, int b)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (points(a, axis) != points(b, axis))
      {
        return points(a, axis) > points(b, axis);
      }
    }
    return a < b;
  };
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), comesBefore), loop.end());
}

/// Returns the arc length from the loop's first point to each point, and the total length (k + 1).
Eigen::VectorXd ArcLengths(const std::vector<int>& loop, const Eigen::MatrixXd& points)
{
  Eigen::VectorXd lengths(loop.size() + 1);
  lengths(0) = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int next = loop[(i + 1) % loop.size()];
    lengths(i + 1) = lengths(i) + (points.row(next) - points.row(loop[i])).norm();
  }
  int flat = 0, first = -1;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    if (!(lengths(i + 1) - lengths(i) > ShortestLoopEdge * lengths(loop.size())))
    {
      first = flat++ == 0 ? loop[i] : first;
    }
  }
  if (flat > 0)
  {
    throw InvalidInput("the surface's open loop has " + std::to_string(flat) +
      (flat == 1 ? " edge" : " edges") + " without length (first at point " +
      std::to_string(first) + "); merge its duplicate points with Clean");
  }
  return lengths;
}

Eigen::MatrixXd OnCircle(const Eigen::VectorXd& lengths)
{
  const Eigen::Index count = lengths.size() - 1;
  Eigen::MatrixXd positions(count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * lengths(i) / lengths(count);
    positions.row(i) << std::cos(angle), std::sin(angle);
  }
  return positions;
}

/// Returns the rows of `lengths` that are mapped to the corners (1, 1), (-1, 1), (-1, -1), (1, -1),
/// and the number of rows.
std::array<int, 5> Corners(const Eigen::VectorXd& lengths)
{
  const int count = static_cast<int>(lengths.size()) - 1;
  if (count < 4)
  {
    throw InvalidInput("the surface's open loop has " + std::to_string(count) +
      " points, but a square has 4 corners; use the outline Circle");
  }
  std::array<int, 5> corners{ 0, 0, 0, 0, count };
  for (int k = 1; k < 4; ++k)
  {
    // At least one point must remain for each of the following corners.
    int best = corners[k - 1] + 1;
    for (int i = best + 1; i <= count - 4 + k; ++i)
    {
      // The corner is the loop's point closest to this share of its length.
      const double quarter = 0.25 * k * lengths(count);
      best = std::abs(lengths(i) - quarter) < std::abs(lengths(best) - quarter) ? i : best;
    }
    corners[k] = best;
  }
  return corners;
}

Eigen::MatrixXd OnSquare(const Eigen::VectorXd& lengths, const std::array<int, 5>& corners)
{
  const Eigen::Matrix<double, 5, 2> ends =
    (Eigen::Matrix<double, 5, 2>() << 1, 1, -1, 1, -1, -1, 1, -1, 1, 1).finished();
  Eigen::MatrixXd positions(lengths.size() - 1, 2);
  for (int side = 0; side < 4; ++side)
  {
    const double begin = lengths(corners[side]);
    const double length = lengths(corners[side + 1]) - begin;
    for (int i = corners[side]; i < corners[side + 1]; ++i)
    {
      const double share = (lengths(i) - begin) / length;
      // Interpolated from the end that shares a coordinate with this point, which stays exactly 1
      // or -1.
      positions.row(i) = ends.row(side) + share * (ends.row(side + 1) - ends.row(side));
    }
  }
  return positions;
}

/// Throws InvalidInput if an inner edge joins two points of one side: what it cuts off would
/// collapse onto that side (Floater 2003, "One-to-one piecewise linear mappings over
/// triangulations", theorem 4.1).
void RequireNoEdgeAcrossASide(
  const Mesh& surface, const std::vector<int>& loop, const std::array<int, 5>& corners)
{
  const int count = static_cast<int>(loop.size());
  std::vector<int> row(surface.Points.rows(), -1);
  std::vector<int> sidesOf(surface.Points.rows(), 0); // one bit for each side
  for (int i = 0; i < count; ++i)
  {
    row[loop[i]] = i;
  }
  for (int side = 0; side < 4; ++side)
  {
    for (int i = corners[side]; i <= corners[side + 1]; ++i)
    {
      sidesOf[loop[i % count]] |= 1 << side;
    }
  }
  int edges = 0;
  std::array<int, 2> first{ -1, -1 };
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int a = surface.Triangles(t, corner);
      const int b = surface.Triangles(t, (corner + 1) % 3);
      const bool crosses = (sidesOf[a] & sidesOf[b]) != 0 && (row[a] + 1) % count != row[b];
      // An inner edge is visited once from each of its triangles.
      if (crosses && a < b)
      {
        first = edges++ == 0 ? std::array<int, 2>{ a, b } : first;
      }
    }
  }
  if (edges > 0)
  {
    throw InvalidInput("the surface has " + std::to_string(edges) + " inner " +
      (edges == 1 ? "edge that joins" : "edges that join") +
      " two points of one side of the square (first from point " + std::to_string(first[0]) +
      " to " + std::to_string(first[1]) +
      "), so triangles would lose their area; use the outline Circle");
  }
}

void RequireNoFlip(const Mesh& surface, const Eigen::MatrixXd& image, CombinationWeights weights)
{
  std::vector<int> flipped;
  for (int t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = surface.Triangles.row(t);
    // Triangles without area are treated as flipped.
    if (EvaluateOrientation(image.row(corners(0)), image.row(corners(1)), image.row(corners(2))) <=
      0)
    {
      flipped.push_back(t);
    }
  }
  if (flipped.empty())
  {
    return;
  }
  const std::string count = std::to_string(flipped.size()) + " of " +
    std::to_string(surface.Triangles.rows()) + " triangles (first triangle " +
    std::to_string(flipped[0]) + ")";
  if (weights == CombinationWeights::Cotangent)
  {
    throw SolveFailure("Cotangent weights flip " + count +
      ", which is possible if angles are obtuse; use MeanValue weights");
  }
  throw SolveFailure("on the disk, " + count +
    " are too small for double precision: an extremity shrinks exponentially with the ratio of its "
    "length to its girth; cut it off with Shape Cut Feature, or fill the hole with Shape Fill "
    "Holes and map onto the Sphere with a positive AreaWeight");
}

} // namespace

DiskMapResult MapToDisk(
  const Surface& surface, const DiskMapOptions& options, const Progress& progress)
{
  progress(0.0);
  // Outline:
  // 1. The loop starts at the point with the greatest x. The surface is scaled, so the map does not
  //    depend on its position and size.
  // 2. The loop is mapped to the outline by arc length.
  // 3. Every other point is the weighted mean of its neighbours.
  // 4. Each triangle is checked with exact predicates.
  RequireSurfaceWithBoundary(surface, LoopCount::One);
  progress(0.1);
  DiskMapResult result;
  // Step 1: the loop.
  result.Loop = FindManifoldBoundaryLoops(surface).front();
  StartAtGreatest(result.Loop, surface.Points());
  const double size = ComputeLongestBoxEdge(surface);
  Mesh scaled = surface;
  scaled.Points.rowwise() -= surface.Points().row(result.Loop[0]);
  scaled.Points /= size > 0.0 ? size : 1.0;
  const Eigen::VectorXd lengths = ArcLengths(result.Loop, scaled.Points);
  result.LoopLength = size * lengths(result.Loop.size());

  // Step 2: the outline.
  Eigen::MatrixXd positions;
  if (options.Outline == DiskOutline::Circle)
  {
    positions = OnCircle(lengths);
  }
  else
  {
    const std::array<int, 5> corners = Corners(lengths);
    RequireNoEdgeAcrossASide(surface, result.Loop, corners);
    positions = OnSquare(lengths, corners);
  }
  progress(0.2);
  // Step 3: convex combinations.
  const Eigen::MatrixXd image = SolveConvexCombination(scaled, options.Weights, result.Loop,
    positions, progress.Part(0.2, 0.9, "mapping to the disk"));
  // Step 4: no flip.
  RequireNoFlip(surface, image, options.Weights);
  result.Points = Eigen::MatrixXd::Zero(surface.Points().rows(), 3);
  result.Points.leftCols(2) = image;
  progress(1.0);
  return result;
}

} // namespace shape
