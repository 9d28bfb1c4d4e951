#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Inserts a layer of hexahedra under some quads of the boundary. The quads keep their points and
 * remain on the boundary. All other hexahedra get copies of these points at the same positions. A
 * hexahedron is inserted between each quad and its copy. Along the border of the quads, the sides
 * of the layer become boundary quads: (b, a, copy of a, copy of b) for each edge (a, b) that only
 * one of the quads has.
 *
 * mesh: hexahedra whose boundary is a manifold. quads: k x 4, counter-clockwise seen from outside.
 * Returns the copy of each original point, or -1 if it has none.
 */
std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads);

/**
 * Inserts a layer of hexahedra between some quads and the hexahedra of one side (PadQuads). The
 * other hexahedra keep the quads' points.
 *
 * rows: the hexahedra of this side. quads: faces of its boundary, counter-clockwise seen from
 * outside the side. regionOf: the region of each hexahedron of the mesh; a new one gets that of the
 * hexahedron at its quad. Returns the copy of each original point, or -1 if it has none.
 */
std::vector<int> PadSide(HexMesh& mesh, const std::vector<int>& rows, const Eigen::MatrixXi& quads,
  std::vector<int>& regionOf);

/**
 * Inserts a layer of hexahedra under some patches. At the border of the patches, the layer ends in
 * a row of quads, which belong to the adjacent patches. As a result, no quad there has two
 * consecutive edges on a curve. Each surface and each curve thus has sheets of its own, as Ledoux
 * and Shepherd require ("Topological and geometrical properties of hexahedral meshes", 2010). Each
 * new point has the position of the point that it copies.
 *
 * Updates PatchOf, Quads and Copies of `boundary`. Afterwards, the curves and corners of `boundary`
 * have to be found again (MatchCurves).
 */
void PillowPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary);

/// Inserts a layer of hexahedra under the whole boundary. The quads and points of the boundary stay
/// unchanged.
void PillowBoundary(HexMesh& mesh, PatchedBoundary& boundary);

/// Inserts layers of hexahedra inside the boundary of one side (PadSide). Only Quads and Copies of
/// `boundary` are used.
void PillowSide(HexMesh& mesh, std::vector<int> rows, int layers, PatchedBoundary& boundary,
  std::vector<int>& regionOf);

/// Distributes the copies of each boundary point evenly between the point and its deepest copy.
void SmoothPillows(const PatchedBoundary& boundary, Eigen::MatrixXd& points);

} // namespace shape
