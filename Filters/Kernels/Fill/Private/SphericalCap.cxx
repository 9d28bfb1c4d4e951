#include "Fill/Private/SphericalCap.h"

#include "Laplacian/Membrane.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// The direction that a rim goes around, counter-clockwise.
RowVector3d AxisOf(const Eigen::MatrixXd& loop)
{
  const RowVector3d centre = loop.colwise().mean();
  RowVector3d sum = RowVector3d::Zero();
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const RowVector3d from = loop.row(i) - centre, to = loop.row((i + 1) % loop.rows()) - centre;
    sum += from.cross(to);
  }
  return sum.stableNormalized();
}

} // namespace

double ComputeMeanTilt(const BoundaryLoop& loop)
{
  const RowVector3d axis = AxisOf(loop.Points);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.Points.rows(); ++i)
  {
    const Eigen::Index before = (i + loop.Points.rows() - 1) % loop.Points.rows();
    const RowVector3d along =
      loop.Points.row((i + 1) % loop.Points.rows()) - loop.Points.row(before);
    const RowVector3d outwards = along.cross(axis).stableNormalized(), normal = loop.Normals.row(i);
    sum += std::atan2(normal.dot(outwards), normal.dot(axis));
  }
  return sum / static_cast<double>(loop.Points.rows());
}

Eigen::MatrixXd BuildSphericalCap(const HolePatch& patch, const BoundaryLoop& loop)
{
  constexpr double maximum = 150.0 * M_PI / 180.0, minimum = 1e-3;
  double tilt = std::clamp(ComputeMeanTilt(loop), -maximum, maximum);
  tilt = std::abs(tilt) < minimum ? minimum : tilt;
  const Eigen::Index corners = loop.Points.rows();
  const Eigen::MatrixXd circle = patch.Flat.topRows(corners);
  const double radius = circle.rowwise().norm().mean();
  // The plane's axes in space, so that the circle is as near to the rim as it can be. Where the
  // rim's points are unevenly spaced their mean is not the circle's centre.
  const RowVector3d loopMean = loop.Points.colwise().mean();
  const Eigen::RowVector2d circleMean = circle.colwise().mean();
  const Eigen::MatrixXd around = circle.rowwise() - circleMean;
  const Eigen::Matrix<double, 3, 2> moments =
    (loop.Points.rowwise() - loopMean).transpose() * around / around.squaredNorm();
  const Eigen::JacobiSVD<Eigen::MatrixXd> fit(moments, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::Matrix<double, 3, 2> axes = fit.matrixU() * fit.matrixV().transpose();
  const RowVector3d up = axes.col(0).cross(axes.col(1)).transpose();
  const double scale = fit.singularValues().sum(); // of the circle in space
  const RowVector3d centre = loopMean - scale * (axes * circleMean.transpose()).transpose();

  Mesh cap{ Eigen::MatrixXd(patch.Flat.rows(), 3), patch.Surface.Triangles };
  const double sphere = scale * radius / std::sin(tilt);
  for (Eigen::Index i = 0; i < cap.Points.rows(); ++i)
  {
    const double share = patch.Flat.row(i).norm() / radius;
    const double angle = 2.0 * std::atan(std::tan(0.5 * tilt) * share);
    const RowVector3d way = share > 0.0
      ? RowVector3d((axes * patch.Flat.row(i).transpose()).transpose() / (radius * share))
      : RowVector3d::Zero();
    cap.Points.row(i) =
      centre + sphere * (std::sin(angle) * way + (std::cos(angle) - std::cos(tilt)) * up);
  }
  return cap.Points + SolveHarmonicValues(cap, loop.Points - cap.Points.topRows(corners));
}

} // namespace shape
