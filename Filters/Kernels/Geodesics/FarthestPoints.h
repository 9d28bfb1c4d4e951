#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// Points that triangles use, each the farthest along edges from those before it (Moenning and
/// Dodgson, "Fast marching farthest point sampling", 2003, on edges): `count` of them, or all where
/// there are fewer. The first is the first that a triangle uses; each component has one before
/// distances within it count. mesh: at least one triangle. Throws Aborted.
std::vector<int> SampleFarthestPoints(const Mesh& mesh, int count, const Progress& progress = {});

} // namespace shape
