#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Mesh/Surface.h"

namespace shape
{

struct AutomaticLandmarksOptions
{
  int Samples = 200;    ///< points by which complete surfaces are compared; >= 20
  int Features = 12;    ///< maximum for each surface; >= 6
  int Candidates = 100; ///< assignments of features of each kind to compare; >= 1
  /// The hypotheses to try: both surfaces are complete, A is a part of B, or B is a part of A. A
  /// surface is only tried as a part if it has a boundary or BothWhole is false.
  bool BothWhole = true, PartA = true, PartB = true;
  ///@}
};

struct AutomaticLandmarksResult
{
  /// Points of A and of B, at least three pairs: those of the best map that keeps orientation.
  Landmarks Pairs;
  /// The mean difference between two samples' distance and that of their images, over both
  /// directions. It is relative to the root of the area, or of the part's area: 0 for the same
  /// surface, about 0.03 for a bent and remeshed one, 0.06 for a stretched one. Above 0.07 no
  /// similar shape was found.
  double Distortion = 0.0;
  /// The same for the best map that reverses the orientation. If it is close to Distortion, the
  /// shape is symmetric, and only orientation distinguishes its two sides.
  double MirroredDistortion = 0.0;
  /// Whether MirroredDistortion is less than 0.85 times Distortion, so that B is probably a mirror
  /// image of A. (None of 18 pairs of real shapes is reported as mirrored. With B mirrored three
  /// are, two of them shapes without a mirror symmetry.)
  bool MirrorImage = false;
  /// The same for the best map that keeps orientation but takes at least half of its features in
  /// Pairs to other points; infinite if there is none.
  double RivalDistortion = 0.0;
  Landmarks Rival; ///< the pairs of that map
  /// 1 - Distortion / RivalDistortion, in [0, 1]; 0 if the pairs are a guess.
  double Confidence = 0.0;
  /// The surface that was recognised as a part.
  SurfacePart::WhichType Part = SurfacePart::WhichType::None;
  double Share = 1.0; ///< the part's share of the other surface's area
};

/**
 * Finds corresponding points of two similar surfaces from the distances along them. The surfaces
 * may have any topology and position.
 *
 * Features are the tips of extremities (FindFeatures). Candidates are assignments of features that
 * agree on the distances between them (AssignFeatures). Each candidate gives a map of samples, by
 * which the candidates are compared. A sample is mapped to one that has the same distances from
 * the features and sees them in the same sense of rotation, or in the opposite one for a mirror
 * image. So the two sides of an animal, which distances cannot distinguish, are not exchanged.
 *
 * a, b: consistently oriented 2-manifolds of one component with a triangle at each point, open or
 * closed, whose triangles face outwards. Sizes may differ, since each is scaled to area 1.
 *
 * A surface with a boundary is also tried as a part with 85 % down to 20 % of the other one's area.
 * Then only the features away from its boundary are used, and only the map of its own samples. It
 * is accepted as a part if that reduces the distortion to less than 0.7 times. (Of 12 bent parts of
 * eight models, 11 were recognised, at 0.38 to 0.58 times and with lengths within 3 %. The last one
 * had too few tips left. Ten pairs of surfaces that were both cut in the same way were all treated
 * as complete.)
 *
 * Throws InvalidInput if the surfaces are not as required, or if no three features agree;
 * SolveFailure, Aborted.
 */
AutomaticLandmarksResult FindLandmarks(const Surface& a, const Surface& b,
  const AutomaticLandmarksOptions& options = {}, const Progress& progress = {});

} // namespace shape
