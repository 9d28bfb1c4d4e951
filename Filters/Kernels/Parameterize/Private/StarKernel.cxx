#include "Parameterize/Private/StarKernel.h"

#include "Parameterize/SphericalTriangles.h"

#include <Eigen/Geometry>

namespace shape
{

bool IsInStarKernel(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& position, const std::vector<int>& ring)
{
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    if (!IsFacingOutwards(position, points.row(ring[k]), points.row(ring[(k + 1) % ring.size()])))
    {
      return false;
    }
  }
  return true;
}

bool MovePointIntoKernel(Eigen::MatrixXd& points, int point, const std::vector<int>& ring)
{
  const auto normalOf = [&](std::size_t k)
  {
    const Eigen::RowVector3d a = points.row(ring[k]);
    const Eigen::RowVector3d b = points.row(ring[(k + 1) % ring.size()]);
    return Eigen::RowVector3d(a.cross(b - a).normalized());
  };
  const Eigen::RowVector3d corner = points.row(ring[0]);
  const Eigen::RowVector3d after = normalOf(0);
  const Eigen::RowVector3d before = normalOf(ring.size() - 1);
  Eigen::RowVector3d right = after.cross(corner);
  Eigen::RowVector3d left = before.cross(corner);
  right *= right.dot(before) < 0.0 ? -1.0 : 1.0;
  left *= left.dot(after) < 0.0 ? -1.0 : 1.0;
  std::vector<Eigen::RowVector3d> kernel = { corner, right.normalized(), -corner,
    left.normalized() };
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
  {
    const Eigen::RowVector3d normal = normalOf(k);
    const Eigen::RowVector3d foot = points.row(ring[k]);
    std::vector<Eigen::RowVector3d> clipped;
    for (std::size_t i = 0; i < kernel.size(); ++i)
    {
      const Eigen::RowVector3d& p = kernel[i];
      const Eigen::RowVector3d& q = kernel[(i + 1) % kernel.size()];
      const double heightP = normal.dot(p - foot);
      const double heightQ = normal.dot(q - foot);
      if (heightP > 0.0)
      {
        clipped.push_back(p);
      }
      if ((heightP > 0.0) != (heightQ > 0.0))
      {
        clipped.push_back((p + heightP / (heightP - heightQ) * (q - p)).normalized());
      }
    }
    kernel = std::move(clipped);
  }
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const Eigen::RowVector3d& p : kernel)
  {
    sum += p;
  }
  // Long thin kernels: their middle may be unseen by rounding; nearer to the corner it may not.
  for (double share = 1.0; share > 1e-6 && sum.squaredNorm() > 0.0; share *= 0.5)
  {
    const Eigen::RowVector3d position = (corner + share * (sum.normalized() - corner)).normalized();
    if (IsInStarKernel(points, position, ring))
    {
      points.row(point) = position;
      return true;
    }
  }
  return false;
}

} // namespace shape
