#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"
#include "Untangle/Untangle.h"

namespace shape
{

/// Finds out why cells stay inverted in a fixed boundary: whether it crosses itself, and which
/// triangles are hidden from the best position inside. Sets these members of the result. Triangles
/// without an area do not count. Throws Aborted.
void FindBoundaryFaults(const SolidCells& solid, UntangleResult& result, const Progress& progress);

} // namespace shape
