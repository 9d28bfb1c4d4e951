#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Samples the points that are corners of triangles. Each sample is the point farthest from all
/// earlier samples (Moenning and Dodgson, "Fast marching farthest point sampling", 2003); here
/// distances are along edges. Returns `count` points, or all if there are fewer. The first sample
/// is the point with the lowest index. Every component gets one sample before any component gets a
/// second. surface: at least one triangle. Throws InvalidInput when RequireIndices does, and
/// Aborted.
std::vector<int> SampleFarthestPoints(
  const Surface& surface, int count, const Progress& progress = {});

} // namespace shape
