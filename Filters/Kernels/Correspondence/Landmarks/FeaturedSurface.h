#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/GeodesicSamples.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The features of a surface, which are the tips of its extremities, and samples described relative
/// to them.
struct FeaturedSurface
{
  std::vector<int> Features;  ///< k points, the most prominent first
  Eigen::VectorXd Remoteness; ///< k values: mean distance of each feature from the surface's points
  /// k values: distance of each feature from the boundary; infinite without a boundary.
  Eigen::VectorXd DistanceToBoundary;
  Eigen::MatrixXd Apart;      ///< k x k: distances between the features
  std::vector<int> Samples;   ///< s points
  Eigen::VectorXd Weights;    ///< s values: weights of the samples, with sum 1
  Eigen::MatrixXd Between;    ///< s x s: distances between the samples
  Eigen::MatrixXd ToFeatures; ///< s x k: distances from the samples to the features
  /// s x k^2: column i k + j is the sine of the angle at a sample from the direction of feature i
  /// to that of feature j. Angles are seen from outside. For a mirror image, the sign is opposite.
  Eigen::MatrixXd Turns;
};

/**
 * Finds at most `features` features of a surface: the persistent maxima (FindPersistentMaxima) of
 * the mean distance from the surface's points (Hilaga, Shinagawa, Kohmura and Kunii, "Topology
 * matching for fully automatic similarity estimation of 3D shapes", 2001, section 3.1). If there
 * are fewer than 6, farthest points are added until there are 6. Distances are along the surface,
 * divided by the root of its area.
 *
 * surface: one that RequireConnected accepts. samples, features: both >= 6. Throws SolveFailure,
 * Aborted.
 */
FeaturedSurface FindFeatures(
  const Surface& surface, int samples, int features, const Progress& progress = {});

/// Describes the surface as a part of a larger one. share: its share of the larger surface's area.
/// Distances are multiplied by the root of the share. Features near the boundary are left out,
/// since an extremity may have been cut there.
FeaturedSurface RestrictToPart(const FeaturedSurface& surface, double share);

} // namespace shape
