#pragma once

#include "Untangle/Private/PointCluster.h"

#include <Eigen/Core>

#include <optional>

namespace shape
{

/**
 * Enlarges a cluster until one position sees all faces opposite to a single point of it, and the
 * cluster is a ball. Returns that position, to which its points can move.
 *
 * Movable points of faces that the best position does not see are added. Where there are none, an
 * edge or a face is split, and the new point is added. Holes around a single edge are closed. After
 * some steps, whole rings of points are added, which bounds the number of steps.
 *
 * Returns none if no position is found and there is nothing to add. Throws Aborted and WorkSpent.
 */
std::optional<Eigen::RowVector3d> GrowCluster(PointCluster& cluster);

/// Adds the movable points around a cluster.
void AddRing(PointCluster& cluster);

} // namespace shape
