#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Skeleton/CurveSkeleton.h"

namespace shape
{

struct CurveSkeletonOptions
{
  /// The length of the skeleton's edges, in the surface's units; >= 0. 0: a hundredth of the
  /// diagonal of the surface's box.
  double Resolution = 0.0;
  /// The weight of a point's place in the flow, relative to cotangent weights; between 1e-3 and
  /// 1e3. A greater weight makes smaller steps: slower, and closer to the smooth flow. 0.1 is the
  /// value of the paper.
  double VelocityWeight = 0.1;
  /// The weight of the centres of the medial balls in the flow; between 0 and 1e3. With a greater
  /// weight, the skeleton is better centred and has more branches. 0.2 is the value of the paper.
  double MedialWeight = 0.2;
};

/**
 * Extracts the curve skeleton of the solid that a closed surface bounds (Tagliasacchi, Alhashim,
 * Olson and Zhang, "Mean curvature skeletons", 2012). The surface is remeshed evenly and contracted
 * by mean curvature flow, which the balls of the medial axis attract. What is left, almost without
 * volume, is collapsed to curves.
 *
 * The skeleton has the topology of the solid: one component for each component of the surface, and
 * as many independent cycles as its genus. Both are checked. Branches that end within the ball
 * around a point of another branch, or are shorter than three edges, are left out. The edges of a
 * branch are equally long, and about as long as the Resolution.
 *
 * The result depends on the positions of points and on which of them make triangles, but not on
 * their numbers: shuffled points and triangles give the same bits, unless points coincide.
 *
 * surface: closed and consistently oriented, of any number of components that do not touch. Throws
 * InvalidInput if it is not, if a component lies inside another (the skeleton of a hollow solid is
 * not a curve), or if an option is out of range; SolveFailure if the topology is not that of the
 * solid; Aborted.
 */
CurveSkeleton ExtractCurveSkeleton(
  const Surface& surface, const CurveSkeletonOptions& options = {}, const Progress& progress = {});

} // namespace shape
