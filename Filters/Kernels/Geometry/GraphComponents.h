#pragma once

#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/**
 * Connects a graph. Components without a node in `mainland`, such as parts of a soup or loose
 * points, are linked to the nearest node of another component until all are connected. Returns the
 * original number of components.
 *
 * mainland: at least one node. Throws Aborted.
 */
int ConnectComponents(
  PointGraph& graph, const std::vector<int>& mainland, const Progress& progress = {});

} // namespace shape
