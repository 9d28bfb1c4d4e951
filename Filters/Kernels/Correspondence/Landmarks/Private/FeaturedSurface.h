#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/SampledSurface.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The features of a surface, the tips of its extremities, and how its samples lie to them.
struct FeaturedSurface
{
  std::vector<int> Features;          ///< k points, the most outstanding first
  Eigen::VectorXd Remoteness;         ///< k: mean distance of each from the whole surface
  Eigen::VectorXd DistanceToBoundary; ///< k: of each from the boundary; infinite without one
  Eigen::MatrixXd Apart;              ///< k x k: distances between them
  Eigen::VectorXd Weights;            ///< s: of the samples; the sum is 1
  Eigen::MatrixXd Between;            ///< s x s: distances between the samples
  Eigen::MatrixXd ToFeatures;         ///< s x k: distances from the samples to the features
  /// s x k^2: the sine of the angle from the direction of feature i to that of j, seen at a sample
  /// from outside, in column i k + j. A mirror image has the opposite sign.
  Eigen::MatrixXd Turns;
};

/**
 * Distances are along the surface, over the root of its area. Features are FindPersistentMaxima of
 * the mean distance from all of the surface (Hilaga, Shinagawa, Kohmura and Kunii, "Topology
 * matching for fully automatic similarity estimation of 3D shapes", 2001, section 3.1), at most
 * `features`; where these are fewer than 6, the points farthest from them are added.
 *
 * surface: RequireConnected. samples, features: >= 6. Throws SolveFailure, Aborted.
 */
FeaturedSurface FindFeatures(
  const Surface& surface, int samples, int features, const Progress& progress = {});

/// The surface as a part of a larger one that has `share` as its area over its own: distances are
/// those times the root of it, and features near the boundary, where an extremity may have been
/// cut, are left out.
FeaturedSurface RestrictToPart(const FeaturedSurface& surface, double share);

} // namespace shape
