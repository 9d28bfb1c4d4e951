#include "Geometry/FitRotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace shape
{

Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return FitRotation(svd.matrixU(), svd.matrixV());
}

Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& u, const Eigen::Matrix3d& v)
{
  Eigen::Matrix3d rotated = u;
  if (u.determinant() * v.determinant() < 0.0)
  {
    rotated.col(2) = -rotated.col(2);
  }
  return rotated * v.transpose();
}

} // namespace shape
