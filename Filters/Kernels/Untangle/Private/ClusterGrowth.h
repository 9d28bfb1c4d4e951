#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/PointCluster.h"

namespace shape
{

/**
 * Enlarges a cluster until one position sees all faces opposite to a single point of it, and the
 * cluster is a ball. Its points then move to that position.
 *
 * Movable points of faces that the best position does not see are added. Where there are none, an
 * edge or a face is split, and the new point is added. Holes around a single edge are closed. After
 * some steps, whole rings of points are added, which bounds the number of steps.
 *
 * Returns false if no position is found and there is nothing to add; points may then have been
 * added, but none has moved. Throws Aborted.
 */
bool GrowCluster(PointCluster& cluster, const Progress& progress);

/// Adds the movable points around a cluster.
void AddRing(PointCluster& cluster);

} // namespace shape
