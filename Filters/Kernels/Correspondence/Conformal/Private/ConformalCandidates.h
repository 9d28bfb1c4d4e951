#pragma once

#include "Base/Progress.h"
#include "Correspondence/Conformal/Private/RoundSurface.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A candidate map: the Moebius map of three points of A and three of B, between their spheres.
struct ConformalCandidate
{
  Eigen::Vector3i OfA, OfB;
  Eigen::Matrix2cd Moebius;
  /// How near landmarks come to their partners: exp(-(d / Agreement)^2), where d is the root mean
  /// square of their distances, weighted by the trust in the map there. It is 1 without landmarks,
  /// and for maps of triples of landmarks.
  double Fit = 1.0;
};

/// Returns the maps of all triples of landmarks that are distinct on both spheres, or of 300 evenly
/// spread ones if there are more.
std::vector<ConformalCandidate> MapLandmarkTriples(
  const RoundSurface& a, const RoundSurface& b, const Landmarks& landmarks);

struct FeatureTripleOptions
{
  int Points = 12;        ///< points of each surface, besides landmarks, that form triples; >= 3
  double Tolerance = 0.3; ///< of distances, see FindSimilarTriples; > 0
  int Compared = 5000;    ///< maximum number of maps whose trust is compared; >= 1
  int Kept = 500;         ///< maximum number of maps that are returned; >= 1
  double Agreement = 0.1; ///< the distance at which a landmark counts 1 / e; > 0
};

/**
 * Returns the maps of triples of feature points, of which no assignment is known (section 3 of Kim
 * et al. 2011). The points are landmarks, which go only to each other, then the tips of extremities
 * (FindFeatures), then the farthest points. Of the triples that FindSimilarTriples returns, those
 * whose points have the most similar distances, from each other and from all points (quantiles),
 * are compared. Those maps are kept whose mean trust at samples of A, times Fit, is greatest.
 * locator: of b's sphere. Throws SolveFailure, Aborted.
 */
std::vector<ConformalCandidate> MapFeatureTriples(const Surface& a, const RoundSurface& roundA,
  const Surface& b, const RoundSurface& roundB, const SurfaceLocator& locator,
  const Landmarks& landmarks, const FeatureTripleOptions& options, const Progress& progress);

} // namespace shape
