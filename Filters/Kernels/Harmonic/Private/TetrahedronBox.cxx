#include "Harmonic/Private/TetrahedronBox.h"

namespace shape
{

bool MayMeet(const Eigen::Matrix<double, 4, 3>& corners, const Eigen::AlignedBox3d& box)
{
  Eigen::AlignedBox3d around;
  for (int k = 0; k < 4; ++k)
  {
    around.extend(corners.row(k).transpose());
  }
  if (!around.intersects(box))
  {
    return false;
  }
  const Eigen::RowVector3d centre = box.center().transpose();
  const Eigen::RowVector3d half = 0.5 * box.sizes().transpose();
  for (int k = 0; k < 4; ++k)
  {
    // The plane of the face opposite corner k; the normal is turned away from this corner.
    const Eigen::RowVector3d origin = corners.row((k + 1) % 4);
    const Eigen::RowVector3d first = corners.row((k + 2) % 4) - origin;
    const Eigen::RowVector3d second = corners.row((k + 3) % 4) - origin;
    Eigen::RowVector3d normal = first.cross(second);
    if (normal.dot(corners.row(k) - origin) > 0.0)
    {
      normal = -normal;
    }
    const double rounding = 1e-12 * normal.norm() * (around.sizes().maxCoeff() + half.maxCoeff());
    if (normal.dot(centre - origin) - normal.cwiseAbs().dot(half) > rounding)
    {
      return false;
    }
  }
  return true;
}

} // namespace shape
