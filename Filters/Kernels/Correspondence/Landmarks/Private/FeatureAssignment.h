#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Pairs {feature of A, feature of B} that agree with each other on the distances between features.
struct FeatureAssignment
{
  Landmarks Pairs;    ///< in the order of A's features; no feature occurs twice
  double Score = 0.0; ///< the sum over every two pairs of their agreement minus a half
};

/**
 * Finds the assignments between two sets of features that agree best on the distances between them,
 * the best first. Any three pairs of which every two agree are a seed. To a seed, the pair that
 * raises the score the most is added, until none raises it.
 *
 * Two pairs agree by exp(-(difference / tolerance)^2 / 2), where difference is that of the two
 * distances relative to the longer one. distancesA, distancesB: symmetric, k x k each. levelsA,
 * levelsB (k): positive. Two features are paired only if the ratio of their levels is between 1 /
 * 1.65 and 1.65. At most `count` assignments are returned. Throws Aborted.
 */
std::vector<FeatureAssignment> AssignFeatures(const Eigen::MatrixXd& distancesA,
  const Eigen::MatrixXd& distancesB, const Eigen::VectorXd& levelsA, const Eigen::VectorXd& levelsB,
  double tolerance, int count, const Progress& progress = {});

} // namespace shape
