#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Repairs the flipped triangles of a planar image of a surface. The points around them become mean
 * value combinations of their neighbours (SolveConvexCombination). If that does not suffice, rings
 * of neighbours are added. A group of points moves only if all triangles around it are then
 * counter-clockwise. Boundary points are fixed.
 *
 * surface: of any connectivity. positions: n x 2. leftOut: triangles to ignore. Returns the number
 * of triangles that were flipped and no longer are; triangles without area are not counted. Throws
 * Aborted.
 */
int RepairFlips(const Mesh& surface, Eigen::MatrixXd& positions,
  const std::vector<int>& leftOut = {}, const Progress& progress = {});

} // namespace shape
