#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A layer of hexahedra under some quads of the boundary. The quads and their points stay where they
 * are and remain the boundary's; the hexahedra that had them get copies of the points, at the
 * same positions, and each quad a hexahedron between it and its copy. Where the quads end, the
 * sides of the layer become quads of the boundary: (a, b, copy of b, copy of a) for each edge a b
 * of a quad that has no other of them beside it.
 *
 * mesh: its boundary is a manifold. quads: k x 4, counter-clockwise seen from outside. Returns for
 * each point that was there its copy, or -1.
 */
std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads);

/**
 * A layer of hexahedra under some patches. It ends where they end, with a row of quads in the
 * patches beyond: then no quad there has two edges in a row on a curve (each surface and each curve
 * has sheets of its own, as in Ledoux and Shepherd, "Topological and geometrical properties of
 * hexahedral meshes", 2010). New points lie where those they are copies of do.
 *
 * PatchOf and Quads change; curves and corners have to be found anew.
 */
void PillowPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary);

/// A layer of hexahedra under the whole boundary, whose quads and points stay.
void PillowBoundary(HexMesh& mesh, PatchedBoundary& boundary);

/// Puts the copies under each point of the boundary evenly between the lowest of them and the
/// point.
void SmoothPillows(const PatchedBoundary& boundary, Eigen::MatrixXd& points);

} // namespace shape
