#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Mesh/Surface.h"

namespace shape
{

struct AutomaticLandmarksOptions
{
  int Samples = 200;    ///< points by which whole surfaces are compared; >= 20
  int Features = 12;    ///< at most, of each surface; >= 6
  int Candidates = 100; ///< assignments of features of each kind that are compared; >= 1
  ///@{
  /// Hypotheses: both whole; A a part of B, B a part of A, each if it has a boundary or if
  /// BothWhole is not tried.
  bool BothWhole = true, PartA = true, PartB = true;
  ///@}
};

struct AutomaticLandmarksResult
{
  /// Points of A and of B, 3 or more: of the best map that keeps orientation.
  Landmarks Pairs;
  /// How much two samples' distance and that of their images differ on the mean, both ways, over
  /// the root of the area, or of the part's: 0 for the same surface, about 0.03 for a bent one with
  /// new triangles, 0.06 for a stretched one. More than 0.07: nothing was found that looks alike.
  double Distortion = 0.0;
  /// The same of the best map that reverses the orientation. About as much as Distortion: the shape
  /// is symmetric, and orientation alone tells its sides.
  double MirroredDistortion = 0.0;
  /// Whether that is less than 0.85 times Distortion, so that B is rather a mirror image of A. (Of
  /// 18 pairs of real shapes none is called so; with B mirrored three are, two of them shapes
  /// without a mirror symmetry of their own.)
  bool MirrorImage = false;
  /// The same of the best map that keeps orientation and takes half or more of the features of
  /// Pairs that it knows elsewhere; infinite if there is none.
  double RivalDistortion = 0.0;
  Landmarks Rival; ///< the pairs of that map
  /// In [0, 1]: 1 - Distortion / RivalDistortion, 0 if the pairs are a guess.
  double Confidence = 0.0;
  SurfacePart::WhichType Part = SurfacePart::WhichType::None; ///< which one is taken for a part
  double Share = 1.0;                                         ///< of the whole's area that it has
};

/**
 * Corresponding points of two surfaces that look alike, found from the distances along them, for
 * surfaces of any topology in any position.
 *
 * The tips of extremities are features (FindFeatures). Assignments of features that agree on the
 * distances between them (AssignFeatures) are compared by the map of samples that each gives: to
 * the sample that is as far from the features, and from where the features lie in the same sense
 * of rotation, or in the opposite one for a mirror image. So the two sides of an animal, between
 * which no distance can tell, are not mixed up.
 *
 * a, b: consistently oriented 2-manifolds of one component with a triangle at each point, open or
 * closed, whose triangles face outwards. Sizes may differ: each is taken with its area as 1. A
 * surface with a boundary is also tried as a part of the other one, of 85 % of its area down to 20
 * %, with the features that are not near the boundary and its own samples' map alone, and taken for
 * one if that makes the distortion less than 0.7 times as large. (Of 12 parts of eight models,
 * bent, 11 were found at 0.38 to 0.58 times, with lengths within 3 %; the last kept too few tips.
 * Ten pairs of which both were cut alike were all taken for whole.)
 *
 * Throws InvalidInput if these are no such surfaces, or if no three features agree;
 * SolveFailure, Aborted.
 */
AutomaticLandmarksResult FindLandmarks(const Surface& a, const Surface& b,
  const AutomaticLandmarksOptions& options = {}, const Progress& progress = {});

} // namespace shape
