#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// How many open loops a surface may have.
enum class LoopCount
{
  One,
  AtLeastOne
};

/// Throws InvalidInput, with the remedy, unless `surface` can be laid out in the plane: a manifold
/// of one component without handles, with so many open loops, of which a triangle uses every point.
void RequireSurfaceWithBoundary(const Surface& surface, LoopCount loops);

/// The points of each open loop of a manifold as its triangles run through them, with the surface
/// to the left; the longest first, equally long ones in the order of their first points. Each
/// starts at its first point by number.
std::vector<std::vector<int>> FindManifoldBoundaryLoops(const Surface& surface);

/// The surface with a fan around a new point, the mean of the loop's points, in each of these
/// loops. The new points come last, in order.
Mesh FillWithFans(const Mesh& surface, const std::vector<std::vector<int>>& loops);

} // namespace shape
