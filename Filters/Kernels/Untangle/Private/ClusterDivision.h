#pragma once

#include "Untangle/Private/PointCluster.h"

#include <vector>

namespace shape
{

/// A part of a cluster that can move as one, and where.
struct ClusterDivision
{
  std::vector<int> Part;
  StarPlacement Placement; ///< not valid if there is no such part
};

/**
 * Finds a part of a cluster, of at most half its points, that can move as one, so that it and the
 * rest stay connected and without holes. A part grows from each point by points of the cluster at
 * the faces that it does not see. The first part with much space is returned, else the one with the
 * most. The cluster does not change. Throws Aborted.
 */
ClusterDivision FindDivision(PointCluster& cluster);

} // namespace shape
