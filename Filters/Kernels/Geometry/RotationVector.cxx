#include "Geometry/RotationVector.h"

#include <Eigen/Geometry>

namespace shape
{

Eigen::Matrix3d ToRotation(const Eigen::Vector3d& vector)
{
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

} // namespace shape
