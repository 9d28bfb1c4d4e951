#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Samples points that triangles use. Each is the farthest along edges from those before it
/// (Moenning and Dodgson, "Fast marching farthest point sampling", 2003, here along edges). Returns
/// `count` points, or all if there are fewer. The first is the point with the lowest number. Each
/// component gets one point before distances within components decide. surface: at least one
/// triangle. Throws InvalidInput as RequireIndices, and Aborted.
std::vector<int> SampleFarthestPoints(
  const Surface& surface, int count, const Progress& progress = {});

} // namespace shape
