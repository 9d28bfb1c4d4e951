#include "Geometry/TangentFrame.h"

#include <Eigen/Geometry>

namespace shape
{

using Eigen::RowVector3d;

RowVector3d RotateBetweenNormals(
  const RowVector3d& vector, const RowVector3d& from, const RowVector3d& to)
{
  constexpr double opposite = 1e-12;
  const double cosine = from.dot(to);
  if (1.0 + cosine < opposite)
  {
    RowVector3d axis = RowVector3d::UnitX() - from.x() * from;
    if (axis.squaredNorm() < opposite)
    {
      axis = RowVector3d::UnitY() - from.y() * from;
    }
    axis.normalize();
    return 2.0 * axis.dot(vector) * axis - vector;
  }
  const RowVector3d axis = from.cross(to);
  // Rodrigues' formula for the rotation around from x to, whose length is the sine.
  return cosine * vector + axis.cross(vector) + axis.dot(vector) / (1.0 + cosine) * axis;
}

TangentFrame BuildTangentFrame(
  const RowVector3d& origin, const RowVector3d& normal, const RowVector3d& xDirection)
{
  constexpr double nothing = 1e-12;
  const double length = xDirection.norm();
  RowVector3d x = RowVector3d::Zero();
  if (length > 0.0)
  {
    x = xDirection / length;
    x -= x.dot(normal) * normal;
  }
  if (x.norm() < nothing)
  {
    x = RotateBetweenNormals(RowVector3d::UnitX(), RowVector3d::UnitZ(), normal);
    x -= x.dot(normal) * normal;
  }
  x.normalize();
  return { origin, x, normal.cross(x), normal };
}

} // namespace shape
