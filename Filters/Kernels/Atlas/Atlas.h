#pragma once

#include "Atlas/PermutationTest.h"
#include "Base/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct AtlasOptions
{
  bool Scale = false; ///< shapes are scaled to the mean of their sizes
  /// Number of modes, at most the number of modes with a variance. 0: ChooseNumberOfModes.
  int NumberOfModes = 0;
  int SpecificitySamples = 1000; ///< random shapes for the specificity; >= 1
  /// The part of the positions that the covariate explains is removed before the modes.
  bool RemoveRegression = false;
  int Permutations = 1000; ///< PermutationTestOptions
  int Seed = 1;            ///< of permutations, samples and parts; >= 0
};

/// What is known of N shapes.
struct AtlasVariables
{
  Eigen::VectorXd Groups;    ///< N values 0 or 1, or none
  Eigen::VectorXd Covariate; ///< N values, or none
};

struct AtlasResult
{
  ///@{
  /// The shapes in one position and orientation, and in one size with Scale; see Superimposed.
  std::vector<Eigen::MatrixXd> Aligned;
  Eigen::MatrixXd Mean;      ///< n x 3
  Eigen::VectorXd Sizes;     ///< N
  Eigen::VectorXd Scales;    ///< N
  Eigen::VectorXd Distances; ///< N: root mean square distance from the mean
  ///@}
  Eigen::VectorXd Deviations; ///< n: standard deviation of the position
  int NumberOfModes = 0;      ///< K <= R
  /// n x 3 K: mode k in the columns 3 k to 3 k + 2, the displacement for one standard deviation. A
  /// shape of the model with the weights w is Mean + sum_k w_k Mode_k.
  Eigen::MatrixXd Modes;
  Eigen::VectorXd Variances; ///< R values: mean squared displacement, descending
  Eigen::MatrixXd Scores;    ///< N x R: the weights of the shapes, of variance 1
  ///@{
  /// N values, with K modes: root mean square distance from the shape that the modes make, length
  /// of the scores, LeaveOneOut, and the rank by the latter; 0 is the outlier.
  Eigen::VectorXd ReconstructionErrors, MahalanobisDistances, OutlierDistances;
  std::vector<int> OutlierRanks;
  ///@}
  ///@{
  /// R values, for 1, 2, ... modes.
  Eigen::VectorXd Explained;      ///< share of the variance: the compactness
  Eigen::VectorXd Generalisation; ///< LeaveOneOut
  Eigen::VectorXd Specificity;    ///< ComputeSpecificity
  ///@}
  PermutationTestResult OfGroups, OfCovariate; ///< without points if there is no such variable
};

/**
 * Makes a statistical shape model of N shapes with the same n points (Cootes et al., "Active shape
 * models - their training and application", 1995).
 *
 * The shapes are aligned (Superimpose), and the modes are the principal components of their
 * deviations from the mean. A point counts by its share of the area, on average over the shapes.
 * Length units are those of the shapes. With RemoveRegression, the groups are compared with the
 * covariate held fixed: the residuals of the groups and of the shapes are permuted (Freedman and
 * Lane, "A nonstochastic interpretation of reported significance levels", 1983).
 *
 * shapes: n x 3 each, N >= 3. triangles: m x 3. Throws InvalidInput if there are fewer than three
 * shapes, if their numbers of points differ, if positions are not finite or have no area, if a
 * variable is constant or not finite, or if an option is out of range; SolveFailure; Aborted.
 */
AtlasResult BuildAtlas(const std::vector<Eigen::MatrixXd>& shapes, const Eigen::MatrixXi& triangles,
  const AtlasVariables& variables = {}, const AtlasOptions& options = {},
  const Progress& progress = {});

/// A quantity at the points of the shapes, such as a thickness.
struct AtlasField
{
  Eigen::VectorXd Mean;       ///< n values
  Eigen::VectorXd Deviations; ///< n values: the standard deviation
  /// n x K: the change of the quantity for one standard deviation of each mode, by linear
  /// regression on the scores. A shape of the model with the weights w has Mean + Modes w.
  Eigen::MatrixXd Modes;
};

/// Relates a quantity to the modes. values: N columns of n values, in the order of the shapes.
/// Throws InvalidInput if there are not N columns or a value is not finite.
AtlasField BuildAtlasField(const AtlasResult& atlas, const Eigen::MatrixXd& values);

} // namespace shape
