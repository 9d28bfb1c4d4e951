#include "Solids/GridWinding.h"

#include "Geometry/Orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shape
{
namespace
{

/// Returns the side of the line from a to b on which the position lies after an infinitesimal step
/// along the first axis and a smaller one along the second; 0 if a and b are equal.
int SideOf(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& position)
{
  if (const int side = EvaluateOrientation(a, b, position); side != 0)
  {
    return side;
  }
  if (a(1) != b(1))
  {
    return a(1) > b(1) ? 1 : -1;
  }
  return a(0) == b(0) ? 0 : (b(0) > a(0) ? 1 : -1);
}

/// The grid's first line or point at or beyond a coordinate along an axis.
int FirstBeyond(const SampledGrid& grid, int axis, double position)
{
  return static_cast<int>(std::clamp(std::ceil((position - grid.Origin(axis)) / grid.Spacing), 0.0,
    static_cast<double>(grid.Counts(axis))));
}

/// The grid's lines between two coordinates along an axis, and one more on either side, because the
/// exact orientations decide.
struct Lines
{
  Lines(const SampledGrid& grid, int axis, double low, double high)
    : First(std::max(FirstBeyond(grid, axis, low) - 1, 0))
    , End(std::min(FirstBeyond(grid, axis, high) + 1, grid.Counts(axis)))
  {
  }
  int First, End;
};

/// The coordinates across an axis, in cyclic order.
Eigen::RowVector2d Across(const Eigen::RowVector3d& position, int axis)
{
  return { position((axis + 1) % 3), position((axis + 2) % 3) };
}

/// Where the line along an axis meets a triangle's plane, within the triangle's box.
double CrossingOf(const Eigen::Matrix3d& corners, const Eigen::RowVector2d& line, int axis)
{
  const Eigen::RowVector3d normal =
    (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
  const double step = (Across(corners.row(0), axis) - line).dot(Across(normal, axis));
  const double position =
    normal(axis) == 0.0 ? corners(0, axis) : corners(0, axis) + step / normal(axis);
  return std::clamp(position, corners.col(axis).minCoeff(), corners.col(axis).maxCoeff());
}

} // namespace

void ForEachGridCrossing(const Mesh& mesh, const SampledGrid& grid, int axis,
  const std::function<void(const GridCrossing&)>& visit, const Progress& progress)
{
  const int second = (axis + 1) % 3, third = (axis + 2) % 3;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    progress(static_cast<double>(t) / static_cast<double>(mesh.Triangles.rows()));
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    Eigen::Matrix<double, 3, 2> shadow;
    shadow << corners.col(second), corners.col(third);
    const Eigen::RowVector2d low = shadow.colwise().minCoeff(), high = shadow.colwise().maxCoeff();
    const Lines rows(grid, second, low(0), high(0)), layers(grid, third, low(1), high(1));
    Eigen::RowVector3i point;
    for (point(third) = layers.First; point(third) < layers.End; ++point(third))
    {
      for (point(second) = rows.First; point(second) < rows.End; ++point(second))
      {
        const Eigen::RowVector2d line(grid.Origin(second) + grid.Spacing * point(second),
          grid.Origin(third) + grid.Spacing * point(third));
        const int side = SideOf(shadow.row(0), shadow.row(1), line);
        if (side == 0 || SideOf(shadow.row(1), shadow.row(2), line) != side ||
          SideOf(shadow.row(2), shadow.row(0), line) != side)
        {
          continue;
        }
        const double position = CrossingOf(corners, line, axis);
        point(axis) = FirstBeyond(grid, axis, position) - 1;
        visit({ static_cast<int>(t), point, position, side });
      }
    }
  }
}

Eigen::VectorXi ComputeGridWindingNumbers(
  const Mesh& mesh, const SampledGrid& grid, const Progress& progress)
{
  // First the change of the number at each point relative to the previous one.
  Eigen::VectorXi winding = Eigen::VectorXi::Zero(grid.Counts.prod());
  ForEachGridCrossing(
    mesh, grid, 0,
    [&](const GridCrossing& crossing)
    {
      const Eigen::RowVector3i& before = crossing.Before;
      if (before(0) + 1 < grid.Counts(0))
      {
        winding(grid.Index(before(0) + 1, before(1), before(2))) -= crossing.Side;
      }
    },
    progress);
  // The sums of the changes along each line are the winding numbers; a line begins outside.
  for (Eigen::Index line = 0; line < winding.size(); line += grid.Counts(0))
  {
    const auto first = winding.data() + line;
    std::partial_sum(first, first + grid.Counts(0), first);
  }
  return winding;
}

} // namespace shape
