#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// Two triangles that have more in common than the corners and the edge they share.
struct Crossing
{
  int First = -1;              ///< a triangle
  int Second = -1;             ///< a later triangle
  Eigen::RowVector3d Position; ///< the middle of what their boxes have in common
};

/**
 * Whether two triangles have more in common than the corners and the edge they share, by exact
 * orientations (Geometry/Orientation.h). Points are shared by index. A flat triangle that shares no
 * point counts as its edges, and does not meet another flat one.
 */
bool DoTrianglesIntersect(const Mesh& mesh, int first, int second);

/// The triangles whose corners lie on one line, in order. Exact.
std::vector<int> FindDegenerateTriangles(const Mesh& mesh);

/**
 * Every pair of triangles of a surface that cross, touch, overlap or coincide beyond the corners
 * and the edge they share, in the order of First, then Second.
 *
 * A hierarchy of boxes (GetTriangleBoxes) finds the candidates, exact orientations
 * (Geometry/Orientation.h) decide: a pair is listed if and only if the triangles meet. Points are
 * shared by index: join points at the same position first. surface: any triangles, none of them in
 * FindDegenerateTriangles. Throws Aborted.
 */
std::vector<Crossing> FindSelfIntersections(const Surface& surface, const Progress& progress = {});

/// The same of pairs whose second triangle is `first` or a later one. It stops soon after it has
/// found `maximum` of them.
std::vector<Crossing> FindSelfIntersectionsFrom(
  const Surface& surface, int first, int maximum, const Progress& progress = {});

} // namespace shape
