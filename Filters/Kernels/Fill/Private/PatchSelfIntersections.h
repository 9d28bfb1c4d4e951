#pragma once

#include "Base/Progress.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"

#include <limits>
#include <vector>

namespace shape
{

/**
 * The pairs of triangles of `surface` that intersect beyond the corners and the edge that they
 * share (FindSelfIntersections), of which Second is `first` or a later one. Coincident points count
 * as shared. Triangles without area are ignored. Only triangles near these are tested. It stops
 * soon after it has found `maximum` of them. Throws Aborted.
 */
std::vector<Crossing> FindPatchSelfIntersections(const Mesh& surface, int first,
  const Progress& progress = {}, int maximum = std::numeric_limits<int>::max());

} // namespace shape
