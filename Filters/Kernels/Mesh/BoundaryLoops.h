#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The border of a set of triangles.
struct BoundaryLoops
{
  /// The points of each closed loop as the triangles run through them, with the surface to the
  /// left; no loop has a point twice. The longest first, equally long ones in the order of their
  /// first points; each starts at its first point by number.
  std::vector<std::vector<int>> Loops;
  int UnclosedSides = 0; ///< sides of triangles on the border that are part of no closed loop
};

/**
 * The loops of border around the holes of any triangles, manifold or not: FindManifoldBoundaryLoops
 * for surfaces of which nothing is known. A side is on the border where no other triangle has the
 * edge, nor one between points at the same places: a seam whose points are doubled is no border.
 * Where the border meets itself at a point (two holes that share it) it goes on along the same fan
 * of triangles, and is split there into loops that touch: filled, they leave a manifold. Where the
 * points there are doubled, both are in the loop, one after the other, so that the fills match
 * theirs by number. Triangles with a point twice count as if they were not there.
 *
 * Throws InvalidInput where an index is out of range.
 */
BoundaryLoops FindBoundaryLoops(const Mesh& surface);

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
