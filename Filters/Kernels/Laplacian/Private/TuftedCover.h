#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// An oriented, closed 2-manifold of triangles that are glued along edges.
struct GluedTriangles
{
  Eigen::MatrixXi Triangles; ///< indices of points
  std::vector<int> Twins;    ///< the half-edge that half-edge 3 t + k is glued to
};

/**
 * Builds the tufted cover of any triangles (Sharp and Crane, "A Laplacian for nonmanifold triangle
 * meshes", 2020, section 4.2). Each triangle t has two copies: t, and m + t with the opposite
 * orientation. Around an edge, the side of a copy that faces the next triangle is glued to the side
 * of that triangle that faces back. So each edge with k triangles becomes k edges, and those of the
 * boundary join the two copies of a triangle. The points stay the same.
 *
 * mesh: m triangles with three different points each.
 */
GluedTriangles BuildTuftedCover(const Mesh& mesh);

/// Whether every edge has at most two triangles, with opposite directions, so that no cover is
/// needed. sorted: the half-edges (SortHalfEdges).
bool AreEdgesManifold(const std::vector<HalfEdge>& sorted);

} // namespace shape
