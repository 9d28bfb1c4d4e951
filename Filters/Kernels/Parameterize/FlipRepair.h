#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Turns the flipped triangles of a planar image of a surface back: the points around them become
 * mean value combinations of their neighbours (see SolveConvexCombination), in rings that grow
 * where that does not suffice; a group of points moves only where all triangles around it then are
 * counter-clockwise. Points on the rim stay.
 *
 * surface: may hang together in any way. places: n x 2. leftOut: triangles that are as if they were
 * not there. Returns how many triangles were flipped and are not any more; those without area count
 * as neither. Throws Aborted.
 */
int RepairFlips(const Mesh& surface, Eigen::MatrixXd& positions,
  const std::vector<int>& leftOut = {}, const Progress& progress = {});

} // namespace shape
