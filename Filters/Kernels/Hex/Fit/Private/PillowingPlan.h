#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/**
 * Plans the layers of hexahedra that are inserted one after another (PillowPatches), so that no
 * quad has two consecutive edges on a curve. Returns the set of patches that each layer lies under.
 *
 * If a layer ends at a corner, the patches outside the set move to a copy of the corner's point,
 * except the two patches next to the set. A set is therefore valid at a corner if it has no patch
 * there. It is also valid if its patches there are consecutive and leave out at most two patches of
 * the corner. At a corner of three patches every set is valid. At a corner of four or more patches,
 * a set with a single one of them is not valid, so neighbours are added to it.
 *
 * The last sets are groups that partition the patches. The patches on both sides of a crease that
 * is not convex belong to one group, and two hexahedra then meet at each edge of the crease. An
 * edge of a crease between two groups has one hexahedron. If a patch needs two quads at a corner
 * because of its wide angle there, the other patches at the corner are united. A group that is not
 * valid at a corner is united with a neighbour across the flattest crease. The earlier sets handle
 * creases inside groups.
 */
std::vector<std::vector<int>> PlanLayers(
  const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary);

} // namespace shape
