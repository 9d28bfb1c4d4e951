#include "Quality/ConformalDistortion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace shape
{

Eigen::VectorXd ComputeConformalDistortion(const Mesh& mesh, const Eigen::MatrixXd& images)
{
  Eigen::VectorXd distortion(mesh.Triangles.rows());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    const Eigen::RowVector3d u = mesh.Points.row(corners(1)) - mesh.Points.row(corners(0));
    const Eigen::RowVector3d v = mesh.Points.row(corners(2)) - mesh.Points.row(corners(0));
    const Eigen::RowVector3d p = images.row(corners(1)) - images.row(corners(0));
    const Eigen::RowVector3d q = images.row(corners(2)) - images.row(corners(0));
    const double area = u.cross(v).norm();
    const double imageArea = p.cross(q).norm();
    if (area == 0.0)
    {
      distortion(t) = 1.0;
      continue;
    }
    // s^2 + t^2 is twice the Dirichlet energy / the area; s t is the ratio of the areas.
    const double squares = (v.squaredNorm() * p.squaredNorm() - 2.0 * u.dot(v) * p.dot(q) +
                             u.squaredNorm() * q.squaredNorm()) /
      (area * area);
    const double product = imageArea / area;
    distortion(t) = product > 0.0 ? std::max(1.0, squares / (2.0 * product))
                                  : std::numeric_limits<double>::infinity();
  }
  return distortion;
}

} // namespace shape
