#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A coupling of samples of two surfaces: the general notion of a correspondence, in which a point
/// may go to many (Memoli, "On the use of Gromov-Hausdorff distances for shape comparison", 2007).
/// Without samples, there is none.
struct SampledCoupling
{
  std::vector<int> SamplesOfA, SamplesOfB; ///< sA and sB points of the surfaces
  ///@{
  /// The weight of each sample: > 0, with sum 1. It is the share of the area that is nearest to it,
  /// but the two samples of a landmark share the mean of theirs.
  Eigen::VectorXd WeightsOfA, WeightsOfB;
  ///@}
  /// sA x sB: the mass that goes from A's sample i to B's sample j. The sums of rows and columns
  /// are the weights, up to the error of the coupling.
  Eigen::MatrixXd Masses;
};

/// The entries of a coupling above a smallest mass, ordered by A's sample.
struct CouplingEntries
{
  std::vector<int> OfA, OfB; ///< indices of samples
  Eigen::VectorXd Masses;
  double Omitted = 0.0; ///< the sum of the other entries
};

/// Returns the entries that are greater than `smallest`.
CouplingEntries ListEntries(const Eigen::MatrixXd& masses, double smallest);

/**
 * Computes the distribution on B of the image of a point of A: a density for each point of B, whose
 * integral by the points' areas (ComputePointAreas) is 1.
 *
 * The point is coupled like the sample nearest to it. The mass that goes to a sample of B is spread
 * evenly over the points nearest to that sample. Nearest is measured along edges.
 *
 * a, b: the surfaces of the coupling. point: in a triangle of A. Throws InvalidInput if the point
 * is not one, or if no path leads from it to a sample; Aborted.
 */
Eigen::VectorXd ComputeImageDistribution(const Surface& a, const Surface& b,
  const SampledCoupling& coupling, int point, const Progress& progress = {});

} // namespace shape
