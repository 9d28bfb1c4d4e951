#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Which of two surfaces, if any, is a part of the other one, and the part's share of the other
/// surface's area.
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
 * Decides from landmarks whether one surface is a part of the other one. Every two landmarks give a
 * ratio: their distance along B divided by their distance along A. The scale is the median of these
 * ratios. At this scale, a surface is a part if all of these are true:
 *
 * - it has a boundary;
 * - it has less than 85 % of the other one's area;
 * - half of the ratios, divided by the scale, are nearer to 1 than the root of (its area / the
 *   other one's).
 *
 * If there are fewer than three landmarks, no boundaries or several components, neither surface is
 * a part. If neither is a part, the scale is the root of (B's area / A's area).
 *
 * a, b: surfaces that RequireWhole accepts. landmarks: pairs that RequireLandmarks accepts. Throws
 * InvalidInput if landmarks are needed but no two of them are distinct points on both surfaces;
 * SolveFailure; Aborted.
 */
SurfacePart FindPart(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

/// Computes the scale and the share if it is known which surface is the part. a, b: surfaces that
/// RequireConnected accepts. Throws InvalidInput if the part would have more area than the other
/// surface, or if no two landmarks are distinct points on both surfaces; SolveFailure; Aborted.
SurfacePart MeasurePart(const Surface& a, const Surface& b, const Landmarks& landmarks,
  SurfacePart::WhichType which, const Progress& progress = {});

} // namespace shape
