#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <vector>

namespace shape
{

/// A surface of fewer points, and where the points of the finer one are on it.
struct CoarseSurface
{
  shape::Surface Surface;
  std::vector<int> Points; ///< of the finer surface: those of the coarse one, in order
  SurfacePoints Positions; ///< n: of the finer surface's points on the coarse one
};

/**
 * Merges points into neighbours (half-edge collapses) until about `points` are left, nearly evenly
 * spread: first those whose neighbours get the shortest new edges. Merged points are kept on the
 * triangles that took the place of those around them (after Lee et al., "MAPS: multiresolution
 * adaptive parameterization of surfaces", 1998), each at the closest point of these few, so that
 * none lands on another sheet.
 *
 * Topology and boundary loops stay, and so do the points of `kept`; no merge turns a triangle that
 * is not slim by more than 60 degrees, or makes one slim and slimmer than it was. If that leaves no
 * point to merge, more than `points` are left.
 *
 * surface: a consistently oriented 2-manifold, open or closed, without unused points. points >= 4.
 * Throws InvalidInput, Aborted.
 */
CoarseSurface CoarsenSurface(const Surface& surface, int points, const std::vector<int>& kept = {},
  const Progress& progress = {});

/// Where points of the coarse surface are on the finer one: the nearest that a walk (TriangleWalk)
/// finds from the nearest of the finer points on the same triangle. Throws Aborted.
SurfacePoints LocateOnFinerSurface(const CoarseSurface& coarse, const Mesh& finer,
  const SurfacePoints& positions, const Progress& progress = {});

} // namespace shape
