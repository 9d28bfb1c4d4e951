#include "Geometry/PatchNormals.h"

#include <Eigen/Geometry>

namespace shape
{

using Eigen::RowVector3d;

Eigen::MatrixXd ComputeMaxNormals(const Mesh& surface)
{
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(surface.Points.rows(), 3);
  for (const auto& triangle : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const RowVector3d position = surface.Points.row(triangle(k));
      const RowVector3d next = surface.Points.row(triangle((k + 1) % 3)) - position;
      const RowVector3d last = surface.Points.row(triangle((k + 2) % 3)) - position;
      const double lengths = next.squaredNorm() * last.squaredNorm();
      if (lengths > 0.0)
      {
        normals.row(triangle(k)) += next.cross(last) / lengths;
      }
    }
  }
  for (auto normal : normals.rowwise())
  {
    normal.stableNormalize();
  }
  return normals;
}

RowVector3d EvaluateCurvedTriangle(
  const Eigen::Matrix3d& corners, const Eigen::Matrix3d& normals, const RowVector3d& barycentric)
{
  RowVector3d position = RowVector3d::Zero();
  // The control points beside the corners, and by their mean the one in the middle.
  RowVector3d middle = -0.5 * corners.colwise().mean();
  for (int i = 0; i < 3; ++i)
  {
    const RowVector3d corner = corners.row(i), normal = normals.row(i);
    const double u = barycentric(i);
    position += u * u * u * corner;
    for (const int j : { (i + 1) % 3, (i + 2) % 3 })
    {
      const RowVector3d way = corners.row(j) - corner;
      const RowVector3d control = corner + (way - way.dot(normal) * normal) / 3.0;
      position += 3.0 * u * u * barycentric(j) * control;
      middle += 0.25 * control;
    }
  }
  return position + 6.0 * barycentric.prod() * middle;
}

} // namespace shape
