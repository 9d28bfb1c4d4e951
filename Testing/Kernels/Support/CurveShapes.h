#pragma once

#include <Eigen/Core>

#include <cmath>

// Functions shared by the tests of closed curves.
namespace shapetest
{

/// Returns middle + cos(t) u + sin(t) v at `count` values of t, none of them 0.
inline Eigen::MatrixXd Circle(const Eigen::RowVector3d& middle, const Eigen::RowVector3d& u,
  const Eigen::RowVector3d& v, int count)
{
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * (i + 0.5) / count;
    points.row(i) = middle + std::cos(angle) * u + std::sin(angle) * v;
  }
  return points;
}

/// Returns the area of a planar polygon (n x 2); negative if it runs clockwise.
inline double PolygonArea(const Eigen::MatrixXd& polygon)
{
  double twice = 0.0;
  for (Eigen::Index i = 0; i < polygon.rows(); ++i)
  {
    const Eigen::Index j = (i + 1) % polygon.rows();
    twice += polygon(i, 0) * polygon(j, 1) - polygon(j, 0) * polygon(i, 1);
  }
  return 0.5 * twice;
}

} // namespace shapetest
