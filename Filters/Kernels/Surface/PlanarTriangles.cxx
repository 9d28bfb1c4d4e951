#include "Surface/PlanarTriangles.h"

#include <cmath>
#include <limits>

namespace shape
{
namespace
{

bool RunsCounterClockwiseFrom(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  const Eigen::RowVector2d ab = b - a;
  const Eigen::RowVector2d ac = c - a;
  const double left = ab(0) * ac(1);
  const double right = ab(1) * ac(0);
  // Twice Shewchuk's bound, whose epsilon is half of C++'s.
  return left - right >
    4.0 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
}

} // namespace

bool RunsCounterClockwise(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  // The bound depends on the corner that differences are taken from.
  return RunsCounterClockwiseFrom(a, b, c) || RunsCounterClockwiseFrom(b, c, a) ||
    RunsCounterClockwiseFrom(c, a, b);
}

std::vector<int> ClockwiseTriangles(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  std::vector<int> clockwise;
  for (int t = 0; t < triangles.rows(); ++t)
  {
    if (!RunsCounterClockwise(points.row(triangles(t, 0)).head<2>(),
          points.row(triangles(t, 1)).head<2>(), points.row(triangles(t, 2)).head<2>()))
    {
      clockwise.push_back(t);
    }
  }
  return clockwise;
}

} // namespace shape
