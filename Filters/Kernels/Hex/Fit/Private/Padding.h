#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A layer of hexahedra under some quads of the boundary. The quads and their points stay where they
 * are and remain the boundary's; the hexahedra that had them get copies of the points, in the same
 * place, and each quad a hexahedron between it and its copy. Where the quads have a border, the
 * layer's sides become quads of the boundary: (a, b, copy of b, copy of a) for each edge a b of a
 * quad that has no other of them beside it.
 *
 * mesh: its boundary is a manifold. quads: k x 4, counter-clockwise seen from outside. Returns for
 * each point that was there its copy, or -1.
 */
std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads);

} // namespace shape
