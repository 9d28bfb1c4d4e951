#pragma once

#include "Base/Progress.h"
#include "Solids/IsoSurface.h"

#include <functional>
#include <vector>

namespace shape
{

/// Returns the points of a grid that a flood reaches along edges: 1 or 0 for each point. starts:
/// where it begins. passes: whether it goes from a point to a neighbour. Throws Aborted.
std::vector<char> FloodGrid(const SampledGrid& grid, const std::vector<int>& starts,
  const std::function<bool(int from, int to)>& passes, const Progress& progress);

/// Returns the distance of each point of a grid from the nearest point of a set, in the model's
/// units (Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", 2012).
/// isInSet: 1 or 0 for each point; not all are 0. Throws Aborted.
std::vector<float> ComputeGridDistances(
  const SampledGrid& grid, const std::vector<char>& isInSet, const Progress& progress);

} // namespace shape
