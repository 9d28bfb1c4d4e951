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

/// Where the line along x through (y, z) meets a triangle's plane, within the triangle's box.
double CrossingOf(const Eigen::Matrix3d& corners, const Eigen::RowVector2d& line)
{
  const Eigen::RowVector3d normal =
    (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
  const double step = (corners.row(0).tail<2>() - line).dot(normal.tail<2>());
  const double position = normal(0) == 0.0 ? corners(0, 0) : corners(0, 0) + step / normal(0);
  return std::clamp(position, corners.col(0).minCoeff(), corners.col(0).maxCoeff());
}

} // namespace

Eigen::VectorXi ComputeGridWindingNumbers(const Mesh& mesh, const SampledGrid& grid)
{
  // First the change of the number at each point relative to the previous one.
  Eigen::VectorXi winding = Eigen::VectorXi::Zero(grid.Counts.prod());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    const Eigen::Matrix<double, 3, 2> shadow = corners.rightCols<2>();
    const Eigen::RowVector2d low = shadow.colwise().minCoeff(), high = shadow.colwise().maxCoeff();
    const Lines ys(grid, 1, low(0), high(0)), zs(grid, 2, low(1), high(1));
    for (int z = zs.First; z < zs.End; ++z)
    {
      for (int y = ys.First; y < ys.End; ++y)
      {
        const Eigen::RowVector2d line = grid.Point(0, y, z).tail<2>();
        const int side = SideOf(shadow.row(0), shadow.row(1), line);
        if (side == 0 || SideOf(shadow.row(1), shadow.row(2), line) != side ||
          SideOf(shadow.row(2), shadow.row(0), line) != side)
        {
          continue;
        }
        if (const int x = FirstBeyond(grid, 0, CrossingOf(corners, line)); x < grid.Counts(0))
        {
          winding(grid.Index(x, y, z)) -= side;
        }
      }
    }
  }
  // The sums of the changes along each line are the winding numbers; a line begins outside.
  for (Eigen::Index line = 0; line < winding.size(); line += grid.Counts(0))
  {
    const auto first = winding.data() + line;
    std::partial_sum(first, first + grid.Counts(0), first);
  }
  return winding;
}

} // namespace shape
