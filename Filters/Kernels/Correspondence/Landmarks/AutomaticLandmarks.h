#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Mesh/Surface.h"

namespace shape
{

struct AutomaticLandmarksOptions
{
  int Samples = 200; ///< points of each surface by which maps are compared; >= 20
  int Features = 12; ///< maximum number of features of each surface; >= 6
  /// Maximum number of assignments for each number of features and each tolerance; >= 1.
  int Candidates = 100;
  /// The hypotheses to try: both surfaces are complete, A is a part of B, or B is a part of A. A
  /// surface is tried as a part only if it has a boundary or BothWhole is false.
  bool BothWhole = true, PartA = true, PartB = true;
  /// Which of the different maps gives the result: 0 is the best one, 1 the second best one, and so
  /// on; >= 0, and less than AutomaticLandmarksResult::Alternatives.
  int Rank = 0;
};

struct AutomaticLandmarksResult
{
  /// At least three pairs of corresponding points of A and B, from the best map that keeps
  /// orientation, or from the one that Rank selects.
  Landmarks Pairs;
  /// The mean difference between the distance of two samples and the distance of their images, over
  /// both directions. If one surface is a part, only the part's samples count. The difference is
  /// relative to the root of the area, or of the part's area. It is 0 for the same surface, about
  /// 0.03 for a bent and remeshed one, and 0.06 for a stretched one. Above 0.07, the shapes are not
  /// similar.
  double Distortion = 0.0;
  /// The distortion of the best map that reverses orientation. If it is close to Distortion, the
  /// shape is symmetric, and only orientation distinguishes its two sides.
  double MirroredDistortion = 0.0;
  /// Whether MirroredDistortion is less than 0.85 times Distortion, so that B is probably a mirror
  /// image of A. (None of 18 pairs of real shapes is reported as mirrored. If B is mirrored, three
  /// pairs are reported; two of them show shapes without a mirror symmetry.)
  bool MirrorImage = false;
  /// How far the map is from an isometry, for which it is 0: a geometric mean of Distortion and
  /// of the three errors of the refined map (RefinedCandidate). The map of a part is not refined;
  /// its Error is Distortion.
  double Error = 0.0;
  /// The number of different maps, of which Rank selects one; at most 9. Two maps are different if
  /// the images of a point are more than 0.05 apart, on average, relative to the root of the area.
  int Alternatives = 1;
  ///@{
  /// The same of the rival: the best one of the other maps, such as the one that exchanges left and
  /// right; infinite if there is none.
  double RivalDistortion = 0.0, RivalError = 0.0;
  ///@}
  Landmarks Rival; ///< the pairs of the rival map
  /// 1 - Error / RivalError, in [0, 1]; near 0 if the rival map is about as good, and 0 if it is
  /// better, because Rank is not 0.
  double Confidence = 0.0;
  /// Whether Confidence is at least 0.1. (Chosen on 62 pairs of people and animals in poses: one
  /// map exchanged left and right, with a confidence of 0.05, and 50 right ones are certain.)
  bool Certain = false;
  /// The surface that was recognised as a part, if any.
  SurfacePart::WhichType Part = SurfacePart::WhichType::None;
  double Share = 1.0; ///< the part's share of the other surface's area
};

/**
 * Finds corresponding points of two similar surfaces from the distances along them. The surfaces
 * may have any topology and position.
 *
 * Features are the tips of extremities (FindFeatures). Candidates are assignments of features that
 * agree on the distances between them (AssignFeatures). Each candidate gives a map of samples, by
 * which the candidates are compared. A sample is mapped to the sample with the most similar
 * distances from the features. Around both samples, the features must also lie in the same sense of
 * rotation, or in the opposite sense for a mirror image. Therefore the two sides of an animal,
 * which distances cannot distinguish, are not exchanged.
 *
 * One more candidate is the map of the nearest positions, if both surfaces are moved to one centre
 * and not turned. It is the right one for nearly round shapes that stand alike, and is rejected
 * like any other one for shapes that do not.
 *
 * a, b: consistently oriented 2-manifolds of one component, open or closed. Each point has a
 * triangle, and the triangles face outwards. Sizes may differ, since each surface is scaled to area
 * 1.
 *
 * A surface with a boundary is also tried as a part with 85 % down to 20 % of the other one's area.
 * Then only the features away from its boundary are used, and only its own samples are mapped. It
 * is accepted as a part if this gives less than 0.7 times the distortion of two complete surfaces.
 * (Of 12 bent parts of eight models, 11 were recognised. Their distortion was 0.38 to 0.58 times
 * that of complete surfaces, and their scale was correct within 3 %. The twelfth part had too few
 * tips left to be recognised. In ten further pairs, both surfaces were cut in the same way; all of
 * these were treated as complete.)
 *
 * Throws InvalidInput if the surfaces are not as required, or if no three features agree;
 * SolveFailure, Aborted.
 */
AutomaticLandmarksResult FindLandmarks(const Surface& a, const Surface& b,
  const AutomaticLandmarksOptions& options = {}, const Progress& progress = {});

} // namespace shape
