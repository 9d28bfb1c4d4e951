#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/SampledSurface.h"
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
  Eigen::VectorXd Remoteness; ///< k: mean distance of each feature from all of the surface
  /// k: distance of each feature from the boundary; infinite without one.
  Eigen::VectorXd DistanceToBoundary;
  Eigen::MatrixXd Apart;      ///< k x k: distances between the features
  Eigen::VectorXd Weights;    ///< s: weights of the samples; the sum is 1
  Eigen::MatrixXd Between;    ///< s x s: distances between the samples
  Eigen::MatrixXd ToFeatures; ///< s x k: distances from the samples to the features
  /// s x k^2: column i k + j is the sine of the angle, at a sample seen from outside, from the
  /// direction of feature i to that of feature j. A mirror image has the opposite sign.
  Eigen::MatrixXd Turns;
};

/**
 * Finds at most `features` features of a surface: the FindPersistentMaxima of the mean distance
 * from all of the surface (Hilaga, Shinagawa, Kohmura and Kunii, "Topology matching for fully
 * automatic similarity estimation of 3D shapes", 2001, section 3.1). If there are fewer than 6, the
 * points farthest from them are added. Distances are along the surface, divided by the root of its
 * area.
 *
 * surface: RequireConnected. samples, features: >= 6. Throws SolveFailure, Aborted.
 */
FeaturedSurface FindFeatures(
  const Surface& surface, int samples, int features, const Progress& progress = {});

/// Returns the surface as a part of a larger one, of whose area it has the given share. Distances
/// are multiplied by the root of the share. Features near the boundary are left out, since an
/// extremity may have been cut there.
FeaturedSurface RestrictToPart(const FeaturedSurface& surface, double share);

} // namespace shape
