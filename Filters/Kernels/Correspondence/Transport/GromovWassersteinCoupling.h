#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Two sets of samples. Each has the distances between its samples (s x s, symmetric) and their
/// weights (s values, positive, with sum 1). The unit of length is the longest distance in the two
/// sets.
struct MetricSpaces
{
  Eigen::MatrixXd DistancesA, DistancesB;
  Eigen::VectorXd WeightsA, WeightsB;
  ///@{
  /// What else a pair of samples costs, such as the squared difference of their features (sA x sB),
  /// and the weight of this cost relative to that of the distances, in [0, 1]. Without Costs, the
  /// weight has no effect.
  Eigen::MatrixXd Costs = {};
  double CostWeight = 0.0;
  ///@}
};

struct EntropicCouplingOptions
{
  double FirstEntropy = 0.001;   ///< initial entropy; > 0
  double Entropy = 5e-5;         ///< final entropy; in (0, FirstEntropy]
  double EntropyFactor = 0.5;    ///< factor from one entropy to the next; in (0, 1)
  int IterationsPerEntropy = 10; ///< maximum number for each entropy; >= 1
  int SinkhornIterations = 100;  ///< maximum number in each iteration; >= 1
  double Tolerance = 1e-4;       ///< error of the weights at which Sinkhorn's iteration stops; > 0
};

struct EntropicCoupling
{
  Eigen::MatrixXd Masses;         ///< sA x sB: the mass that goes from A's sample i to B's sample j
  std::vector<double> Objectives; ///< the objective after each accepted iteration
  std::vector<double> Entropies;  ///< the entropy e in each accepted iteration
  /// The root mean square of DistancesA(i, j) - DistancesB(k, l), weighted by P(i, k) P(j, l), in
  /// the unit of the distances.
  double Distortion = 0.0;
  double Cost = 0.0; ///< the sum of Costs(i, j) P(i, j); 0 without Costs
  /// The sum of |mass - weight| over A's samples.
  double Error = 0.0;
};

/// Throws InvalidInput if an option is out of range.
void RequireCouplingOptions(const EntropicCouplingOptions& options);

/// Makes the longest distance the unit, and gives both samples of each of the first `pairs` pairs
/// equal weights, because all of a landmark's mass goes to its partner. The other weights are
/// scaled to keep the sum 1.
void Normalize(MetricSpaces& spaces, int pairs);

/**
 * Computes the coupling of two sets of samples that best keeps the distances. Its masses P >= 0
 * have row sums equal to the weights of A and column sums equal to those of B. They are a local
 * minimum of
 *
 *   sum (DistancesA(i, j) - DistancesB(k, l))^2 P(i, k) P(j, l) / 4 + e sum P log(P / (wA wB'))
 *
 * which is found by Sinkhorn's iteration in logarithms. Each iteration applies it to exp(DistancesA
 * P DistancesB / e), where P are the last masses (Solomon, Peyre, Kim and Sra, "Entropic metric
 * alignment for correspondence problems", 2016, algorithm 1). The entropy e decreases from a large
 * to a small value. The problem is not convex: `start` determines which minimum is reached. If
 * distances are of negative type, each iteration lowers the objective. An iteration that raises it
 * is undone and repeated with damping: a weighted geometric mean of the last and the new masses is
 * used (the paper's eta).
 *
 * With Costs C and their weight w, the first term is multiplied by 1 - w, and w sum C(i, j) P(i, j)
 * / 4 is added: fused Gromov-Wasserstein (Vayer, Chapel, Flamary, Tavenard and Courty, "Optimal
 * transport for structured data with application on graphs", 2019, where alpha is 1 - w). With w =
 * 1, the coupling is the entropic optimal transport for C. The distances may be those of any
 * spaces, such as graphs or points.
 *
 * start: sA x sB, the logarithms of the similarity of A's samples to B's. Sinkhorn's iteration
 * scales the rows and columns of their exponentials to the first masses. fixed: pairs of samples
 * that are coupled only to each other. Both samples of a pair have equal weight, and no sample
 * occurs twice. Throws InvalidInput; SolveFailure if the masses remain far from the weights;
 * Aborted.
 */
EntropicCoupling SolveCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& start,
  const Landmarks& fixed = {}, const EntropicCouplingOptions& options = {},
  const Progress& progress = {});

/// Computes the coupling of all samples from `masses`, the coupling of the first samples of both
/// sets. It starts at 8 times the last entropy, if FirstEntropy is not lower: the coarse coupling
/// determines the minimum, and a higher entropy would blur it again. Throws as SolveCoupling.
EntropicCoupling RefineCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& masses,
  const Landmarks& fixed, EntropicCouplingOptions options, const Progress& progress = {});

} // namespace shape
