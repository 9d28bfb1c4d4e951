#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"
#include "Correspondence/SurfaceMaps.h"

namespace shape
{

struct AutomaticLandmarksOptions
{
  int Samples = 200;    ///< points by which whole surfaces are compared; >= 20
  int Features = 12;    ///< at most, of each surface; >= 6
  int Candidates = 100; ///< assignments of features of each kind that are compared; >= 1
};

struct AutomaticLandmarksResult
{
  /// Points of A and of B, 3 or more: of the best map that keeps orientation.
  Landmarks Pairs;
  /// How much two samples' distance and that of their images differ on the mean, both ways, over
  /// the root of the area: 0 for the same surface, about 0.03 for a bent one with new triangles.
  double Distortion = 0.0;
  /// The same of the best map that turns the surface over. Less than Distortion: B is rather a
  /// mirror image of A. About as much: the shape is symmetric, and orientation alone tells its
  /// sides.
  double MirroredDistortion = 0.0;
  /// The same of the best map that keeps orientation and takes half or more of the features of
  /// Pairs that it knows elsewhere; infinite where there is none.
  double RivalDistortion = 0.0;
  /// In [0, 1]: 1 - Distortion / RivalDistortion, 0 where the pairs are a guess.
  double Confidence = 0.0;
};

/**
 * Corresponding points of two surfaces that look alike, found from how far points are apart along
 * them, for surfaces of any topology and at any place.
 *
 * The ends of limbs are features (FindFeatures). Assignments of features that agree on the
 * distances between them (AssignFeatures) are compared by the map of samples that each gives: to
 * the sample that is as far from the features, and from where the features lie in the same sense
 * of rotation, or in the opposite one for a mirror image. So the two sides of an animal, between
 * which no distance can tell, are not mixed up.
 *
 * a, b: consistently oriented 2-manifolds of one component with a triangle at each point, open or
 * closed, whose triangles face outwards. Sizes may differ: each is taken with its area as 1, so
 * that a part of a surface is not found in the whole. Throws InvalidInput where not, or where no
 * three features agree; SolveFailure, Aborted.
 */
AutomaticLandmarksResult AutomaticLandmarks(const Mesh& a, const Mesh& b,
  const AutomaticLandmarksOptions& options = {}, const Progress& progress = {});

} // namespace shape
