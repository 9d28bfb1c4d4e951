#pragma once

#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/**
 * Adds links until the graph is connected. Each component without a node in `mainland` is linked to
 * the nearest node of another component. Such a component may be a part of a soup or a loose point.
 * Returns the original number of components.
 *
 * mainland: at least one node. Throws Aborted.
 */
int ConnectComponents(
  PointGraph& graph, const std::vector<int>& mainland, const Progress& progress = {});

} // namespace shape
