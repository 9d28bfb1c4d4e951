#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The allowed number of open boundary loops of a surface.
enum class LoopCount
{
  One,
  AtLeastOne
};

/// Throws InvalidInput, with the remedy, unless `surface` can be flattened: it must be a manifold
/// of one component without handles, with the given number of open boundary loops. A triangle must
/// use every point.
void RequireSurfaceWithBoundary(const Surface& surface, LoopCount loops);

/// Returns the points of each open boundary loop of a manifold, in the direction of its triangles
/// (the surface lies to the left). The longest loop comes first; loops of equal length are ordered
/// by their first points. Each loop starts at its point of lowest index.
std::vector<std::vector<int>> FindManifoldBoundaryLoops(const Surface& surface);

/// Closes each of the given loops by a fan of triangles around a new point, the mean of the loop's
/// points. The new points come last, in the order of the loops.
Mesh FillWithFans(const Mesh& surface, const std::vector<std::vector<int>>& loops);

} // namespace shape
