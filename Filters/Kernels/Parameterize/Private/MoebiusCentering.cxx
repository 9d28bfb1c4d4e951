#include "Parameterize/Private/MoebiusCentering.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <string>

namespace shape
{
namespace
{

/// Returns the points after the inversion that moves the origin to `center`.
Eigen::MatrixXd Inverted(const Eigen::MatrixXd& points, const Eigen::RowVector3d& center)
{
  Eigen::MatrixXd moved(points.rows(), 3);
  const double factor = 1.0 - center.squaredNorm();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d sum = points.row(i) + center;
    moved.row(i) = (factor / sum.squaredNorm() * sum + center).normalized();
  }
  return moved;
}

void Check(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights)
{
  if (points.cols() != 3 || points.rows() != weights.size())
  {
    throw InvalidInput("the sphere has " + std::to_string(points.rows()) + " points but " +
      std::to_string(weights.size()) + " weights; give one weight for each point");
  }
  RequireFinite(points, "the sphere");
  RequireFinite(weights, "the weights");
  Eigen::Index position = 0;
  if (weights.size() == 0 || !(weights.sum() > 0.0) || weights.minCoeff(&position) < 0.0)
  {
    throw InvalidInput("the weights have no positive sum, or one is negative (at point " +
      std::to_string(position) + "); give weights >= 0 that are not all zero");
  }
  if (points.rowwise().squaredNorm().minCoeff(&position) == 0.0)
  {
    throw InvalidInput("point " + std::to_string(position) +
      " of the sphere is at the origin; move it away from there");
  }
  if (weights.maxCoeff(&position) >= 0.5 * weights.sum())
  {
    throw InvalidInput("point " + std::to_string(position) +
      " has at least half of the total weight, so no Moebius transform can centre the points; give "
      "it a smaller weight");
  }
}

} // namespace

MoebiusCenteringResult CenterOnSphere(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
  const MoebiusCenteringOptions& options, const Progress& progress)
{
  Check(points, weights);
  // Baden et al. 2018, algorithm 1: Newton's method for the centre of the inversion.
  const Eigen::VectorXd shares = weights / weights.sum();
  MoebiusCenteringResult result;
  result.Points = points.rowwise().normalized();
  Eigen::RowVector3d mean = shares.transpose() * result.Points;
  while (mean.norm() > options.Tolerance && result.Iterations < options.MaximumIterations)
  {
    progress(static_cast<double>(result.Iterations) / options.MaximumIterations);
    // For a small c the mean moves by 2 (I - sum w p p^T) c (equation 4 of the paper).
    const Eigen::Matrix3d change = 2.0 *
      (Eigen::Matrix3d::Identity() -
        result.Points.transpose() * shares.asDiagonal() * result.Points);
    Eigen::RowVector3d center = -change.ldlt().solve(mean.transpose()).transpose();
    // If Newton's step is not a direction of descent, it is replaced by -mean.
    if (!center.allFinite() || center.dot(mean) >= 0.0)
    {
      center = -mean;
    }
    // The centre of an inversion lies inside the sphere.
    center *= std::min(1.0, 0.9 / center.norm());
    bool shorter = false;
    for (int halving = 0; halving < 40 && !shorter; ++halving, center *= 0.5)
    {
      Eigen::MatrixXd moved = Inverted(result.Points, center);
      const Eigen::RowVector3d movedMean = shares.transpose() * moved;
      shorter = movedMean.norm() < mean.norm();
      if (shorter)
      {
        result.Points = std::move(moved);
        mean = movedMean;
      }
    }
    if (!shorter)
    {
      break;
    }
    ++result.Iterations;
  }
  result.MeanLength = mean.norm();
  progress(1.0);
  return result;
}

} // namespace shape
