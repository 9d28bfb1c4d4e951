#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Samples the points that are corners of triangles. Each sample is the point farthest from all
/// earlier samples (Moenning and Dodgson, "Fast marching farthest point sampling", 2003); here
/// distances are along edges. Returns `count` points, or all if there are fewer. The first sample
/// is `start`, or the point with the lowest index if `start` is -1. Every component gets one sample
/// before any component gets a second. surface: at least one triangle. Throws InvalidInput when
/// RequireIndices does, and Aborted.
std::vector<int> SampleFarthestPoints(
  const Surface& surface, int count, const Progress& progress = {}, int start = -1);

/// Returns the point of a triangle that is farthest from the centroid of the surface. It does not
/// depend on the numbers of the points: of equally far ones, it has the greatest coordinates.
int FindRemotestPoint(const Surface& surface);

} // namespace shape
