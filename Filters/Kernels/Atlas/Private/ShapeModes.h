#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/// The products of the deviations of N shapes from their mean. Every statistic of the atlas is
/// computed from these N x N matrices: no matrix of the size of the points is formed.
struct DeviationProducts
{
  ///@{
  /// Each point belongs to one of two halves, at random.
  Eigen::MatrixXd First, Second;
  ///@}
  Eigen::MatrixXd All; ///< the sum of both
};

/// deviations: 3 n x N, as TestByPermutation takes them. weights: n values >= 0 of sum 1.
DeviationProducts ComputeDeviationProducts(const Eigen::MatrixXd& deviations,
  const Eigen::VectorXd& weights, int seed, const Progress& progress = {});

/// The principal components of N shapes, the largest variance first.
struct PrincipalScores
{
  Eigen::VectorXd Variances; ///< R values > 0, R < N
  Eigen::MatrixXd Scores;    ///< N x R, each column with mean 0 and variance 1
};

/// Solves the eigenproblem of the products, which has the same values > 0 as that of the covariance
/// (Sirovich, "Turbulence and the dynamics of coherent structures", 1987). Variances below 1e-12 of
/// the largest are rounding and are left out. The score of the greatest magnitude in each column is
/// positive. Throws SolveFailure and Aborted.
PrincipalScores ComputePrincipalScores(
  const Eigen::MatrixXd& products, const Progress& progress = {});

/// Returns, for 0, 1, 2, ... modes, the share of the squared deviations that they do not predict,
/// by bi-cross-validation (Owen and Perry, "Bi-cross-validation of the SVD and the nonnegative
/// matrix factorization", 2009). Modes of some shapes at half of the points get their scores for
/// the other shapes there, and predict the other half of the points. A mode that is noise of
/// independent points predicts nothing, and enlarges the error. Ten parts of the shapes, or N.
Eigen::VectorXd ComputePredictionErrors(
  const DeviationProducts& products, int seed, const Progress& progress = {});

/// Returns the smallest number of modes whose error is at most 0.001 above the least one; >= 1.
int ChooseNumberOfModes(const Eigen::VectorXd& predictionErrors);

/// How well the modes of the other shapes make a shape, after leaving out each in turn.
struct LeaveOneOut
{
  /// M values: the mean, over the shapes, of the root mean square distance from the nearest shape
  /// that 1, 2, ..., M modes of the others make.
  Eigen::VectorXd Generalisation;
  /// N values: the distance from the nearest shape that the chosen number of modes of the others
  /// makes with scores between -3 and 3.
  Eigen::VectorXd OutlierDistances;
};

/// products: DeviationProducts::All of N >= 2 shapes. modes: the M of the result; with N - 1, all
/// of the N - 2 modes of the others are used. Exact: solves an eigenproblem for each shape. Throws
/// Aborted.
LeaveOneOut ComputeLeaveOneOut(
  const Eigen::MatrixXd& products, int modes, int chosen, const Progress& progress = {});

/// Returns, for 1, ..., R modes, the mean root mean square distance of `samples` random shapes of
/// the model from the nearest given shape (Davies, "Learning shape: optimal models for analysing
/// natural variability", 2002). The weights of modes are normally distributed.
Eigen::VectorXd ComputeSpecificity(
  const PrincipalScores& model, int samples, int seed, const Progress& progress = {});

} // namespace shape
