#pragma once

#include "Base/Progress.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"

#include <limits>
#include <vector>

namespace shape
{

/**
 * Where the triangles of `surface` from `first` on meet each other or those before them beyond the
 * corners and the edge that they share (FindSelfIntersections): pairs of the surface's triangles,
 * of which Second is one of these. Points at the same place count as shared. Triangles without area
 * count as if they were not there. Only triangles near them are looked at. It stops soon after it
 * has found `most` of them. Throws Aborted.
 */
std::vector<Crossing> FindPatchSelfIntersections(const Mesh& surface, int first,
  const Progress& progress = {}, int maximum = std::numeric_limits<int>::max());

} // namespace shape
