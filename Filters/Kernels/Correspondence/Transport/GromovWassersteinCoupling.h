#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Two sets of samples, each with the distances between its samples (s x s, symmetric, in units in
/// which the longest of both sets is 1) and their weights (s; positive, the sum is 1).
struct MetricSpaces
{
  Eigen::MatrixXd DistancesA, DistancesB;
  Eigen::VectorXd WeightsA, WeightsB;
};

struct EntropicCouplingOptions
{
  double FirstEntropy = 0.001;  ///< where it begins; > 0
  double Entropy = 5e-5;        ///< where it ends; in (0, FirstEntropy]
  double Factor = 0.5;          ///< from one to the next; in (0, 1)
  int Iterations = 10;          ///< at most, at each; >= 1
  int SinkhornIterations = 100; ///< at most, in each iteration; >= 1
  double Tolerance = 1e-4;      ///< of the weights at which these end; > 0
};

struct EntropicCoupling
{
  Eigen::MatrixXd Masses;         ///< sA x sB: how much of A's sample i goes to B's sample j
  std::vector<double> Objectives; ///< after each iteration that was kept
  std::vector<double> Entropies;  ///< that each of them had
  /// The root of the mean square of the differences of distances, weighted with the masses of both
  /// ends, in the unit that the longest distance is.
  double Distortion = 0.0;
  double Error = 0.0; ///< how far the masses of A's samples are from their weights, summed up
};

/**
 * The masses P >= 0, whose rows add up to the weights of A and columns to those of B, that keep
 * distances best: a minimum of
 *
 *   sum (DistancesA(i, j) - DistancesB(k, l))^2 P(i, k) P(j, l) / 4 + e sum P log(P / (wA wB'))
 *
 * by Sinkhorn's iteration on exp(DistancesA P DistancesB / e) for the last P, in logarithms
 * (Solomon, Peyre, Kim and Sra, "Entropic metric alignment for correspondence problems", 2016,
 * algorithm 1), from much entropy e to little. It is no convex problem: `start` decides which
 * minimum is reached. For distances of negative type each iteration lowers the objective; where one
 * raises it, it is taken back and damped: done with masses between the last and the new ones, as
 * powers (the paper's eta).
 *
 * start: sA x sB, how much a sample of A is like one of B, in logarithms; the first masses are in
 * proportion to its exponentials. fixed: samples that go to each other, of equal weight, none
 * twice. Throws InvalidInput, SolveFailure if the masses stay far from the weights, Aborted.
 */
EntropicCoupling SolveCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& start,
  const Landmarks& fixed = {}, const EntropicCouplingOptions& options = {},
  const Progress& progress = {});

} // namespace shape
