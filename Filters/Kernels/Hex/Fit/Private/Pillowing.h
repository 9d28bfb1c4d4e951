#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Inserts a layer of hexahedra under some quads of the boundary. The quads keep their points and
 * remain on the boundary. The hexahedra below them use copies of these points at the same
 * positions, and each quad gets a hexahedron between it and its copy. At the border of the quads
 * the sides of the layer become boundary quads: (a, b, copy of b, copy of a) for each edge a b that
 * belongs to only one of the quads.
 *
 * mesh: its boundary is a manifold. quads: k x 4, counter-clockwise seen from outside. Returns, for
 * each original point, the index of its copy, or -1.
 */
std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads);

/**
 * Inserts a layer of hexahedra under some patches. At their border it ends in a row of quads that
 * belong to the adjacent patches; no quad there then has two consecutive edges on a curve. Each
 * surface and each curve thus has sheets of its own, as in Ledoux and Shepherd, "Topological and
 * geometrical properties of hexahedral meshes", 2010. New points lie at the points they copy.
 *
 * Changes PatchOf and Quads; curves and corners have to be found again.
 */
void PillowPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary);

/// Inserts a layer of hexahedra under the whole boundary, whose quads and points stay unchanged.
void PillowBoundary(HexMesh& mesh, PatchedBoundary& boundary);

/// Distributes the copies under each point of the boundary evenly between the point and the deepest
/// copy.
void SmoothPillows(const PatchedBoundary& boundary, Eigen::MatrixXd& points);

} // namespace shape
