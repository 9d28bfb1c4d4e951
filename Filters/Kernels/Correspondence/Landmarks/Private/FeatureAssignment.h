#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Pairs {feature of A, feature of B} that agree with each other on how far features are apart.
struct FeatureAssignment
{
  Landmarks Pairs;    ///< in order of A's features, no feature twice
  double Score = 0.0; ///< the sum over two pairs each of how well they agree, minus a half
};

/**
 * The assignments of two sets of features that agree best on the distances between them, best
 * first: each three pairs of which every two agree are a seed, to which the pair is added that
 * raises the score most, as long as one does.
 *
 * Two pairs agree by exp(-(difference / tolerance)^2 / 2), the difference of the two distances
 * relative to the longer one. distancesA, distancesB: symmetric, k x k each. levelsA, levelsB (k):
 * positive; a feature goes only to one whose level is less than 1.65 times its own and more than
 * that part of it. At most `count` are returned. Throws Aborted.
 */
std::vector<FeatureAssignment> AssignFeatures(const Eigen::MatrixXd& distancesA,
  const Eigen::MatrixXd& distancesB, const Eigen::VectorXd& levelsA, const Eigen::VectorXd& levelsB,
  double tolerance, int count, const Progress& progress = {});

} // namespace shape
