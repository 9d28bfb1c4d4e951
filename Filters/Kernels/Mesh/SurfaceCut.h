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
  Mesh Surface;                 ///< the same triangles; copies of points come after all points
  shape::Provenance Provenance; ///< from the uncut surface
};

/// Cuts along the given edges: a point has a copy for each part that its triangles fall into; the
/// part with the first triangle keeps the point itself. surface: an oriented 2-manifold.
CutSurface CutAlongEdges(const Surface& surface, const std::vector<std::array<int, 2>>& edges);

/// A path along edges.
struct EdgePath
{
  std::vector<int> Points;
  std::vector<int> Stops; ///< places in Points of the points that it was to pass
};

/**
 * The path through `stops` in order, each leg the shortest along edges that meets neither the legs
 * before it nor another stop; where that leaves a stop out of reach, legs keep away from the points
 * beside stops to come.
 *
 * Throws InvalidInput where there is none: the mesh is too coarse there. Aborted.
 */
EdgePath FindEdgePathThrough(
  const Surface& surface, const std::vector<int>& stops, const Progress& progress = {});

} // namespace shape
