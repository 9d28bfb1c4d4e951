#include "Planar/TriangleSplit.h"

#include "Base/Errors.h"
#include "Planar/PlanarDelaunay.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{
namespace
{

/// Returns the linear map from the second and third barycentric coordinate to the triangle's plane.
Eigen::Matrix2d MetricOf(const Eigen::Matrix3d& corners)
{
  const Eigen::RowVector3d u = corners.row(1) - corners.row(0), v = corners.row(2) - corners.row(0);
  const double size = std::max(u.norm(), v.norm());
  const double length = u.norm();
  Eigen::Matrix2d metric = Eigen::Matrix2d::Zero();
  if (length > 0.0)
  {
    metric << length / size, 0.0, u.dot(v) / (length * size), u.cross(v).norm() / (length * size);
  }
  return metric;
}

/// Returns the points along a chord, whose edges are in any order.
std::vector<int> ChainOf(const std::array<int, 2>& chord, const PlanarTriangulation& plane,
  Eigen::Index first, Eigen::Index last)
{
  std::vector<int> chain = { chord[0] };
  std::vector<char> isUsed(last - first, 0);
  while (chain.back() != chord[1])
  {
    Eigen::Index next = first;
    while (next < last &&
      (isUsed[next - first] != 0 || (plane.Edges.row(next).array() != chain.back()).all()))
    {
      ++next;
    }
    if (next == last)
    {
      throw SolveFailure("the loop crosses itself too near to an edge of the surface; draw a loop "
                         "that does not cross itself");
    }
    isUsed[next - first] = 1;
    chain.push_back(plane.Edges.row(next).sum() - chain.back());
  }
  return chain;
}

} // namespace

TriangleSplit SplitTriangle(const Eigen::Matrix3d& corners, const Eigen::MatrixXd& points,
  int outline, const std::vector<std::array<int, 2>>& chords)
{
  // The triangle's boundary and the chords are segments of a constrained Delaunay triangulation.
  // Coordinates are barycentric, where positions on the boundary are exact; the metric makes the
  // triangles well shaped in space.
  const auto count = static_cast<int>(chords.size());
  Eigen::MatrixXi segments(outline + count, 2);
  for (int i = 0; i < outline; ++i)
  {
    segments.row(i) << i, (i + 1) % outline;
  }
  for (int i = 0; i < count; ++i)
  {
    segments.row(outline + i) << chords[i][0], chords[i][1];
  }
  PlanarDelaunayOptions options;
  options.Keep = PlanarDelaunayOptions::KeepType::Wound;
  options.Outlines = outline;
  options.AddCrossings = true;
  options.Metric = MetricOf(corners);
  const PlanarTriangulation plane = TriangulateInPlane(points.rightCols(2), segments, options);

  TriangleSplit split{ plane.Triangles, Eigen::MatrixXd(plane.Points.rows() - points.rows(), 3),
    {} };
  for (Eigen::Index i = 0; i < split.Added.rows(); ++i)
  {
    const Eigen::RowVector2d position = plane.Points.row(points.rows() + i);
    split.Added.row(i) << 1.0 - position.sum(), position;
  }
  // Chains of edges: a boundary segment must stay one edge, and a chord may have crossings.
  Eigen::Index first = 0;
  for (int i = 0; i < outline + count; ++i)
  {
    Eigen::Index last = first;
    while (last < plane.EdgeSegments.size() && plane.EdgeSegments(last) == i)
    {
      ++last;
    }
    const std::vector<int> chain = ChainOf(
      { plane.SamePoint(segments(i, 0)), plane.SamePoint(segments(i, 1)) }, plane, first, last);
    if (i >= outline)
    {
      split.Chords.push_back(chain);
    }
    else if (chain.size() != 2)
    {
      throw SolveFailure("the loop crosses itself on an edge of the surface; draw a loop that does "
                         "not cross itself");
    }
    first = last;
  }
  return split;
}

} // namespace shape
