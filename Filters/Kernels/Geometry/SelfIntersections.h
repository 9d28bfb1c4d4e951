#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Two triangles that intersect beyond their shared corners and edge.
struct Crossing
{
  int First = -1;              ///< a triangle
  int Second = -1;             ///< a later triangle
  Eigen::RowVector3d Position; ///< the centre of the intersection of their bounding boxes
};

/**
 * Whether two triangles intersect beyond their shared corners and edge, decided by exact
 * orientations (Geometry/Orientation.h). Two triangles share a corner if both use the same point
 * index. A degenerate triangle that shares no corner with the other triangle is replaced by its
 * edges. It never intersects another degenerate triangle.
 */
bool DoTrianglesIntersect(const Mesh& mesh, int first, int second);

/// Returns the triangles with collinear corners, ascending. Exact.
std::vector<int> FindDegenerateTriangles(const Mesh& mesh);

/**
 * Finds all pairs of triangles of a surface that cross, touch, overlap or coincide beyond their
 * shared corners and edge. The pairs are sorted by First, then by Second.
 *
 * A hierarchy of boxes (GetTriangleBoxes) finds the candidates, and exact orientations
 * (Geometry/Orientation.h) decide: a pair is listed if and only if the triangles intersect.
 * Triangles share a corner only if both use the same point index, so coincident points must be
 * joined first. surface: any triangles except degenerate ones (FindDegenerateTriangles). Throws
 * Aborted.
 */
std::vector<Crossing> FindSelfIntersections(const Surface& surface, const Progress& progress = {});

/// The same, but only for pairs with Second >= `first`. Stops soon after `maximum` pairs are found.
std::vector<Crossing> FindSelfIntersectionsFrom(
  const Surface& surface, int first, int maximum, const Progress& progress = {});

} // namespace shape
