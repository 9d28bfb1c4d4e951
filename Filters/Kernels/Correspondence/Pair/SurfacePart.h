#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Whether one of two surfaces is a part of the other one, and how large it is there.
struct SurfacePart
{
  enum class WhichType
  {
    None = 0,     ///< both are whole, or it is not known
    SurfaceA = 1, ///< A is a part of B
    SurfaceB = 2  ///< B is a part of A
  };
  WhichType Which = WhichType::None;
  double Scale = 1.0; ///< lengths on B over those on A
  double Share = 1.0; ///< the part's area over the whole's at this scale; 1 if there is no part
};

/**
 * What landmarks say of that. Scale: the median over every two landmarks of their distance along B
 * over that along A. With it a surface is a part if it has a boundary and at most 85 % of the
 * other one's area, and the ratios agree so well that half of them differ less from their median
 * than the root of that share does from 1. With fewer than three landmarks, of two surfaces without
 * boundary or of several components none is a part, and the scale is the root of the areas' ratio.
 *
 * a, b: RequireWhole; landmarks: RequireLandmarks. Throws InvalidInput if all landmarks are one
 * point, SolveFailure, Aborted.
 */
SurfacePart FindPart(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

/// The same if it is known which one is a part; a, b: RequireConnected. Throws InvalidInput
/// if the part would have more area than the whole, or if no two landmarks tell the scale.
SurfacePart MeasurePart(const Surface& a, const Surface& b, const Landmarks& landmarks,
  SurfacePart::WhichType which, const Progress& progress = {});

} // namespace shape
