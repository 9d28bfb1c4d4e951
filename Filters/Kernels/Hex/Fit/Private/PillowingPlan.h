#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/**
 * Plans the sets of patches that get a layer of hexahedra together (PillowPatches), in order, such
 * that no quad has two consecutive edges on a curve.
 *
 * A layer that ends at a corner moves all patches outside the set, except the two next to it, to a
 * copy of the corner's point. Therefore the patches of a set are consecutive around a corner and
 * leave out at most two, or the set does not contain the corner. At a corner of three patches any
 * set is valid. If more meet there, a single patch is not, and neighbours are added to it.
 *
 * The last sets are groups that partition the patches. A group unites the patches on both sides of
 * a crease that is not convex; the crease then has two hexahedra. If one patch needs two quads at a
 * corner because of its wide angle, the other patches there are united. Where a group is not valid
 * at a corner, it is united with a neighbour across the flattest crease. A crease between groups
 * has one hexahedron. The earlier sets handle creases inside groups.
 */
std::vector<std::vector<int>> PlanLayers(
  const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary);

} // namespace shape
