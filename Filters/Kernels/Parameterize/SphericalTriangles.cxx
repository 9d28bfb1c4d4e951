#include "Parameterize/SphericalTriangles.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace shape
{
namespace
{

bool FacesOutwardsFrom(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  const Eigen::RowVector3d ab = b - a;
  const Eigen::RowVector3d ac = c - a;
  const double determinant = a.dot(ab.cross(ac));
  // The determinant with absolute values of all products bounds its rounding error.
  const double permanent = std::abs(a(0)) * (std::abs(ab(1) * ac(2)) + std::abs(ab(2) * ac(1))) +
    std::abs(a(1)) * (std::abs(ab(2) * ac(0)) + std::abs(ab(0) * ac(2))) +
    std::abs(a(2)) * (std::abs(ab(0) * ac(1)) + std::abs(ab(1) * ac(0)));
  return determinant > 4.0 * std::numeric_limits<double>::epsilon() * permanent;
}

} // namespace

double ComputeSphericalDeterminant(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  return a.dot((b - a).cross(c - a));
}

bool IsFacingOutwards(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  // The error bound depends on the corner from which differences are taken.
  return FacesOutwardsFrom(a, b, c) || FacesOutwardsFrom(b, c, a) || FacesOutwardsFrom(c, a, b);
}

std::vector<int> FindFlippedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  std::vector<int> flipped;
  for (int t = 0; t < triangles.rows(); ++t)
  {
    if (!IsFacingOutwards(
          points.row(triangles(t, 0)), points.row(triangles(t, 1)), points.row(triangles(t, 2))))
    {
      flipped.push_back(t);
    }
  }
  return flipped;
}

Eigen::VectorXd ComputeSolidAngles(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  Eigen::VectorXd angles(triangles.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = points.row(triangles(t, 0));
    const Eigen::RowVector3d b = points.row(triangles(t, 1));
    const Eigen::RowVector3d c = points.row(triangles(t, 2));
    // Van Oosterom and Strackee 1983, for unit vectors.
    angles(t) =
      2.0 * std::atan2(ComputeSphericalDeterminant(a, b, c), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return angles;
}

int ComputeCoveringDegree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
{
  return static_cast<int>(std::lround(ComputeSolidAngles(triangles, points).sum() / (4.0 * M_PI)));
}

} // namespace shape
