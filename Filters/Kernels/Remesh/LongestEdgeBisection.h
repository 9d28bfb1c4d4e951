#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/**
 * Refines marked triangles of a manifold surface, open or closed, by bisecting longest edges
 * (Rivara, "Algorithms for refining triangular grids suitable for adaptive and multigrid
 * techniques", 1984). Other triangles are bisected as needed, so that no point lies inside an edge.
 * Slivers become better shaped. The shape of the surface and its orientation do not change.
 *
 * marked: for each triangle, whether all its edges are bisected. New points are appended to the
 * points of `surface`. Returns, for each new point, the two ends of the edge that it bisects (k x
 * 2).
 */
Eigen::MatrixXi BisectLongestEdges(Mesh& surface, const std::vector<char>& marked);

} // namespace shape
