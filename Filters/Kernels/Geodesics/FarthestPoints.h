#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Points that triangles use, each the farthest along edges from those before it (Moenning and
/// Dodgson, "Fast marching farthest point sampling", 2003, on edges): `count` of them, or all if
/// there are fewer. The first is the point of lowest number; each component has one before
/// distances within it count. surface: at least one triangle. Throws InvalidInput as
/// RequireIndices, Aborted.
std::vector<int> SampleFarthestPoints(
  const Surface& surface, int count, const Progress& progress = {});

} // namespace shape
