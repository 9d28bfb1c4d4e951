#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Repairs the flipped triangles of a planar image of a surface. The points around these triangles
 * become mean value combinations of their neighbours (SolveConvexCombination). If that does not
 * suffice, further rings of neighbours move as well. Connected points move together, and only if
 * all triangles around them are counter-clockwise afterwards. Points on the boundary, or on an edge
 * with more than two triangles, are fixed.
 *
 * surface: manifold or not. positions: n x 2, changed in place. leftOut: triangles to ignore.
 * Returns the number of triangles repaired. Triangles that have no area on the surface are ignored,
 * too. Throws Aborted.
 */
int RepairFlips(const Mesh& surface, Eigen::MatrixXd& positions,
  const std::vector<int>& leftOut = {}, const Progress& progress = {});

} // namespace shape
