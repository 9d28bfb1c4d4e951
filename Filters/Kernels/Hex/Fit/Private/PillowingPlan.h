#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/**
 * Which patches get a layer of hexahedra together (PillowPatches), one set after the other, such
 * that no quad has two edges in a row on a curve.
 *
 * A layer that ends at a corner moves the patches without it to a copy of the corner's point, all
 * but those two next to it: so the patches of a set follow one another around a corner, and leave
 * out at most two, or the corner is not among them. Of three patches any set does; where more meet,
 * one patch alone does not, and neighbours are added to it.
 *
 * The last sets are groups that have each patch once: those on either side of a crease that is not
 * convex, which has two hexahedra then; where the angle of one patch at a corner is so wide that it
 * needs two quads, the other patches; and those that corners ask for, across the flattest creases.
 * At creases between groups there is one hexahedron. The sets before are for creases inside groups.
 */
std::vector<std::vector<int>> PlanLayers(
  const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary);

} // namespace shape
