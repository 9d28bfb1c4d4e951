#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The boundary of a set of triangles.
struct BoundaryLoops
{
  /// The points of each closed loop, without repeats, in the direction of the triangles (the
  /// surface lies to the left). Each loop starts at its point of lowest index. The longest loop
  /// comes first; loops of equal length are ordered by their first points.
  std::vector<std::vector<int>> Loops;
  int UnclosedSides = 0; ///< number of boundary edges that belong to no closed loop
};

/**
 * Finds the boundary loops of any triangles, manifold or not. For manifolds, use
 * FindManifoldBoundaryLoops. An edge is on the boundary if no other triangle has an edge between
 * the same two positions. A seam of duplicated points is therefore no boundary.
 *
 * Two holes may share a point. At this point, the boundary continues along the same fan of
 * triangles, and is split into loops that touch at the point; filling them makes a manifold. If the
 * point is duplicated, a loop contains both copies, consecutively, so that the fill uses the same
 * indices. Triangles that use a point twice are ignored.
 *
 * Throws InvalidInput if an index is out of range.
 */
BoundaryLoops FindBoundaryLoops(const Mesh& surface);

/// The allowed number of open boundary loops of a surface.
enum class LoopCount
{
  One,
  AtLeastOne
};

/// Throws InvalidInput, with the remedy, unless `surface` can be flattened. It must be a manifold
/// of one component without handles, with the given number of open boundary loops. Every point must
/// belong to a triangle.
void RequireSurfaceWithBoundary(const Surface& surface, LoopCount loops);

/// Returns the points of each open boundary loop of a manifold, in the direction of its triangles
/// (the surface lies to the left). The longest loop comes first; loops of equal length are ordered
/// by their first points. Each loop starts at its point of lowest index.
std::vector<std::vector<int>> FindManifoldBoundaryLoops(const Surface& surface);

/// Closes each of the given loops by a fan of triangles around a new point at the mean of the
/// loop's points. The new points come last, in the order of the loops.
Mesh FillWithFans(const Mesh& surface, const std::vector<std::vector<int>>& loops);

} // namespace shape
