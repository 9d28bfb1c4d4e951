#pragma once

#include "Base/Progress.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"

#include <limits>
#include <vector>

namespace shape
{

/**
 * Finds the pairs of triangles of `surface` that intersect beyond their common corners and edge
 * (FindSelfIntersections), and whose Second is at least `first`, the patch's first triangle.
 * Coincident points count as one. Triangles without area are ignored. Only triangles near those
 * from `first` on are tested. The search stops soon after it has found `maximum` pairs. Throws
 * Aborted.
 */
std::vector<Crossing> FindPatchSelfIntersections(const Mesh& surface, int first,
  const Progress& progress = {}, int maximum = std::numeric_limits<int>::max());

} // namespace shape
