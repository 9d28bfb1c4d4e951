#include "Geometry/FitRotation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace shape
{
namespace
{

using FullSvd = Eigen::JacobiSVD<Eigen::Matrix3d>;

Eigen::Matrix3d GetRotation(const FullSvd& svd)
{
  // Kabsch 1976: U V^T, with the direction of the smallest singular value reversed for a
  // reflection, where it costs least.
  Eigen::Matrix3d u = svd.matrixU();
  if (u.determinant() * svd.matrixV().determinant() < 0.0)
  {
    u.col(2) = -u.col(2);
  }
  return u * svd.matrixV().transpose();
}

} // namespace

Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix)
{
  return GetRotation(FullSvd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV));
}

Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& estimate)
{
  const FullSvd svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d values = svd.singularValues();
  if (!(values(0) > 0.0))
  {
    return estimate;
  }
  if (values(1) <= 1e-9 * values(0))
  {
    const Eigen::Vector3d from = estimate * svd.matrixV().col(0), to = svd.matrixU().col(0);
    return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix() * estimate;
  }
  return GetRotation(svd);
}

Eigen::Matrix3d FitBlendedRotation(const Eigen::Matrix3d& mean)
{
  // Newton's iteration X -> (X + X^-T) / 2 converges quadratically from near a rotation.
  Eigen::Matrix3d x = mean;
  for (int step = 0; step < 12; ++step)
  {
    Eigen::Matrix3d cofactors;
    cofactors.col(0) = x.col(1).cross(x.col(2));
    cofactors.col(1) = x.col(2).cross(x.col(0));
    cofactors.col(2) = x.col(0).cross(x.col(1));
    const double determinant = x.col(0).dot(cofactors.col(0));
    // Close to a singular matrix the iteration is slow, and beyond it converges to a reflection.
    if (!(determinant > 0.05))
    {
      break;
    }
    const Eigen::Matrix3d next = 0.5 * (x + cofactors / determinant);
    const double change = (next - x).squaredNorm();
    x = next;
    if (change < 1e-18)
    {
      return x;
    }
  }
  return FitRotation(mean);
}

} // namespace shape
