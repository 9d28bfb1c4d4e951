#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <vector>

namespace shape
{

/// A coarser version of a surface, and the positions of the finer surface's points on it.
struct CoarseSurface
{
  shape::Surface Surface;
  std::vector<int> Points; ///< for each point of the coarse surface: its index in the finer one
  SurfacePoints Positions; ///< n: the positions of the finer surface's points on the coarse one
};

/**
 * Merges points into neighbours (half-edge collapses) until `points` points are left, nearly evenly
 * spread. Merges that create the shortest new edges come first.
 *
 * Each merge replaces the triangles around the merged point by new ones. The merged point is then
 * located at the closest position on the new triangles (after Lee et al., "MAPS: multiresolution
 * adaptive parameterization of surfaces", 1998). Only these triangles are searched, so no point
 * moves to another sheet.
 *
 * The topology, the boundary loops and the points in `kept` are preserved. A merge must not rotate
 * a triangle by more than 60 degrees, unless it is a sliver, and must not create or worsen slivers.
 * If no further merge is possible, more than `points` points are left.
 *
 * surface: a consistently oriented 2-manifold, open or closed, without unused points. points: the
 * wanted number of points, >= 4. kept: points that must not be merged. Throws InvalidInput if an
 * argument is not as described; Aborted.
 */
CoarseSurface CoarsenSurface(const Surface& surface, int points, const std::vector<int>& kept = {},
  const Progress& progress = {});

/// Maps positions on the coarse surface to nearby positions on the finer one. A walk over the
/// finer triangles (TriangleWalk) searches for the closest position. It starts at the nearest of
/// the finer points that lie on the same coarse triangle. Throws Aborted.
SurfacePoints LocateOnFinerSurface(const CoarseSurface& coarse, const Mesh& finer,
  const SurfacePoints& positions, const Progress& progress = {});

} // namespace shape
