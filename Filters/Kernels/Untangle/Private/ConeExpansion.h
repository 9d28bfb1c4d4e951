#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/ConeExpansionOptions.h"
#include "Untangle/Private/SolidCells.h"

namespace shape
{

/**
 * Makes inverted tetrahedra positive by exact tests, with inserted points where positions alone do
 * not suffice, in the manner of expansion cones (Nigolian, Campen and Bommes, "Expansion cones: a
 * progressive volumetric mapping framework" (2023)).
 *
 * The inner points of inverted tetrahedra form a cluster, which has to be at one position c that
 * sees the outer side of each tetrahedron with a single point in it. The points around the cluster
 * move to make space for that (ClusterCollapse). If they cannot, or if the cluster then cannot be
 * expanded, it grows until there is such a position. If the boundary is star-shaped, all inner
 * points are such a cluster. Tetrahedra with several points in the cluster then have no volume, and
 * all others around it are positive. The points leave the cluster one by one. A point may move from
 * c into the kernel of its star: the positions in which its tetrahedra, all other points of the
 * cluster at c, become or stay positive. If a kernel is empty, edges to the faces that the point
 * does not see are split at c, so that it remains visible from the others. Points that have left,
 * and c itself, move to the centres of their kernels, which makes space.
 *
 * Positions are doubles, and each is accepted by exact predicates only. A cluster that cannot be
 * expanded within the given limits is restored. Cells of other kinds do not change. Boundary points
 * do not move. Throws Aborted.
 */
ConeExpansionResult ExpandInverted(
  SolidCells& solid, const ConeExpansionOptions& options = {}, const Progress& progress = {});

} // namespace shape
