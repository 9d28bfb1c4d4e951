#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/**
 * Refines marked triangles of a manifold surface, open or closed, by bisecting longest edges, and
 * as many around them as it takes for no point to lie inside an edge (Rivara, "Algorithms for
 * refining triangular grids suitable for adaptive and multigrid techniques", 1984). Slim triangles
 * become rounder; the surface and its orientation stay.
 *
 * marked (m): which triangles are to have all their edges halved. New points follow the old ones in
 * `surface`. Returns for each of them the ends of the edge that it halves (k x 2).
 */
Eigen::MatrixXi BisectLongestEdges(Mesh& surface, const std::vector<char>& marked);

} // namespace shape
