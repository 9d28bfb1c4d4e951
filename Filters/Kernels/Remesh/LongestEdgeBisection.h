#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/**
 * Refines marked triangles of a manifold surface, open or closed, by bisecting longest edges. Other
 * triangles are bisected as needed, so that no point lies inside an edge (Rivara, "Algorithms for
 * refining triangular grids suitable for adaptive and multigrid techniques", 1984). Slivers become
 * better shaped; the shape of the surface and its orientation do not change.
 *
 * marked (m): the triangles of which every edge is to be bisected. New points are appended to those
 * of `surface`. Returns the ends of the edge that each of them bisects (k x 2).
 */
Eigen::MatrixXi BisectLongestEdges(Mesh& surface, const std::vector<char>& marked);

} // namespace shape
