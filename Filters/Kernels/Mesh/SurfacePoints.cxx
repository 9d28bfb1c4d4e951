#include "Mesh/SurfacePoints.h"

#include "Base/Errors.h"

namespace shape
{

Eigen::MatrixXd PullBack(
  const SurfacePoints& map, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values)
{
  Eigen::MatrixXd result(map.Triangles.size(), values.cols());
  for (Eigen::Index i = 0; i < result.rows(); ++i)
  {
    const auto corners = triangles.row(map.Triangles(i));
    result.row(i) = map.Barycentrics(i, 0) * values.row(corners(0)) +
      map.Barycentrics(i, 1) * values.row(corners(1)) +
      map.Barycentrics(i, 2) * values.row(corners(2));
  }
  return result;
}

Eigen::MatrixXd PushForward(const SurfacePoints& map, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& values, Eigen::Index points)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(points, values.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.row(triangles(map.Triangles(i), k)) += map.Barycentrics(i, k) * values.row(i);
    }
  }
  return result;
}

SurfacePoints MakeSurfacePointsAtVertices(const Eigen::VectorXi& targets, const Mesh& other)
{
  Eigen::VectorXi corner = Eigen::VectorXi::Constant(other.Points.rows(), -1);
  // Backwards, so that each vertex gets its first triangle.
  for (int t = static_cast<int>(other.Triangles.rows()) - 1; t >= 0; --t)
  {
    for (int k = 0; k < 3; ++k)
    {
      corner(other.Triangles(t, k)) = 3 * t + k;
    }
  }
  SurfacePoints map;
  map.Triangles.resize(targets.size());
  map.Barycentrics.setZero(targets.size(), 3);
  for (Eigen::Index i = 0; i < targets.size(); ++i)
  {
    const int at = corner(targets(i));
    if (at < 0)
    {
      throw InvalidInput("point " + std::to_string(targets(i)) +
        " is a target, but no triangle uses it; remove it with Clean to Grid");
    }
    map.Triangles(i) = at / 3;
    map.Barycentrics(i, at % 3) = 1.0;
  }
  return map;
}

Eigen::VectorXi FindNearestCorners(const SurfacePoints& map, const Eigen::MatrixXi& triangles)
{
  Eigen::VectorXi points(map.Triangles.size());
  for (Eigen::Index i = 0; i < points.size(); ++i)
  {
    Eigen::Index corner = 0;
    map.Barycentrics.row(i).maxCoeff(&corner);
    points(i) = triangles(map.Triangles(i), corner);
  }
  return points;
}

} // namespace shape
