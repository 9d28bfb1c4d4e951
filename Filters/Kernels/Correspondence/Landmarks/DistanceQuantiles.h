#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns quantiles of the distances of all points from each sample, which an isometry keeps
/// (Memoli, "Gromov-Wasserstein distances and the metric approach to object matching", 2011,
/// section 6): a row for each sample, at the shares (i + 0.5) / levels of the weights. distances:
/// points x samples. weights: of the points, >= 0.
Eigen::MatrixXd ComputeDistanceQuantiles(
  const Eigen::MatrixXd& distances, const Eigen::VectorXd& weights, int levels);

} // namespace shape
