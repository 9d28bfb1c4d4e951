#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A surface after cutting it open along edges.
struct CutSurface
{
  Mesh Surface; ///< with the same triangles; the copies of points come after the original points
  shape::Provenance Provenance; ///< from the uncut surface
};

/// Cuts along the given edges. The cut divides the triangles around a point into parts. The part
/// with the triangle of lowest index keeps the point; each other part gets a copy. surface: an
/// oriented 2-manifold.
CutSurface CutAlongEdges(const Surface& surface, const std::vector<std::array<int, 2>>& edges);

/// A path along edges.
struct EdgePath
{
  std::vector<int> Points;
  std::vector<int> Stops; ///< for each stop, its index in Points
};

/**
 * Finds a path along edges through `stops`, in order. Each leg is the shortest path that meets
 * neither the previous legs nor another stop. If a stop cannot be reached in this way, the search
 * is repeated with legs that also avoid the neighbours of later stops.
 *
 * factors: points x legs, or empty: for each leg, the factor by which edges to a point are longer;
 * > 0.
 *
 * Throws InvalidInput if there is no such path because the mesh is too coarse; Aborted.
 */
EdgePath FindEdgePathThrough(const Surface& surface, const std::vector<int>& stops,
  const Progress& progress = {}, const Eigen::MatrixXd& factors = {});

} // namespace shape
