#include "Geometry/Private/ParaboloidFit.h"

#include <Eigen/QR>

namespace shape
{

Eigen::RowVector2d FitSlopesOfParaboloid(
  const Eigen::MatrixXd& positions, const Eigen::VectorXd& weights)
{
  const double size = positions.leftCols<2>().rowwise().norm().mean();
  if (!(size > 0.0))
  {
    return Eigen::RowVector2d::Zero();
  }
  const Eigen::ArrayXd x = positions.col(0) / size, y = positions.col(1) / size;
  Eigen::MatrixXd terms(positions.rows(), 6);
  terms << x, y, 0.5 * x * x, x * y, 0.5 * y * y, Eigen::ArrayXd::Ones(positions.rows());
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  // If the points lie nearly on a line, the solution of minimum norm is taken: no slope across it.
  fit.setThreshold(1e-3);
  fit.compute(weights.asDiagonal() * terms);
  return fit.solve(weights.cwiseProduct(positions.col(2)) / size).head<2>().transpose();
}

} // namespace shape
