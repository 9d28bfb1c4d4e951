#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Repairs the flipped triangles of a planar image of a surface: the points around them become
 * mean value combinations of their neighbours (see SolveConvexCombination), in rings that grow
 * if that does not suffice; a group of points moves only if all triangles around it then are
 * counter-clockwise. Points on the boundary stay.
 *
 * surface: of any connectivity. positions: n x 2. leftOut: triangles that are ignored. Returns the
 * number of triangles that were flipped and no longer are; those without area do not count. Throws
 * Aborted.
 */
int RepairFlips(const Mesh& surface, Eigen::MatrixXd& positions,
  const std::vector<int>& leftOut = {}, const Progress& progress = {});

} // namespace shape
