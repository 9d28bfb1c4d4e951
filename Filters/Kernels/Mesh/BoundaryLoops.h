#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// The boundary of a set of triangles.
struct BoundaryLoops
{
  /// The points of each closed loop in the direction of the triangles (the surface lies to the
  /// left); no loop contains a point twice. The longest comes first; loops of equal length are
  /// ordered by their first points. Each starts at its point of lowest index.
  std::vector<std::vector<int>> Loops;
  int UnclosedSides = 0; ///< boundary edges that belong to no closed loop
};

/**
 * Finds the boundary loops around the holes of any triangles, manifold or not. For manifolds, use
 * FindManifoldBoundaryLoops. An edge is on the boundary if no other triangle has an edge between
 * the same points or points at the same positions; a seam of duplicated points is therefore no
 * boundary.
 *
 * Where the boundary meets itself at a point (two holes share it), it continues along the same fan
 * of triangles and is split into loops that touch there; if these are filled, the result is a
 * manifold. If the points there are duplicated, a loop contains both, consecutively, so that the
 * fill uses the same indices. Triangles that use a point twice are ignored.
 *
 * Throws InvalidInput if an index is out of range.
 */
BoundaryLoops FindBoundaryLoops(const Mesh& surface);

} // namespace shape
