#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct PermutationTestOptions
{
  /// Number of random permutations; >= 1. If there are not more different ones, all of them are
  /// used, and the p-values are exact.
  int Permutations = 1000;
  int Seed = 1; ///< of the random permutations
};

/// How positions depend on a variable.
struct PermutationTestResult
{
  Eigen::MatrixXd Slope;   ///< n x 3: change of the position for each unit of the variable
  double RSquared = 0.0;   ///< share of the shapes' variance that the variable explains
  double PValue = 1.0;     ///< of the whole shape, in (0, 1]
  Eigen::VectorXd PValues; ///< n: of each point
  Eigen::VectorXd QValues; ///< n: false discovery rate, if all points with q up to it are reported
  int Permutations = 0;    ///< used
  bool Exact = false;      ///< whether these are all
};

/**
 * Tests by permutation whether shapes depend on a variable. With a variable of two values, 0 and 1,
 * Slope is the difference of the means of both groups.
 *
 * The statistic of the whole shape is the squared length of Slope, weighted. That of a point is
 * Hotelling's T^2 of two groups, or for any variable the share of the variance of the point's
 * position, made isotropic, that the variable explains: T^2 increases with it. Both are compared
 * with those of the permuted variable (Good, "Permutation Tests", 2000; Styner et al., "Statistical
 * shape analysis of brain structures using SPHARM-PDM", 2006). A random test counts the given order
 * as one of the permutations, so that p is never 0 and the test is never too liberal (Phipson and
 * Smyth, "Permutation P-values should never be zero", 2010). QValues: Benjamini and Hochberg,
 * "Controlling the false discovery rate", 1995.
 *
 * deviations: 3 n x N, column i has the x, then the y, then the z coordinates of shape i minus the
 * mean. weights: n values >= 0 of sum 1. variable: N values, not all equal, N >= 2. Throws
 * InvalidInput if the variable is constant or Permutations is out of range; Aborted.
 */
PermutationTestResult TestByPermutation(const Eigen::MatrixXd& deviations,
  const Eigen::VectorXd& weights, const Eigen::VectorXd& variable,
  const PermutationTestOptions& options = {}, const Progress& progress = {});

} // namespace shape
