#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <array>
#include <vector>

namespace shape
{

/// A surface that was cut open along edges.
struct CutSurface
{
  Mesh Surface;                 ///< the same triangles; copied points come after the original ones
  shape::Provenance Provenance; ///< from the uncut surface
};

/// Cuts along the given edges. A point is copied for each further part into which the cut divides
/// its triangles; the part with the first triangle keeps the original. surface: an oriented
/// 2-manifold.
CutSurface CutAlongEdges(const Surface& surface, const std::vector<std::array<int, 2>>& edges);

/// A path along edges.
struct EdgePath
{
  std::vector<int> Points;
  std::vector<int> Stops; ///< the indices in Points of the stops
};

/**
 * Finds the path through `stops` in order. Each leg is the shortest along edges that meets neither
 * the previous legs nor another stop. If that makes a stop unreachable, legs also avoid the
 * neighbours of later stops.
 *
 * Throws InvalidInput if there is no such path because the mesh is too coarse; Aborted.
 */
EdgePath FindEdgePathThrough(
  const Surface& surface, const std::vector<int>& stops, const Progress& progress = {});

} // namespace shape
