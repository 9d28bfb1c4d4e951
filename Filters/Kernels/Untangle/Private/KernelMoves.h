#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"

namespace shape
{

/// Moves inner points of inverted tetrahedra one by one to the centres of the kernels of their
/// stars (FindKernelCentre), if exact tests find fewer inverted tetrahedra there. If that makes no
/// progress, points around them move to the centres of their kernels, in a growing neighbourhood,
/// which makes space. Returns the number of inverted tetrahedra, which does not grow. The work is
/// bounded by a number of moves. All cells have to be tetrahedra. Throws Aborted.
int MoveIntoKernels(SolidCells& solid, const Progress& progress);

} // namespace shape
