#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Which of two surfaces, if any, is a part of the other one, and how large it is there.
struct SurfacePart
{
  enum class WhichType
  {
    None = 0,     ///< both are complete, or it is not known
    SurfaceA = 1, ///< A is a part of B
    SurfaceB = 2  ///< B is a part of A
  };
  WhichType Which = WhichType::None;
  double Scale = 1.0; ///< lengths on B divided by those on A
  /// The part's area divided by the other one's, at this scale; 1 if there is no part.
  double Share = 1.0;
};

/**
 * Decides from landmarks whether one surface is a part of the other one. For every two landmarks,
 * their distance along B divided by that along A is a ratio; the scale is the median ratio. At this
 * scale, a surface is a part if all of these are true:
 *
 * - it has a boundary;
 * - it has at most 85 % of the other one's area;
 * - half of the ratios differ less from their median than the root of that share differs from 1.
 *
 * With fewer than three landmarks, without boundaries or with several components, neither surface
 * is a part, and the scale is the root of the areas' ratio.
 *
 * a, b: RequireWhole; landmarks: RequireLandmarks. Throws InvalidInput if all landmarks are one
 * point, SolveFailure, Aborted.
 */
SurfacePart FindPart(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

/// Computes the scale and the share if it is known which surface is the part; a, b:
/// RequireConnected. Throws InvalidInput if the part would have more area than the other surface,
/// or if no two landmarks determine the scale.
SurfacePart MeasurePart(const Surface& a, const Surface& b, const Landmarks& landmarks,
  SurfacePart::WhichType which, const Progress& progress = {});

} // namespace shape
