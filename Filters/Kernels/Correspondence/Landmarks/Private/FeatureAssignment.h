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
  double Score = 0.0; ///< the sum of (agreement - 1/2) over every two pairs
};

/**
 * Finds the assignments between two sets of features that agree best on the distances between
 * features, the best first. Three pairs are a seed if every two of them agree by more than 1/2. The
 * pair that raises the score the most is added to the seed, until no pair raises it.
 *
 * The agreement of two pairs is exp(-(difference / tolerance)^2 / 2). Each pair of pairs has two
 * distances: between its two features of A, and between its two features of B. `difference` is the
 * difference of these two, divided by the longer one. distancesA, distancesB: square, symmetric
 * matrices. levelsA, levelsB: one positive value for each feature. Two features are paired only if
 * the ratio of their levels is between 1 / 1.65 and 1.65. At most `count` assignments are returned.
 * Throws Aborted.
 */
std::vector<FeatureAssignment> AssignFeatures(const Eigen::MatrixXd& distancesA,
  const Eigen::MatrixXd& distancesB, const Eigen::VectorXd& levelsA, const Eigen::VectorXd& levelsB,
  double tolerance, int count, const Progress& progress = {});

} // namespace shape
